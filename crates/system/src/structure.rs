//! What a system's equations depend on: found by running them, not declared.

use crate::{AnySystem, Given, Layout, Rates, Satellites, Values};
use precess_scalar::Dependence;

/// Facts about the equations with given parameters.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Structure {
    /// Every coordinate is of second order.
    pub second_order: bool,
    /// An acceleration depends on a velocity.
    pub velocity_enters: bool,
    /// An equation depends on time.
    pub time_enters: bool,
    /// The system has events.
    pub hybrid: bool,
    /// For each coordinate: it has a velocity, and no equation depends on it (cyclic, or ignorable).
    pub cyclic: Vec<bool>,
    /// For each mode: it rests between events.
    pub resting: Vec<bool>,
}

impl Structure {
    /// Accelerations that depend on positions (and time) alone, nothing else: what `verlet` needs.
    pub fn separable(&self) -> bool {
        self.second_order && !self.velocity_enters && !self.hybrid
    }
}

const TIME: u64 = 1;
const VELOCITY: u64 = 2;
/// Coordinates share the remaining marks; a shared mark can only make a cyclic coordinate look like an
/// ordinary one.
fn mark(coordinate: usize) -> u64 {
    1 << (2 + coordinate % 62)
}

/// Finds the structure of a system's equations for these parameters. Of a swarm, one tells how all are.
pub fn structure(system: &dyn AnySystem, values: &Values<f64>, layout: &Layout) -> Structure {
    let all = layout.coordinates.len();
    match system.satellites(values, 1) {
        Some(Satellites { rest, each, values }) if all > rest + each => {
            let one = of_equations(system, &values, &system.layout(&values, &Given::default()));
            let place = |i: usize| if i < rest { i } else { rest + (i - rest) % each };
            Structure { cyclic: (0..all).map(|i| one.cyclic[place(i)]).collect(), ..one }
        }
        _ => of_equations(system, values, layout),
    }
}

fn of_equations(system: &dyn AnySystem, values: &Values<f64>, layout: &Layout) -> Structure {
    let shape = layout.shape();
    let mut y = vec![Dependence::On(VELOCITY); shape.state()];
    for (i, place) in y[..shape.coordinates].iter_mut().enumerate() {
        *place = Dependence::On(mark(i));
    }
    y.resize(shape.full(), Dependence::On(0));
    let values = values.map(|&x| Dependence::from(x));
    let (mut dy, crossings) = Rates::rates(system, values, layout, Dependence::On(TIME), &y);
    // The rate of a second-order coordinate is its velocity by definition: only the equations count.
    for (i, _) in shape.pairs() {
        dy[i] = Dependence::from(0.0);
    }
    let marks = dy.iter().chain(&crossings).fold(0, |all, d| all | d.marks());
    let resting = dy[shape.state()..].iter().map(|d| *d == Dependence::from(0.0)).collect();
    Structure {
        second_order: shape.is_second_order(),
        velocity_enters: marks & VELOCITY != 0,
        time_enters: marks & TIME != 0,
        hybrid: shape.events > 0,
        cyclic: (0..shape.coordinates).map(|i| shape.second.contains(i) && marks & mark(i) == 0).collect(),
        resting,
    }
}
