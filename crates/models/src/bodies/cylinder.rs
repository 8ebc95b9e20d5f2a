//! Cylinder, and its limits: bar (no radius) and disc (no length). Drawn about the centre (T, section 3.3).
//!
//!     I1 = m (R^2/4 + L^2/12)     I3 = m R^2/2

use super::names::{length, optional};
use super::{BodyCard, Ovoid, Solid, Surface};
use std::f64::consts::PI;

fn round(mass: f64, r: f64, l: f64, ovoids: Vec<Ovoid>, edge: f64) -> Solid {
    let i1 = mass * (r * r / 4.0 + l * l / 12.0);
    Solid::of_revolution(mass, 0.0, i1, mass * r * r / 2.0, Surface::of([0.0; 3], ovoids, edge))
}

fn segment(l: f64) -> Ovoid {
    Ovoid::ellipsoid([0.0, 0.0, l / 2.0])
}

pub(super) const CYLINDER: BodyCard = BodyCard {
    id: "cylinder",
    title: ("Cylinder", "Cylindre"),
    source: "T, section 3.3",
    sizes: &[
        length("length", "length", "longueur"),
        length("radius", "radius", "rayon"),
        optional("edge", "m", "radius that rounds the edges", "rayon d'arrondi des arêtes"),
    ],
    volume: true,
    radii: false,
    build: |sizes, _| {
        let [l, r, edge] = *sizes.first_chunk().expect("the card's sizes");
        let most = if r < l / 2.0 { r } else { l / 2.0 };
        if !(0.0..most).contains(&edge) {
            return Err(format!(
                "the edges of this cylinder can be rounded by 0 up to {most} m, not by {edge} m"
            ));
        }
        // Mass and inertia are those of the sharp cylinder: the rounding is one of the contact.
        Ok(round(PI * r * r * l, r, l, vec![Ovoid::disc(r - edge), segment(l - 2.0 * edge)], edge))
    },
};

pub(super) const BAR: BodyCard = BodyCard {
    id: "bar",
    title: ("Thin bar", "Barre mince"),
    source: "T, section 3.3",
    sizes: &[length("length", "length", "longueur")],
    volume: false,
    radii: false,
    build: |sizes, _| Ok(round(1.0, 0.0, sizes[0], vec![segment(sizes[0])], 0.0)),
};

pub(super) const DISC: BodyCard = BodyCard {
    id: "disc",
    title: ("Thin disc", "Disque mince"),
    source: "T, section 3.3",
    sizes: &[length("radius", "radius", "rayon")],
    volume: false,
    radii: false,
    build: |sizes, _| Ok(round(1.0, sizes[0], 0.0, vec![Ovoid::disc(sizes[0])], 0.0)),
};
