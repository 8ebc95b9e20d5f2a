//! What basins are asked of: a plan's equations as plain functions, their scales and symmetries.

use super::matrix::{Matrix, jacobian};
use crate::error::{Error, input};
use crate::plan::Plan;
use crate::random::Random;
use crate::{catalogue, run::pace};
use precess_integrate::{Drive, Pace, Samples, Tolerance, Watched, drive};
use precess_system::{Bind, Direction, Field};
use std::f64::consts::TAU;
use std::ops::ControlFlow;

/// States at which the equations are tried.
const TRIALS: usize = 400;

/// How the energy changes along the motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Energy {
    /// It sinks wherever something moves, and its kinetic part is not negative.
    Sinks,
    /// It stays.
    Stays,
    /// Neither, or there is none.
    Unknown,
}

pub(super) struct Ground {
    pub plan: Plan,
    pub field: Box<dyn Field<f64>>,
    /// The place of the energy among the observables.
    pub energy: Option<usize>,
    /// Numbers of a state, and the coordinates among them.
    pub size: usize,
    pub coordinates: usize,
    /// Coordinates after a turn of which everything is the same.
    pub turning: Vec<bool>,
    /// The smallest and the largest start of each number, with room where they are the same.
    pub range: Vec<(f64, f64)>,
    /// The scale of each number.
    pub unit: Vec<f64>,
    /// The period of the equations, where time enters.
    pub period: Option<f64>,
}

impl Ground {
    /// From a plan and the full states that will start.
    pub fn new(plan: Plan, starts: &[f64]) -> Result<Self, Error> {
        let shape = plan.layout.shape();
        let id = plan.card.id;
        if plan.structure.hybrid {
            return input(format!("{id} has events: basins are for smooth motions"));
        }
        let field = Bind::<f64>::bind(plan.system, plan.values.clone(), &plan.layout);
        let energy = plan.layout.observables.iter().position(|o| o.quantity.name == "energy");
        let (size, coordinates) = (shape.state(), shape.coordinates);
        let (moves, time_enters) = (shape.is_second_order(), plan.structure.time_enters);
        let mut ground = Self {
            plan,
            field,
            energy: energy.filter(|_| moves && !time_enters),
            size,
            coordinates,
            turning: vec![false; coordinates],
            range: ranges(starts, size),
            unit: vec![1.0; size],
            period: None,
        };
        ground.set_units();
        ground.turning = (0..coordinates).map(|i| ground.turns(i)).collect();
        if time_enters {
            ground.period = ground.find_period();
            if ground.period.is_none() {
                return input(format!(
                    "time enters the equations of {id} without a period: nothing stays there"
                ));
            }
        }
        Ok(ground)
    }

    /// A coordinate's scale is its range; a velocity's is what the forces give over it.
    fn set_units(&mut self) {
        for (unit, (low, high)) in self.unit.iter_mut().zip(&self.range) {
            *unit = 0.5 * (high - low);
        }
        let mut steepest = vec![0.0; self.size];
        for y in self.trials(1) {
            for (most, rate) in steepest.iter_mut().zip(self.rate(0.0, &y)) {
                *most = if rate.abs() > *most { rate.abs() } else { *most };
            }
        }
        for (i, v) in self.plan.layout.shape().pairs() {
            let fall = (2.0 * steepest[v] * self.unit[i]).sqrt();
            if fall > self.unit[v] || self.range[v].0 == self.range[v].1 {
                self.unit[v] = if fall > 0.0 { fall } else { 1.0 };
            }
        }
    }

    /// States all over the range of the starts and somewhat beyond.
    pub fn trials(&self, seed: u64) -> Vec<Vec<f64>> {
        let mut random = Random::new(seed);
        let middle = |(low, high): &(f64, f64)| 0.5 * (low + high);
        let centre: Vec<f64> = self.range.iter().map(middle).collect();
        let state =
            |_| (0..self.size).map(|i| centre[i] + 1.5 * self.unit[i] * random.between(-1.0, 1.0)).collect();
        (0..TRIALS).map(state).collect()
    }

