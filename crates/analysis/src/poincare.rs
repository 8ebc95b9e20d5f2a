//! Poincaré sections: where a trajectory passes through a surface, in one direction.
//!
//! A quantity q passes through a value c, or through c + k P for any whole k where it is an angle of period P. The
//! passage is found on dense output; a periodic one as a zero of sin(2 pi (q - c) / P), which also vanishes half-way
//! between, where the passage is put aside. Sections at times c + k P need no search.

use crate::flow::{Flow, Stopped};
use precess_integrate::{Source, Watched};
use precess_scalar::Scalar;
use precess_system::Direction;

/// A surface in the space of states.
pub struct Section<'a> {
    /// The quantity, from time and full state.
    pub quantity: &'a dyn Fn(f64, &[f64]) -> f64,
    /// The value it passes through.
    pub value: f64,
    /// The period after which the value comes again.
    pub period: Option<f64>,
    /// Which way the quantity passes.
    pub direction: Direction,
}

/// A passage.
#[derive(Clone, Debug, PartialEq)]
pub struct Crossing {
    /// When.
    pub t: f64,
    /// The full state there.
    pub state: Vec<f64>,
}

/// Passages up to the end, and what ended the run before its time.
pub type Crossings = (Vec<Crossing>, Option<Stopped>);

/// How far from the nearest whole number of turns, in turns.
fn off(distance: f64, period: f64) -> f64 {
    let turns = distance / period;
    turns - turns.round()
}

/// All passages up to `until`.
pub fn section(flow: &Flow, start: &[f64], until: f64, section: &Section) -> Crossings {
    let distance = |t: f64, y: &[f64]| (section.quantity)(t, y) - section.value;
    let function = |t: f64, y: &[f64]| match section.period {
        Some(period) => Scalar::sin(std::f64::consts::TAU * off(distance(t, y), period)),
        None => distance(t, y),
    };
    let watch = Watched { function: Box::new(function), direction: section.direction, stop: false };
    let report = flow.run(0.0, start, (until, until.abs()), &[watch], &mut |_, _| {});
    let near = |t: f64, y: &[f64]| section.period.is_none_or(|p| off(distance(t, y), p).abs() < 0.25);
    let passages = report.events.into_iter().filter(|e| matches!(e.source, Source::Watch(_)));
    let crossings = passages.filter(|e| near(e.t, &e.state)).map(|e| Crossing { t: e.t, state: e.state });
    (crossings.collect(), report.failure)
}

/// The states at the times `first`, `first + period`, ... up to `until`, all of them positive.
pub fn strobe(flow: &Flow, start: &[f64], until: f64, (first, period): (f64, f64)) -> Crossings {
    let mut state = start.to_vec();
    if first > until {
        return (vec![], None);
    }
    if first > 0.0
        && let Err(failure) = flow.advance(0.0, &mut state, first)
    {
        return (vec![], Some(failure));
    }
    let whole = ((until - first) / period + 1e-9).floor() * period;
    let mut crossings = vec![];
    let mut record = |t: f64, y: &[f64]| crossings.push(Crossing { t: first + t, state: y.to_vec() });
    let report = flow.run(first, &state, (whole, period), &[], &mut record);
    (crossings, report.failure)
}
