//! Egg: half a spheroid below (the blunt end) and half of another above (the sharp one), with the same equator. Drawn about
//! the middle of the equator.
//!
//! Half a spheroid with semi-axes r across and l along has the volume 2/3 pi r^2 l, its centre 3/8 l from the equator,
//! `int z^2 dm = m l^2/5` and `I3 = 2/5 m r^2`, as the whole one has.

use super::names::length;
use super::{BodyCard, Ovoid, Solid, Surface};
use std::f64::consts::PI;

pub(super) const EGG: BodyCard = BodyCard {
    id: "egg",
    title: ("Egg", "Œuf"),
    source: "two half spheroids",
    sizes: &[
        length("radius", "radius of the equator", "rayon de l'équateur"),
        length("blunt", "length of the blunt end", "longueur du gros bout"),
        length("sharp", "length of the sharp end", "longueur du petit bout"),
    ],
    volume: true,
    radii: false,
    build: |sizes, _| {
        let [r, blunt, sharp] = *sizes.first_chunk().expect("the card's sizes");
        let half = |l: f64| 2.0 / 3.0 * PI * r * r * l;
        let (below, above) = (half(blunt), half(sharp));
        let mass = below + above;
        let height = 0.375 * (above * sharp - below * blunt) / mass;
        let i3 = 0.4 * mass * r * r;
        let along = (below * blunt * blunt + above * sharp * sharp) / 5.0;
        let i1 = i3 / 2.0 + along - mass * height * height;
        let ovoid = Ovoid { across: [r, r], above: sharp, below: blunt };
        Ok(Solid::of_revolution(mass, height, i1, i3, Surface::of([0.0; 3], vec![ovoid], 0.0)))
    },
};
