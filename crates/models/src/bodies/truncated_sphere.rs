//! Truncated sphere: a cap of height `cut` is missing on top. Drawn about the centre of the sphere (T, section 3.3).
//!
//!     m = pi rho (4/3 R^3 - h^2 (R - h/3))     GC = R alpha a     alpha = 3 h^2 / (4 R (R + h))
//!     I3 = pi/30 rho (2R - h)^3 (2R^2 + 3hR + 3h^2)
//!     I1 = I3/2 + pi/15 rho (2R - h)^2 (R^3 + hR^2 - 3h^2R + 3h^3) - m R^2 alpha^2

use super::names::{Size, length};
use super::{BodyCard, Solid, Surface};
use std::f64::consts::PI;

pub(super) const TRUNCATED_SPHERE: BodyCard = BodyCard {
    id: "truncated_sphere",
    title: ("Truncated sphere", "Sphère tronquée"),
    source: "T, section 3.3",
    sizes: &[
        length("radius", "radius of the sphere", "rayon de la sphère"),
        Size {
            name: "cut",
            unit: "m",
            default: None,
            any: true,
            text: ("height of the missing cap", "hauteur de la calotte manquante"),
        },
    ],
    volume: true,
    radii: false,
    build: |sizes, _| {
        let [r, h] = *sizes.first_chunk().expect("the card's sizes");
        if !(0.0..2.0 * r).contains(&h) {
            return Err(format!("the missing cap is 0 up to {} m high, not {h} m", 2.0 * r));
        }
        let mass = PI * (4.0 / 3.0 * r * r * r - h * h * (r - h / 3.0));
        let offset = 0.75 * h * h / (r + h);
        let rest = 2.0 * r - h;
        let i3 = PI / 30.0 * rest * rest * rest * (2.0 * r * r + 3.0 * h * r + 3.0 * h * h);
        let along = PI / 15.0 * rest * rest * (r * r * r + h * r * r - 3.0 * h * h * r + 3.0 * h * h * h);
        let i1 = i3 / 2.0 + along - mass * offset * offset;
        // It touches with the complete sphere, T's note 6.
        Ok(Solid::of_revolution(mass, -offset, i1, i3, Surface::of([0.0; 3], vec![], r)))
    },
};