    pub fn rate(&self, t: f64, y: &[f64]) -> Vec<f64> {
        let mut rate = vec![0.0; y.len()];
        self.field.rate(t, y, &mut rate);
        rate
    }

    /// The energy of a state; NaN where there is none.
    pub fn energy_of(&self, y: &[f64]) -> f64 {
        let mut observed = vec![0.0; self.plan.layout.observables.len()];
        self.field.observe(0.0, y, &mut observed);
        self.energy.map_or(f64::NAN, |k| observed[k])
    }

    /// The energy at rest.
    pub fn potential(&self, q: &[f64]) -> f64 {
        self.energy_of(&self.at_rest(q))
    }

    /// The accelerations at rest.
    pub fn force(&self, q: &[f64]) -> Vec<f64> {
        self.rate(0.0, &self.at_rest(q)).split_off(self.coordinates)
    }

    pub fn at_rest(&self, q: &[f64]) -> Vec<f64> {
        let mut y = q.to_vec();
        y.resize(self.size, 0.0);
        y
    }

    /// A zero of a function of as many numbers, by Newton's method; none where it does not converge.
    pub fn root(&self, x: &[f64], f: &dyn Fn(&[f64]) -> Option<Vec<f64>>) -> Option<Vec<f64>> {
        let (mut x, mut last) = (x.to_vec(), f64::INFINITY);
        for _ in 0..40 {
            let residual = f(&x)?;
            let slope: Matrix = jacobian(&x, &self.unit, 1e-6, f)?;
            let step = super::matrix::solve(slope, residual)?;
            for (x, step) in x.iter_mut().zip(&step) {
                *x -= step;
            }
            let size = self.distance(&step, &vec![0.0; step.len()]);
            // Rounding alone is left where the steps no longer shrink.
            if size < 1e-9 && size >= 0.5 * last || size == 0.0 {
                return Some(x);
            }
            last = size;
        }
        None
    }

    /// The largest difference between two states (or their first numbers), each in its unit.
    pub fn distance(&self, a: &[f64], b: &[f64]) -> f64 {
        let differences = a.iter().zip(b).zip(&self.unit).map(|((a, b), unit)| (a - b).abs() / unit);
        differences.fold(0.0, |most, x| if x > most || x.is_nan() { x } else { most })
    }

    /// Whole turns from one state to the image of another that lies nearest.
    pub fn turns_between(&self, from: &[f64], to: &[f64]) -> Vec<i32> {
        let turns = |i: usize| if self.turning[i] { ((to[i] - from[i]) / TAU).round() as i32 } else { 0 };
        (0..self.coordinates).map(turns).collect()
    }

    /// The image of a state in the first turn, from -pi to pi.
    pub fn first_turn(&self, y: &[f64]) -> Vec<f64> {
        let zeros = vec![0.0; self.coordinates];
        let turns: Vec<i32> = self.turns_between(&zeros, y).iter().map(|n| -n).collect();
        turned(y, &turns)
    }

    /// Where the motion leads in a time, by `dop853` to 1e-12.
    pub fn advance(&self, y: &[f64], time: f64) -> Option<Vec<f64>> {
        let mut end = y.to_vec();
        let mut keep = |_: f64, y: &[f64]| end.copy_from_slice(y);
        self.drive(y, time, &[], &mut keep).is_some().then_some(end)
    }

    /// The next passages through a plane, with their times, in the direction of its normal.
    pub fn passages(&self, y: &[f64], time: f64, at: &[f64], normal: &[f64]) -> Vec<(f64, Vec<f64>)> {
        let function = |_: f64, y: &[f64]| {
            y.iter().zip(at).zip(normal).fold(0.0, |sum, ((y, at), normal)| sum + (y - at) * normal)
        };
        let watch = Watched { function: Box::new(function), direction: Direction::Rising, stop: false };
        self.drive(y, time, &[watch], &mut |_, _| {}).unwrap_or_default()
    }

