//! A body of revolution by its profile: radii at the middles of N equal slices (T, section 3.4), `z_i = (2i - 1)/2 L/N`.
//!
//! `profile` takes each slice for a cylinder and sums as T does, which converges with order 2:
//!
//!     m = pi rho L/N sum r^2     d = sum z r^2 / sum r^2     I3 = pi/2 rho L/N sum r^4     I1 = I3/2 + pi rho L/N sum z^2 r^2 - m d^2
//!
//! `smooth_profile` draws a smooth curve through the same radii (cubic pieces with the slopes of parabolas, continued to both ends)
//! and integrates it exactly, by Gauss's formula with seven points.

use super::names::length;
use super::{BodyCard, Solid, Surface};
use std::f64::consts::PI;

const HEIGHT: super::Size = length("height", "height", "hauteur");

pub(super) const PROFILE: BodyCard = BodyCard {
    id: "profile",
    title: ("Body of revolution in slices", "Solide de révolution en tranches"),
    source: "T, section 3.4",
    sizes: &[HEIGHT],
    volume: true,
    radii: true,
    build: |sizes, radii| {
        check(radii)?;
        let thickness = sizes[0] / radii.len() as f64;
        let slices = radii.iter().enumerate().map(|(i, r)| ((i as f64 + 0.5) * thickness, *r, thickness));
        let circles = radii.iter().enumerate().flat_map(|(i, r)| {
            let low = i as f64 * thickness;
            [(low, *r), (low + thickness, *r)]
        });
        Ok(summed(slices, Surface::of_circles(circles, 0.0)))
    },
};

pub(super) const SMOOTH_PROFILE: BodyCard = BodyCard {
    id: "smooth_profile",
    title: ("Body of revolution with a smooth profile", "Solide de révolution à profil lisse"),
    source: "T, section 3.4, with a smooth curve",
    sizes: &[HEIGHT],
    volume: true,
    radii: true,
    build: |sizes, radii| {
        check(radii)?;
        if radii.len() < 3 {
            return Err(format!("a smooth profile needs at least 3 radii, not {}", radii.len()));
        }
        let thickness = sizes[0] / radii.len() as f64;
        // Within an interval between two middles; the first reaches down to 0, the last up to the height.
        let mut nodes = vec![];
        for interval in 0..radii.len() - 1 {
            let low = if interval == 0 { -0.5 } else { 0.0 };
            let high = if interval == radii.len() - 2 { 1.5 } else { 1.0 };
            for (node, weight) in GAUSS {
                let u = low + (high - low) * node;
                let z = (interval as f64 + 0.5 + u) * thickness;
                nodes.push((z, curve(radii, interval, u), weight * (high - low) * thickness));
            }
        }
        let ends = [(0.0, curve(radii, 0, -0.5)), (sizes[0], curve(radii, radii.len() - 2, 1.5))];
        let circles: Vec<_> = nodes.iter().map(|&(z, r, _)| (z, r)).chain(ends).collect();
        Ok(summed(nodes.into_iter(), Surface::of_circles(circles, 0.0)))
    },
};

fn check(radii: &[f64]) -> Result<(), String> {
    if radii.is_empty() {
        return Err("a profile needs its radii: a list such as [0.01; 0.03; 0.05]".into());
    }
    for (i, r) in radii.iter().enumerate() {
        if !(r.is_finite() && *r >= 0.0) {
            return Err(format!("radius {} of the profile must not be below zero, but is {r}", i + 1));
        }
    }
    if radii.iter().all(|r| *r == 0.0) {
        return Err("all radii of the profile are zero: nothing has a mass".into());
    }
    Ok(())
}

/// Sums over slices (height, radius, thickness), with a density of 1.
fn summed(slices: impl Iterator<Item = (f64, f64, f64)>, surface: Surface) -> Solid {
    let [mut m, mut first, mut second, mut i3] = [0.0; 4];
    for (z, r, thickness) in slices {
        let slice = PI * r * r * thickness;
        m += slice;
        first += slice * z;
        second += slice * z * z;
        i3 += slice * r * r / 2.0;
    }
    let d = first / m;
    Solid::of_revolution(m, d, i3 / 2.0 + second - m * d * d, i3, surface)
}

/// The smooth curve between the middles of slices `i` and `i + 1`, at `u` of the way.
fn curve(radii: &[f64], i: usize, u: f64) -> f64 {
    let last = radii.len() - 1;
    let slope = |i: usize| match i {
        0 => 2.0 * radii[1] - 1.5 * radii[0] - 0.5 * radii[2],
        i if i == last => 1.5 * radii[last] - 2.0 * radii[last - 1] + 0.5 * radii[last - 2],
        i => (radii[i + 1] - radii[i - 1]) / 2.0,
    };
    let (a, b, p, q) = (radii[i], radii[i + 1], slope(i), slope(i + 1));
    let r = a + u * (p + u * (3.0 * (b - a) - 2.0 * p - q + u * (2.0 * (a - b) + p + q)));
    if r > 0.0 { r } else { 0.0 }
}

/// Gauss's seven points and weights on (0, 1).
const GAUSS: [(f64, f64); 7] = [
    (0.025446043828620737737, 0.064742483084434846635),
    (0.12923440720030278007, 0.13985269574463833395),
    (0.29707742431130141655, 0.19091502525255947247),
    (0.5, 0.20897959183673469388),
    (0.70292257568869858345, 0.19091502525255947247),
    (0.87076559279969721993, 0.13985269574463833395),
    (0.97455395617137926226, 0.064742483084434846635),
];

/// Whether the profile that was given is convex: no radius lies inside the hull of the others.
///
/// # Errors
/// One sentence: which radius does.
pub fn convex(radii: &[f64]) -> Result<(), String> {
    for i in 1..radii.len().saturating_sub(1) {
        let chord = f64::midpoint(radii[i - 1], radii[i + 1]);
        if radii[i] < chord * (1.0 - 1e-12) {
            return Err(format!(
                "the profile is hollow at radius {} ({} where a straight line between its neighbours gives {chord}): a \
                 contact needs a convex one",
                i + 1,
                radii[i]
            ));
        }
    }
    Ok(())
}
