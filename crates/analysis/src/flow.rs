//! What every question is asked of: a system with its parameters, and how it is integrated from any state.

use crate::matrix::Matrix;
use crate::tangents::Tangents;
use precess_integrate::{
    AnyMethod, Drive, Failure, Options, Pace, Report, Samples, Tolerance, Watched, drive,
};
use precess_scalar::Dual;
use precess_system::{Direction, Field, Shape};
use std::cell::RefCell;
use std::ops::ControlFlow;

/// A system and a method, ready to be taken from any state at any time to any other time.
pub struct Flow<'a> {
    /// The system.
    pub field: &'a dyn Field<f64>,
    /// The same system on dual numbers.
    pub tangents: &'a dyn Field<Dual<f64>>,
    /// Directions of its own events.
    pub directions: &'a [Direction],
    /// The method.
    pub method: &'a dyn AnyMethod,
    /// Its options.
    pub options: Options,
    /// Its steps; the tolerance leaves out of a state what it leaves out of a run.
    pub pace: Pace,
    /// Told the time now and then; ends the work where it breaks.
    pub progress: RefCell<&'a mut dyn FnMut(f64) -> ControlFlow<()>>,
}

/// Why an analysis ended before its time.
pub type Stopped = Failure;

/// A field whose clock begins at another time.
struct Shifted<'a> {
    field: &'a dyn Field<f64>,
    from: f64,
}

impl Field<f64> for Shifted<'_> {
    fn shape(&self) -> &Shape {
        self.field.shape()
    }
    fn rate(&self, t: f64, y: &[f64], dy: &mut [f64]) {
        self.field.rate(t + self.from, y, dy);
    }
    fn observe(&self, t: f64, y: &[f64], out: &mut [f64]) {
        self.field.observe(t + self.from, y, out);
    }
    fn lagrangian(&self, t: f64, y: &[f64]) -> Option<f64> {
        self.field.lagrangian(t + self.from, y)
    }
    fn solution(&self, from: f64, start: &[f64], t: f64, y: &mut [f64]) {
        self.field.solution(from + self.from, start, t + self.from, y);
    }
    fn crossings(&self, t: f64, y: &[f64], out: &mut [f64]) {
        self.field.crossings(t + self.from, y, out);
    }
    fn jump(&self, event: usize, t: f64, y: &mut [f64]) {
        self.field.jump(event, t + self.from, y);
    }
}

impl Flow<'_> {
    /// Numbers of a state, without modes.
    pub fn size(&self) -> usize {
        self.field.shape().state()
    }

    /// Takes a full state from the time `from` on for a time `span` (negative: backwards), recorded every `every`;
    /// times are measured from `from`.
    pub fn run(
        &self,
        from: f64,
        start: &[f64],
        (span, every): (f64, f64),
        watches: &[Watched],
        record: &mut dyn FnMut(f64, &[f64]),
    ) -> Report {
        let field = Shifted { field: self.field, from };
        let job = Drive {
            field: &field,
            method: self.method,
            options: self.options.clone(),
            start,
            samples: Samples::new(span, every),
            pace: self.pace.clone(),
            directions: self.directions,
            watches,
        };
        drive(&job, record, &mut |t| (self.progress.borrow_mut())(from + t))
    }

    /// Moves a full state in place.
    ///
    /// # Errors
    /// Where the integration cannot go on.
    pub fn advance(&self, from: f64, state: &mut [f64], span: f64) -> Result<(), Failure> {
        let start = state.to_vec();
        let mut keep = |_: f64, y: &[f64]| state.copy_from_slice(y);
        let report = self.run(from, &start, (span, span.abs()), &[], &mut keep);
        report.failure.map_or(Ok(()), |failure| Err(later(failure, from)))
    }

    /// Moves a full state and tangent vectors along it in place.
    ///
    /// # Errors
    /// Where the integration cannot go on.
    pub fn carry(
        &self,
        from: f64,
        state: &mut [f64],
        vectors: &mut [Vec<f64>],
        span: f64,
    ) -> Result<(), Failure> {
        self.carry_along(&vec![self.tangents; vectors.len()], from, state, vectors, span)
    }

    /// The same, with the system along each vector: a parameter may move with the state.
    ///
    /// # Errors
    /// Where the integration cannot go on.
    pub fn carry_along(
        &self,
        fields: &[&dyn Field<Dual<f64>>],
        from: f64,
        state: &mut [f64],
        vectors: &mut [Vec<f64>],
        span: f64,
    ) -> Result<(), Failure> {
        if vectors.is_empty() {
            return self.advance(from, state, span);
        }
        let field = Tangents::new(fields, from);
        let start = field.join(state, vectors);
        let pace = match &self.pace {
            Pace::Adaptive(tolerance) => Pace::Adaptive(wide(tolerance, &field, vectors.len())),
            fixed @ Pace::Fixed(_) => fixed.clone(),
        };
        let job = Drive {
            field: &field,
            method: self.method,
            options: self.options.clone(),
            start: &start,
            samples: Samples::new(span, span.abs()),
            pace,
            directions: &[],
            watches: &[],
        };
        let mut end = start.clone();
        let mut keep = |_: f64, y: &[f64]| end.copy_from_slice(y);
        let report = drive(&job, &mut keep, &mut |t| (self.progress.borrow_mut())(from + t));
        field.part(&end, state, vectors);
        report.failure.map_or(Ok(()), |failure| Err(later(failure, from)))
    }

    /// The derivative of the flow from `from` for a time `span` by the state it starts from, which moves along.
    ///
    /// # Errors
    /// Where the integration cannot go on.
    pub fn derivative(&self, from: f64, state: &mut [f64], span: f64) -> Result<Matrix, Failure> {
        let size = self.size();
        let unit = |k: usize| (0..size).map(|i| if i == k { 1.0 } else { 0.0 }).collect();
        let mut vectors: Vec<Vec<f64>> = (0..size).map(unit).collect();
        self.carry(from, state, &mut vectors, span)?;
        Ok(Matrix::of_columns(&vectors))
    }
}

/// The tolerance of a state, for state and tangent vectors: what it leaves out of the one it leaves out of the others.
fn wide(tolerance: &Tolerance, field: &Tangents, vectors: usize) -> Tolerance {
    let shape = field.shape();
    let mut skip = vec![false; shape.size()];
    for row in 0..=vectors {
        for j in 0..shape.full() {
            skip[shape.place(row, j)] = tolerance.skip.get(j).copied().unwrap_or(false);
        }
    }
    Tolerance { skip, ..tolerance.clone() }
}

/// A failure told in the time of the whole.
pub(crate) fn later(failure: Failure, from: f64) -> Failure {
    let at = |t: f64| t + from;
    match failure {
        Failure::Diverged { t } => Failure::Diverged { t: at(t) },
        Failure::StepTooSmall { t, h } => Failure::StepTooSmall { t: at(t), h },
        Failure::TooSlow { t, h } => Failure::TooSlow { t: at(t), h },
        Failure::NoConvergence { t, h, iterations, residual } => {
            Failure::NoConvergence { t: at(t), h, iterations, residual }
        }
        Failure::TooManyEvents { t } => Failure::TooManyEvents { t: at(t) },
        Failure::Trouble { t, what } => Failure::Trouble { t: at(t), what },
        Failure::Interrupted { t } => Failure::Interrupted { t: at(t) },
        refused @ Failure::Refused { .. } => refused,
    }
}
