//! T's tippe top: a truncated sphere (3.3, 6.2).

use std::f64::consts::PI;

/// T's truncated sphere (3.3): density, radius and height of the missing cap.
const DENSITY: f64 = 700.0;
pub(super) const RADIUS: f64 = 0.02;
const CUT: f64 = 0.015;
pub(super) const MASS: f64 =
    PI * DENSITY * (4.0 / 3.0 * RADIUS * RADIUS * RADIUS - CUT * CUT * (RADIUS - CUT / 3.0));
pub(super) const ALPHA: f64 = 3.0 * CUT * CUT / (4.0 * RADIUS * (RADIUS + CUT));
const REST: f64 = 2.0 * RADIUS - CUT;
pub(super) const I3: f64 = PI / 30.0
    * DENSITY
    * (REST * REST * REST)
    * (2.0 * RADIUS * RADIUS + 3.0 * CUT * RADIUS + 3.0 * CUT * CUT);
/// The integral of z^2 dm, z measured from C.
const ALONG: f64 = PI / 15.0
    * DENSITY
    * (REST * REST)
    * (RADIUS * RADIUS * RADIUS + CUT * RADIUS * RADIUS - 3.0 * CUT * CUT * RADIUS + 3.0 * CUT * CUT * CUT);
pub(super) const I1: f64 = I3 / 2.0 + ALONG - MASS * (RADIUS * ALPHA) * (RADIUS * ALPHA);
