//! A swarm of test particles about a small body that passes a large one: the rings of P, exercise 10.
//!
//!     r_i'' = k sum_{j = 0, 1} m_j (r_j - r_i) / |r_j - r_i|^3        j != i
//!
//! The two bodies attract one another and every asteroid; the asteroids attract nothing, so the work grows with their
//! number and no faster. P's program adds the acceleration of its body 1 to the velocities of the asteroids, for a second
//! time, but not to their positions: `stepping = as_printed`, which is a way of stepping and no force (with the corrected
//! equations the asteroids follow their body, as they feel what it feels).

use super::cluster_card::{self, HEAVY};
use precess_scalar::Scalar;
use precess_system::{Card, Given, Layout, Satellites, State, System, Values};
use std::collections::HashSet;

/// See the module.
#[derive(Clone)]
pub struct Cluster;

/// The choice `stepping`.
const AS_PRINTED: usize = 1;

impl System for Cluster {
    fn card(&self) -> Card {
        cluster_card::card_of_cluster()
    }

    fn layout(&self, values: &Values<f64>, _given: &Given) -> Layout {
        cluster_card::layout(values.lists[1].items.as_chunks().0)
    }

    /// The rings are set about body 1, wherever it starts.
    fn start(&self, given: &Given, _values: &Values<f64>, y: &mut [f64]) -> Result<(), String> {
        let half = y.len() / 2;
        let shifts = cluster_card::shifts([y[2], y[3], y[half + 2], y[half + 3]]);
        if shifts == [0.0; 4] {
            return Ok(());
        }
        // A set, for there may be a million names; it is asked, not walked.
        let names: HashSet<&str> = given.0.iter().map(|(name, _)| name.as_str()).collect();
        for (k, shift) in shifts.into_iter().enumerate() {
            let (first, axis) = (k / 2 * half, k % 2);
            for body in HEAVY..half / 2 {
                if !names.contains(cluster_card::name(body, k).as_str()) {
                    y[first + 2 * body + axis] += shift;
                }
            }
        }
        Ok(())
    }

    fn check(&self, s: &State<f64>) -> Result<(), String> {
        let masses = s.list(0).len();
        if masses != HEAVY {
            return Err(format!("masses are those of the two bodies, not of {masses}: asteroids have none"));
        }
        cluster_card::check_rings(s.rows(1))?;
        let (heavy, asteroids) = s.coordinates.split_at(2 * HEAVY);
        if heavy[..2] == heavy[2..] {
            return Err("bodies 0 and 1 start at the same place: set x1, for instance".into());
        }
        let meets = asteroids.chunks(2).position(|place| place == &heavy[..2] || place == &heavy[2..]);
        meets.map_or(Ok(()), |k| Err(format!("asteroid {} starts in the middle of a body", k + HEAVY)))
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        accelerations(s, highest);
        if s.choice(0) == AS_PRINTED {
            let (heavy, asteroids) = highest.split_at_mut(2 * HEAVY);
            for [x, y] in asteroids.as_chunks_mut().0 {
                *x = *x + heavy[2];
                *y = *y + heavy[3];
            }
        }
    }

    #[inline(always)]
    fn drift<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) -> bool {
        let as_printed = s.choice(0) == AS_PRINTED;
        if as_printed {
            accelerations(s, highest);
        }
        as_printed
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let (zero, half) = (S::from(0.0), S::from(0.5));
        let ([k], [m0, m1]) = (s.p(), [s.list(0)[0], s.list(0)[1]]);
        let ([x0, y0, x1, y1], [u0, v0, u1, v1]) = (s.q(), s.v());
        let apart = ((x1 - x0).squared() + (y1 - y0).squared()).sqrt();
        let kinetic = (m0 * (u0.squared() + v0.squared()) + m1 * (u1.squared() + v1.squared())) * half;
        let spin = m0 * (x0 * v0 - y0 * u0) + m1 * (x1 * v1 - y1 * u1);
        let (mut bound, mut captured) = (zero, zero);
        let places = s.coordinates[2 * HEAVY..].as_chunks().0;
        let velocities = s.velocities[2 * HEAVY..].as_chunks().0;
        for (&[x, y], &[u, v]) in places.iter().zip(velocities) {
            let energy = |m: S, [x, y, u, v]: [S; 4]| {
                (u.squared() + v.squared()) * half - k * m / (x.squared() + y.squared()).sqrt()
            };
            let to_1 = energy(m1, [x - x1, y - y1, u - u1, v - v1]).lt(zero);
            let to_0 = energy(m0, [x - x0, y - y0, u - u0, v - v0]).lt(zero);
            bound = bound + S::select(to_1, S::from(1.0), zero);
            captured = captured + S::select(to_0 & !to_1, S::from(1.0), zero);
        }
        out.copy_from_slice(&[
            kinetic - k * m0 * m1 / apart,
            m0 * u0 + m1 * u1,
            m0 * v0 + m1 * v1,
            spin,
            apart,
            bound,
            captured,
        ]);
    }

    fn satellites(&self, values: &Values<f64>, count: usize) -> Option<Satellites> {
        let mut values = values.clone();
        values.lists[1].items = vec![count as f64, 1.0, 1.0, 0.0];
        Some(Satellites { rest: 2 * HEAVY, each: 2, values })
    }
}

/// What the two heavy bodies do to each other and to the asteroids.
#[inline(always)]
fn accelerations<S: Scalar>(s: &State<S>, highest: &mut [S]) {
    let ([k], [x0, y0, x1, y1]) = (s.p(), s.q());
    let (pull_0, pull_1) = (k * s.list(0)[0], k * s.list(0)[1]);
    let (heavy, asteroids) = highest.split_at_mut(2 * HEAVY);
    let [x, y, weight] = towards([x0, y0], [x1, y1]);
    heavy.copy_from_slice(&[
        pull_1 * x * weight,
        pull_1 * y * weight,
        -(pull_0 * x * weight),
        -(pull_0 * y * weight),
    ]);
    let places = &s.coordinates[2 * HEAVY..];
    // By numbers: what an iterator hands out is copied piece by piece.
    let mut k = 0;
    while k + 1 < asteroids.len() && k + 1 < places.len() {
        let place = [places[k], places[k + 1]];
        let [x, y, weight] = towards(place, [x0, y0]);
        let [u, v, lighter] = towards(place, [x1, y1]);
        let (weight, lighter) = (pull_0 * weight, pull_1 * lighter);
        asteroids[k] = x * weight + u * lighter;
        asteroids[k + 1] = y * weight + v * lighter;
        k += 2;
    }
}

/// From a place to another, and one over the cube of their distance.
#[inline(always)]
fn towards<S: Scalar>([x, y]: [S; 2], [u, v]: [S; 2]) -> [S; 3] {
    let (dx, dy) = (u - x, v - y);
    let square = dx * dx + dy * dy;
    [dx, dy, S::from(1.0) / (square * square.sqrt())]
}
