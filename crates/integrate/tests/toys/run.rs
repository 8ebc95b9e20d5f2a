//! A whole run of a toy, by any method at any pace.

use super::{Known, method, methods};
use precess_integrate::{Drive, Kind, Pace, Report, Samples, Tolerance, Watched, drive};
use precess_system::Direction;
use std::ops::ControlFlow;

pub type Rows = Vec<(f64, Vec<f64>)>;

/// A whole run of a toy, and what it is watched for.
pub struct Run<'a> {
    pub field: &'a dyn Known,
    pub method: &'a str,
    pub start: &'a [f64],
    pub until: f64,
    pub every: f64,
    pub pace: Pace,
    pub directions: &'a [Direction],
    pub watches: &'a [Watched<'a>],
}

impl<'a> Run<'a> {
    /// Watched for nothing; `until` and `every` go together.
    pub fn new(
        field: &'a dyn Known,
        method: &'a str,
        start: &'a [f64],
        (until, every): (f64, f64),
        pace: Pace,
    ) -> Self {
        Self { field, method, start, until, every, pace, directions: &[], watches: &[] }
    }

    pub fn go(&self) -> (Report, Rows) {
        let mut rows = vec![];
        let report = drive(
            &Drive {
                field: self.field,
                method: method(self.method),
                options: self.field.options(),
                start: self.start,
                samples: Samples::new(self.until, self.every),
                pace: self.pace.clone(),
                directions: self.directions,
                watches: self.watches,
            },
            &mut |t, y| rows.push((t, y.to_vec())),
            &mut |_| ControlFlow::Continue(()),
        );
        (report, rows)
    }
}

pub fn tight(rtol: f64) -> Pace {
    Pace::Adaptive(Tolerance { rtol, atol: rtol, skip: vec![] })
}

pub fn watch<'a>(f: impl Fn(f64, &[f64]) -> f64 + 'a, direction: Direction, stop: bool) -> Watched<'a> {
    Watched { function: Box::new(f), direction, stop }
}

/// Every method with its pace.
pub fn paces(dt: f64) -> impl Iterator<Item = (&'static str, Pace)> {
    methods().flat_map(move |card| {
        let adaptive = card.kind == Kind::Adaptive;
        [(card.id, Pace::Fixed(dt))].into_iter().chain(adaptive.then(|| (card.id, tight(1e-10))))
    })
}
