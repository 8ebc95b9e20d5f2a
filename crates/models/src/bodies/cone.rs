//! Cone, drawn on its tip: the base lies at z = height (T, section 3.3).
//!
//!     I1 = 3/20 m (R^2 + L^2/4)     I3 = 3/10 m R^2     G at 3/4 L above the tip

use super::names::{length, optional};
use super::{BodyCard, Solid, Surface};
use std::f64::consts::PI;

pub(super) const CONE: BodyCard = BodyCard {
    id: "cone",
    title: ("Cone", "Cône"),
    source: "T, section 3.3",
    sizes: &[
        length("height", "height", "hauteur"),
        length("radius", "radius of the base", "rayon de la base"),
        optional("tip", "m", "radius that rounds tip and edge", "rayon d'arrondi de la pointe et de l'arête"),
    ],
    volume: true,
    radii: false,
    build: |sizes, _| {
        let [l, r, tip] = *sizes.first_chunk().expect("the card's sizes");
        let slant = (r * r + l * l).sqrt();
        // The largest ball that touches mantle and base.
        let most = r * l / (r + slant);
        if !(0.0..most).contains(&tip) {
            return Err(format!("the tip of this cone can be rounded by 0 up to {most} m, not by {tip} m"));
        }
        let mass = PI / 3.0 * r * r * l;
        let i1 = 3.0 / 20.0 * mass * (r * r + l * l / 4.0);
        // The middle of the ball that the mantle touches; mass and inertia are those of the sharp cone.
        let middle = tip * slant / r;
        let base = l - tip;
        let surface = Surface::of_circles([(middle, 0.0), (base, (base - middle) * r / l)], tip);
        Ok(Solid::of_revolution(mass, 0.75 * l, i1, 0.3 * mass * r * r, surface))
    },
};
