//! Events: where a function of the state passes through zero, found to rounding on the dense output.

use crate::Dense;
use precess_system::{Direction, Field};

/// A number computed from time and full state.
pub type Observed<'a> = Box<dyn Fn(f64, &[f64]) -> f64 + 'a>;

/// A function of time and state that a user watches.
pub struct Watched<'a> {
    /// The function.
    pub function: Observed<'a>,
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
    /// The next step begins at a jump.
    pub fresh: bool,
}

/// Where inside a step the functions are looked at, in shares of it.
const WHOLE: &[f64] = &[1.0];
const QUARTERS: &[f64] = &[0.25, 0.5, 0.75, 1.0];
/// The flight after a jump may be very short: a ball leaves the floor and is back long before the step ends.
const AFTER_A_JUMP: &[f64] = &[
    1.0 / 1048576.0,
    1.0 / 65536.0,
    1.0 / 4096.0,
    1.0 / 512.0,
    1.0 / 128.0,
    1.0 / 64.0,
    1.0 / 32.0,
    1.0 / 16.0,
    0.125,
    0.25,
    0.375,
    0.5,
    0.625,
    0.75,
    0.875,
    1.0,
];

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
        Self { field, directions, watches, before: zeros.clone(), after: zeros, state, fresh: true }
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

    /// Whether a step is to be searched: always where that is to be thorough or a jump was just made, and where
    /// some function is on another side at the end.
    pub fn is_needed(&mut self, t: f64, y: &[f64], thorough: bool) -> bool {
        let mut after = std::mem::take(&mut self.after);
        self.values(t, y, &mut after);
        self.after = after;
        let differs = |k| passes(self.direction(k), self.before[k], self.after[k]);
        thorough || self.fresh || (0..self.before.len()).any(differs)
    }

    /// Whether a function of the system is still on the side to which it has passed, at a state that another
    /// jump has changed.
    pub fn still_beyond(&mut self, event: usize, t: f64, y: &[f64]) -> bool {
        let mut after = std::mem::take(&mut self.after);
        self.values(t, y, &mut after);
        self.after = after;
        passes(self.direction(event), self.before[event], self.after[event])
    }

    /// All passages inside a step from `t` to `end`, in the order of the run, watches first where times are the
    /// same; `begin` must have seen its start.
    pub fn find(
        &mut self,
        dense: &Dense<f64>,
        t: f64,
        end: f64,
        y: &[f64],
        thorough: bool,
    ) -> Vec<(f64, Source)> {
        let shares = match (self.fresh, thorough) {
            (true, _) => AFTER_A_JUMP,
            (_, true) => QUARTERS,
            _ => WHOLE,
        };
        let mut found = vec![];
        let mut state = std::mem::take(&mut self.state);
        let mut before = self.before.clone();
        let mut after = before.clone();
        let mut from = t;
        for share in shares {
            let to = if *share == 1.0 { end } else { t + (end - t) * share };
            if *share == 1.0 {
                state.copy_from_slice(y);
            } else {
                dense.at(to, &mut state);
            }
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
        let forwards = |a: f64, b: f64| if end < t { b.total_cmp(&a) } else { a.total_cmp(&b) };
        let own = |source: Source| matches!(source, Source::System(_));
        found.sort_by(|a, b| forwards(a.0, b.0).then(own(a.1).cmp(&own(b.1))).then(a.1.cmp(&b.1)));
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