    fn drive(
        &self,
        y: &[f64],
        time: f64,
        watches: &[Watched],
        record: &mut dyn FnMut(f64, &[f64]),
    ) -> Option<Vec<(f64, Vec<f64>)>> {
        let skip = match pace(&self.plan) {
            Pace::Adaptive(tolerance) => tolerance.skip,
            Pace::Fixed(_) => vec![],
        };
        let job = Drive {
            field: self.field.as_ref(),
            method: catalogue::method("dop853").ok()?,
            options: self.plan.options.clone(),
            start: y,
            samples: Samples::new(time, time),
            pace: Pace::Adaptive(Tolerance { rtol: 1e-12, atol: 1e-12, skip }),
            directions: &[],
            watches,
        };
        let report = drive(&job, record, &mut |_| ControlFlow::Continue(()));
        let events = report.events.into_iter().map(|event| (event.t, event.state)).collect();
        report.failure.is_none().then_some(events)
    }

    /// Whether nothing tells a coordinate from itself after a turn, though something depends on it.
    fn turns(&self, i: usize) -> bool {
        if self.plan.structure.cyclic[i] {
            return false;
        }
        self.trials(2).iter().all(|y| {
            let mut turned = y.clone();
            turned[i] += TAU;
            let same = |a: f64, b: f64| (a - b).abs() <= 1e-10 * (1.0 + a.abs());
            let rates = self.rate(0.0, y).iter().zip(self.rate(0.0, &turned)).all(|(a, b)| same(*a, b));
            rates && (self.energy.is_none() || same(self.energy_of(y), self.energy_of(&turned)))
        })
    }

    /// The period that the system declares, or the one of a parameter that is an angular frequency: tried, not believed.
    fn find_period(&self) -> Option<f64> {
        let frequencies = self.plan.values.numbers.iter().filter(|x| **x != 0.0).map(|x| TAU / x.abs());
        let mut candidates = self.plan.system.period(&self.plan.values).into_iter().chain(frequencies);
        candidates.find(|&period| {
            let same = |a: f64, b: f64| (a - b).abs() <= 1e-9 * (1.0 + a.abs());
            period.is_finite()
                && self.trials(3).iter().enumerate().all(|(k, y)| {
                    let t = period * k as f64 / TRIALS as f64;
                    self.rate(t, y).iter().zip(self.rate(t + period, y)).all(|(a, b)| same(*a, b))
                })
        })
    }

    /// What the energy does, at many states.
    pub fn energy_sinks(&self) -> Energy {
        if self.energy.is_none() {
            return Energy::Unknown;
        }
        let mut stays = true;
        for y in self.trials(4) {
            let rate = self.rate(0.0, &y);
            let slope = jacobian(&y, &self.unit, 1e-5, |y| Some(vec![self.energy_of(y)]));
            let Some(slope) = slope else { return Energy::Unknown };
            let terms = || slope[0].iter().zip(&rate).map(|(slope, rate)| slope * rate);
            let (change, size) = (terms().sum::<f64>(), terms().map(f64::abs).sum::<f64>());
            let rest = self.potential(&y[..self.coordinates]);
            let kinetic = self.energy_of(&y) - rest;
            // Differences of the energy are good to about nine digits.
            if !(change <= 1e-7 * size && kinetic >= -1e-12 * rest.abs()) {
                return Energy::Unknown;
            }
            stays &= change >= -1e-7 * size;
        }
        if stays { Energy::Stays } else { Energy::Sinks }
    }
}

/// A state (or its coordinates) so many turns further.
pub(super) fn turned(y: &[f64], turns: &[i32]) -> Vec<f64> {
    let mut y = y.to_vec();
    for (y, &n) in y.iter_mut().zip(turns) {
        *y += TAU * f64::from(n);
    }
    y
}

fn ranges(starts: &[f64], size: usize) -> Vec<(f64, f64)> {
    let full = size; // Systems with modes have events and come no further.
    let mut ranges = vec![(f64::INFINITY, f64::NEG_INFINITY); size];
    for state in starts.chunks(full) {
        for ((low, high), &x) in ranges.iter_mut().zip(state) {
            (*low, *high) = (if x < *low { x } else { *low }, if x > *high { x } else { *high });
        }
    }
    let room = |(low, high): (f64, f64)| {
        let size = if low.abs() > 1.0 { low.abs() } else { 1.0 };
        if high > low { (low, high) } else { (low - size, low + size) }
    };
    ranges.into_iter().map(room).collect()
}
