//! Sphere: I = 2/5 m R^2 (T, section 3.3). Drawn about its centre.

use super::names::length;
use super::{BodyCard, Solid, Surface};
use std::f64::consts::PI;

pub(super) const SPHERE: BodyCard = BodyCard {
    id: "sphere",
    title: ("Sphere", "Sphère"),
    source: "T, section 3.3",
    sizes: &[length("radius", "radius", "rayon")],
    volume: true,
    radii: false,
    build: |sizes, _| {
        let [r] = *sizes.first_chunk().expect("the card's sizes");
        let mass = 4.0 / 3.0 * PI * r * r * r;
        let inertia = 0.4 * mass * r * r;
        Ok(Solid::of_revolution(mass, 0.0, inertia, inertia, Surface::of([0.0; 3], vec![], r)))
    },
};
