//! Bodies that attract one another, in a plane or in space.
//!
//!     r_i'' = k sum_{j != i} m_j (r_j - r_i) / (|r_j - r_i|^2 + softening^2)^(3/2)
//!
//! (P, section 9 and exercise 9.) Total energy, momentum and angular momentum stay constant. The bodies move in
//! space as soon as a `z` is given.

use super::{kepler, n_body_card};
use crate::rotation::cross;
use precess_scalar::Scalar;
use precess_system::{Card, Given, Layout, State, System, Values};

/// See the module.
#[derive(Clone)]
pub struct NBody;

impl System for NBody {
    fn card(&self) -> Card {
        n_body_card::card_of_two()
    }

    fn layout(&self, values: &Values<f64>, given: &Given) -> Layout {
        let in_space = given.0.iter().any(|(name, _)| name.starts_with('z'));
        n_body_card::layout(values.lists[0].items.len(), if in_space { 3 } else { 2 })
    }

    fn check(&self, s: &State<f64>) -> Result<(), String> {
        let masses = s.list(0);
        if let Some((i, m)) = masses.iter().enumerate().find(|&(_, &m)| m < 0.0) {
            return Err(format!("the mass of body {i} is {m}: a mass is not negative"));
        }
        if !masses.iter().any(|&m| m > 0.0) {
            return Err("at least one body must have a mass".into());
        }
        let [_, softening] = s.p();
        let dimensions = s.coordinates.len() / masses.len();
        let places: Vec<&[f64]> = s.coordinates.chunks(dimensions).collect();
        let pair = (0..places.len()).find_map(|j| (0..j).find(|&i| places[i] == places[j]).map(|i| (i, j)));
        match pair {
            Some((i, j)) if softening == 0.0 => {
                Err(format!("bodies {i} and {j} start at the same place: set x{j}, for instance"))
            }
            _ => Ok(()),
        }
    }

    fn trouble(&self, s: &State<f64>) -> Option<String> {
        let bodies = s.list(0).len();
        let dimensions = s.coordinates.len() / bodies;
        let pairs = (0..bodies).flat_map(|j| (0..j).map(move |i| (i, j)));
        let apart = pairs.map(|(i, j)| (separation(s.coordinates, dimensions, i, j, 0.0).1, i, j));
        let (mut nearest, mut farthest) = ((f64::INFINITY, 0, 0), 0.0);
        for pair in apart {
            nearest = if pair.0 < nearest.0 { pair } else { nearest };
            farthest = if pair.0 > farthest { pair.0 } else { farthest };
        }
        let (distance, i, j) = nearest;
        let close = distance < 1e-3 * farthest || bodies == 2 && distance < 1e-6;
        close.then(|| format!("bodies {i} and {j} collide: they are {distance:.1e} apart"))
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([k, softening], masses) = (s.p(), s.list(0));
        let dimensions = highest.len() / masses.len();
        highest.fill(S::from(0.0));
        for j in 0..masses.len() {
            for i in 0..j {
                let (towards, distance) = separation(s.coordinates, dimensions, i, j, softening);
                let pull = k / (distance * distance * distance);
                for (axis, &d) in towards[..dimensions].iter().enumerate() {
                    let (a, b) = (i * dimensions + axis, j * dimensions + axis);
                    highest[a] = highest[a] + pull * masses[j] * d;
                    highest[b] = highest[b] - pull * masses[i] * d;
                }
            }
        }
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let masses = s.list(0);
        let dimensions = s.coordinates.len() / masses.len();
        let (kinetic, potential) = energies(s);
        out[0] = kinetic + potential;
        let mut momentum = [S::from(0.0); 3];
        let mut spin = [S::from(0.0); 3];
        let mut centre = [S::from(0.0); 3];
        let mut total = S::from(0.0);
        for (body, &m) in masses.iter().enumerate() {
            let place = in_space(s.coordinates, dimensions, body);
            let velocity = in_space(s.velocities, dimensions, body);
            let moment = cross(place, velocity);
            total = total + m;
            for axis in 0..3 {
                momentum[axis] = momentum[axis] + m * velocity[axis];
                spin[axis] = spin[axis] + m * moment[axis];
                centre[axis] = centre[axis] + m * place[axis];
            }
        }
        let spin = if dimensions == 3 { &spin[..] } else { &spin[2..] };
        let relative = s.coordinates.iter().enumerate().map(|(n, x)| *x - centre[n % dimensions] / total);
        let sums = momentum[..dimensions].iter().chain(spin).copied();
        let orbits = n_body_card::pairs(masses.len()).flat_map(|(i, j)| kepler::elements(s, i, j));
        let rest = sums.chain([kinetic, potential]).chain(relative).chain(orbits);
        for (place, value) in out[1..].iter_mut().zip(rest) {
            *place = value;
        }
    }

    fn solvable(&self, start: &State<f64>) -> Result<(), String> {
        let [k, softening] = start.p();
        match () {
            () if start.list(0).len() != 2 => Err("only two bodies move on orbits of a closed form".into()),
            () if softening != 0.0 => Err("two bodies have a closed form without softening only".into()),
            () if k < 0.0 => Err("two bodies that repel one another have no closed form here".into()),
            () if kepler::falls(start) => {
                Err("the bodies fall straight into one another: no orbit goes on after that".into())
            }
            () => Ok(()),
        }
    }

    #[inline(always)]
    fn solution<S: Scalar>(&self, start: &State<S>, t: S, q: &mut [S], v: &mut [S]) {
        kepler::two_bodies(start, t, q, v);
    }

    #[inline(always)]
    fn lagrangian<S: Scalar>(&self, s: &State<S>) -> Option<S> {
        let (kinetic, potential) = energies(s);
        Some(kinetic - potential)
    }
}

/// From body i to body j, and the softened distance.
#[inline(always)]
fn separation<S: Scalar>(q: &[S], dimensions: usize, i: usize, j: usize, softening: S) -> ([S; 3], S) {
    let mut towards = [S::from(0.0); 3];
    let mut square = softening * softening;
    for axis in 0..dimensions {
        towards[axis] = q[j * dimensions + axis] - q[i * dimensions + axis];
        square = square + towards[axis] * towards[axis];
    }
    (towards, square.sqrt())
}

#[inline(always)]
pub(super) fn in_space<S: Scalar>(numbers: &[S], dimensions: usize, body: usize) -> [S; 3] {
    let own = &numbers[body * dimensions..][..dimensions];
    std::array::from_fn(|axis| own.get(axis).copied().unwrap_or(S::from(0.0)))
}

#[inline(always)]
fn energies<S: Scalar>(s: &State<S>) -> (S, S) {
    let ([k, softening], masses) = (s.p(), s.list(0));
    let dimensions = s.coordinates.len() / masses.len();
    let (mut kinetic, mut potential) = (S::from(0.0), S::from(0.0));
    for j in 0..masses.len() {
        let velocity = in_space(s.velocities, dimensions, j);
        let square = velocity[0].squared() + velocity[1].squared() + velocity[2].squared();
        kinetic = kinetic + masses[j] * square * 0.5;
        for i in 0..j {
            let (_, distance) = separation(s.coordinates, dimensions, i, j, softening);
            potential = potential - k * masses[i] * masses[j] / distance;
        }
    }
    (kinetic, potential)
}
