//! Ellipsoid, drawn about its middle: `I = m/5 diag(b^2 + c^2, a^2 + c^2, a^2 + b^2)`.
//!
//! Loaded unevenly it is a rattleback. What the load is made of is left open, so this much is a declaration: the centre of mass
//! lies `lower` below the middle, and the moments of inertia about it are those of the even ellipsoid, on axes that are turned
//! against those of the surface by Euler angles.

use super::names::{length, optional};
use super::{BodyCard, Ovoid, Solid, Surface, turned};
use std::f64::consts::PI;

pub(super) const ELLIPSOID: BodyCard = BodyCard {
    id: "ellipsoid",
    title: ("Ellipsoid", "Ellipsoïde"),
    source: "H. Goldstein, Classical Mechanics, chapter 5",
    sizes: &[
        length("a", "semi-axis along axis 1", "demi-axe selon l'axe 1"),
        length("b", "semi-axis along axis 2", "demi-axe selon l'axe 2"),
        length("c", "semi-axis along axis 3", "demi-axe selon l'axe 3"),
        optional("lower", "m", "depth of G below the middle", "profondeur de G sous le milieu"),
        optional(
            "psi",
            "rad",
            "turn of the axes of inertia, precession",
            "rotation des axes d'inertie, précession",
        ),
        optional(
            "theta",
            "rad",
            "turn of the axes of inertia, nutation",
            "rotation des axes d'inertie, nutation",
        ),
        optional("phi", "rad", "turn of the axes of inertia, proper", "rotation des axes d'inertie, propre"),
    ],
    volume: true,
    radii: false,
    build: |sizes, _| {
        let [a, b, c, lower, psi, theta, phi] = *sizes.first_chunk().expect("the card's sizes");
        if lower.abs() >= c {
            return Err(format!("the centre of mass lies inside: lower is less than {c} m, not {lower} m"));
        }
        let mass = 4.0 / 3.0 * PI * a * b * c;
        let [a2, b2, c2] = [a, b, c].map(|x| mass * x * x / 5.0);
        let even = [[b2 + c2, 0.0, 0.0], [0.0, a2 + c2, 0.0], [0.0, 0.0, a2 + b2]];
        let inertia = if [psi, theta, phi] == [0.0; 3] { even } else { turned(even, [psi, theta, phi]) };
        let surface = Surface::of([0.0; 3], vec![Ovoid::ellipsoid([a, b, c])], 0.0);
        Ok(Solid { mass, centre: [0.0, 0.0, -lower], inertia, surface })
    },
};
