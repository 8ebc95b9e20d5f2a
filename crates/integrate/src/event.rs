//! Events: where a function of the state passes through zero, found to rounding on the dense output.

use crate::Dense;
use precess_system::{Direction, Field};

/// A function of time and full state.
pub type Function<'a> = Box<dyn Fn(f64, &[f64]) -> f64 + 'a>;

/// A function that a user watches.
pub struct Watched<'a> {
    /// The function.
    pub function: Function<'a>,
    /// Which way it passes through zero, as the integration proceeds.
    pub direction: Direction,
    /// The run ends there.
    pub stop: bool,
}

/// Whose event it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Source {
    /// The system's own, by number: the state may jump.
    System(usize),
    /// A watched function, by number.
    Watch(usize),
}

/// An event that happened.
#[derive(Clone, Debug, PartialEq)]
pub struct Occurred {
    /// Whose.
    pub source: Source,
    /// When: the first representable time at which the function has passed.
    pub t: f64,
    /// The full state there, before any jump.
    pub state: Vec<f64>,
}

/// All event functions of a run, with their values at the last point that was looked at.
pub(crate) struct Scanner<'a> {
    field: &'a dyn Field<f64>,
    directions: &'a [Direction],
    pub watches: &'a [Watched<'a>],
    before: Vec<f64>,
    after: Vec<f64>,
    state: Vec<f64>,
}

/// A time so soon after the start of a step (in steps) that nothing has happened since.
const AT_ONCE: f64 = 1e-11;

/// A passage from one side to the other: landing on zero counts, leaving it does not.
fn passes(direction: Direction, before: f64, after: f64) -> bool {
    let rising = before < 0.0 && after >= 0.0;
    let falling = before > 0.0 && after <= 0.0;
    match direction {
        Direction::Rising => rising,
        Direction::Falling => falling,
        Direction::Either => rising || falling,
    }
}

impl<'a> Scanner<'a> {
    pub fn new(field: &'a dyn Field<f64>, directions: &'a [Direction], watches: &'a [Watched<'a>]) -> Self {
        let count = directions.len() + watches.len();
        let zeros = vec![0.0; count];
        let state = vec![0.0; field.shape().full()];
        Self { field, directions, watches, before: zeros.clone(), after: zeros, state }
    }

    /// Whether there is anything to look for.
    pub fn is_idle(&self) -> bool {
        self.before.is_empty()
    }

    fn source(&self, k: usize) -> Source {
        let own = self.directions.len();
        if k < own { Source::System(k) } else { Source::Watch(k - own) }
    }

    fn direction(&self, k: usize) -> Direction {
        let own = self.directions.len();
        if k < own { self.directions[k] } else { self.watches[k - own].direction }
    }

    fn values(&self, t: f64, y: &[f64], out: &mut [f64]) {
        let (own, watched) = out.split_at_mut(self.directions.len());
        self.field.crossings(t, y, own);
        for (value, watch) in watched.iter_mut().zip(self.watches) {
            *value = (watch.function)(t, y);
        }
    }

    /// From here on: the values at the start of the next step.
    pub fn begin(&mut self, t: f64, y: &[f64]) {
        let mut before = std::mem::take(&mut self.before);
        self.values(t, y, &mut before);
        self.before = before;
    }

    /// Whether some function is on another side at the end of a step.
    pub fn ends_differ(&mut self, t: f64, y: &[f64]) -> bool {
        let mut after = std::mem::take(&mut self.after);
        self.values(t, y, &mut after);
        self.after = after;
        let differs = |k| self.before[k] == 0.0 || passes(self.direction(k), self.before[k], self.after[k]);
        (0..self.before.len()).any(differs)
    }

    /// All passages inside a step, in the order of time; `begin` must have seen its start.
    pub fn find(&mut self, dense: &Dense<f64>, t: f64, h: f64, pieces: u32) -> Vec<(f64, Source)> {
        let mut found = vec![];
        let mut state = std::mem::take(&mut self.state);
        let mut before = self.before.clone();
        let mut after = before.clone();
        let mut from = t;
        if before.contains(&0.0) {
            // A function that starts on zero (a ball on the floor) is on the side where it goes at once.
            dense.at(t + h * AT_ONCE, &mut state);
            self.values(t + h * AT_ONCE, &state, &mut after);
            for k in 0..before.len() {
                if before[k] == 0.0 {
                    before[k] = after[k];
                }
            }
        }
        for piece in 1..=pieces {
            let to = if piece == pieces { t + h } else { t + h * (f64::from(piece) / f64::from(pieces)) };
            dense.at(to, &mut state);
            self.values(to, &state, &mut after);
            for k in 0..before.len() {
                if passes(self.direction(k), before[k], after[k]) {
                    found.push((self.locate(dense, k, from, to, before[k], &mut state), self.source(k)));
                }
            }
            std::mem::swap(&mut before, &mut after);
            from = to;
        }
        self.state = state;
        let forwards = |a: f64, b: f64| if h < 0.0 { b.total_cmp(&a) } else { a.total_cmp(&b) };
        found.sort_by(|a, b| forwards(a.0, b.0).then(a.1.cmp(&b.1)));
        found
    }

    /// Bisection down to two neighbouring times; gives the one on the far side.
    fn locate(&self, dense: &Dense<f64>, k: usize, from: f64, to: f64, start: f64, state: &mut [f64]) -> f64 {
        let (mut near, mut far) = (from, to);
        let mut values = vec![0.0; self.before.len()];
        loop {
            let middle = near + (far - near) * 0.5;
            if middle == near || middle == far {
                return far;
            }
            dense.at(middle, state);
            self.values(middle, state, &mut values);
            let passed = if start < 0.0 { values[k] >= 0.0 } else { values[k] <= 0.0 };
            if passed {
                far = middle;
            } else {
                near = middle;
            }
        }
    }
}
