//! A run in double-double, from recorded equations: what a run in doubles is held against.

use crate::methods::{dop853::Dop853, taylor::Taylor};
use crate::pacer::{Pacer, first_step};
use crate::{Failure, Method, NoConvergence, Options, Samples, Step, Stepper, Tolerance};
use precess_scalar::{DoubleDouble, Tape, Taylor as Series};
use precess_system::{Field, Second, Shape};
use std::ops::ControlFlow;
use std::sync::Arc;

/// More attempts than this take hours.
const MOST_ATTEMPTS: u64 = 20_000_000;
/// Attempts between two looks at whoever watches.
const BETWEEN_LOOKS: u64 = 256;

/// What is shadowed.
pub struct Shadow<'a> {
    /// The rates of a state, from time and state.
    pub equations: Arc<Tape>,
    /// The state at t = 0.
    pub start: &'a [f64],
    /// So many of its first numbers are recorded.
    pub reported: usize,
    /// What stays out of the error norm: parameters, which rest.
    pub skip: Vec<bool>,
    /// When to record.
    pub samples: Samples,
    /// The tolerance, relative and absolute.
    pub tolerance: f64,
}

/// Equations on a tape as a field.
struct Recorded {
    equations: Arc<Tape>,
    shape: Shape,
}

impl Field<DoubleDouble> for Recorded {
    fn shape(&self) -> &Shape {
        &self.shape
    }
    fn rate(&self, t: DoubleDouble, y: &[DoubleDouble], dy: &mut [DoubleDouble]) {
        let inputs: Vec<DoubleDouble> = std::iter::once(t).chain(y.iter().copied()).collect();
        dy.copy_from_slice(&self.equations.evaluate(&inputs));
    }
}

impl Shadow<'_> {
    /// Runs: by Taylor's series where the equations have one, otherwise by `dop853`. Each step ends at the next sample or
    /// before. `record` is given the samples, rounded, `progress` the time now and then; either may end the run.
    ///
    /// # Errors
    /// Where the steps shrink to nothing, or would never end.
    pub fn run(
        &self,
        record: &mut dyn FnMut(Vec<f64>) -> ControlFlow<()>,
        progress: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> Result<(), Failure> {
        let n = self.start.len();
        let shape = Shape {
            coordinates: n,
            second: Second::These(vec![]),
            attitudes: vec![],
            modes: 0,
            observables: 0,
            events: 0,
            rows: 1,
        };
        let options = Options { equations: Some(Arc::clone(&self.equations)), ..Options::default() };
        let (mut stepper, order): (Box<dyn Stepper<DoubleDouble>>, u32) =
            if Series::<DoubleDouble>::new(&self.equations, 1).is_ok() {
                (Box::new(Taylor.stepper(&shape, &options)), Method::card(&Taylor).order)
            } else {
                (Box::new(Dop853.stepper(&shape, &options)), Method::card(&Dop853).order)
            };
        let field = Recorded { equations: Arc::clone(&self.equations), shape };
        let skip = self.skip.clone();
        let tolerance = Tolerance { rtol: self.tolerance, atol: self.tolerance, skip };
        let until = self.samples.time(self.samples.last());
        let mut y: Vec<DoubleDouble> = self.start.iter().map(|x| DoubleDouble::from(*x)).collect();
        let (mut next, mut weights) = (y.clone(), y.clone());
        let mut pacer = Pacer::new(order, first_step(&field, &tolerance, order, &y, until));
        let (mut t, mut attempts) = (DoubleDouble::from(self.samples.time(self.samples.first())), 0_u64);
        for sample in self.samples.first()..=self.samples.last() {
            let target = DoubleDouble::from(self.samples.time(sample));
            while t != target {
                let (h, end) = pacer.next(t, target);
                let here = t.to_f64();
                if end == t {
                    return Err(Failure::StepTooSmall { t: here, h: h.to_f64() });
                }
                attempts += 1;
                if attempts > MOST_ATTEMPTS {
                    return Err(Failure::TooSlow { t: here, h: h.to_f64() });
                }
                if attempts.is_multiple_of(BETWEEN_LOOKS) && progress(here).is_break() {
                    return Err(Failure::Interrupted { t: here });
                }
                let step = &mut Step { field: &field, t, y: &y, h, out: &mut next };
                if let Err(NoConvergence { iterations }) = stepper.step(step) {
                    let (h, residual) = (h.to_f64(), stepper.residual().to_f64());
                    return Err(Failure::NoConvergence { t: here, h, iterations, residual });
                }
                tolerance.weights(&y, &next, &mut weights);
                let finite = next.iter().all(|x| x.to_f64().is_finite());
                let error = if finite { stepper.error(h, &weights) } else { DoubleDouble::from(f64::NAN) };
                let accepted = pacer.judge(h, error);
                stepper.accept(accepted);
                if accepted {
                    std::mem::swap(&mut y, &mut next);
                    t = end;
                }
            }
            if record(y[..self.reported].iter().map(|x| x.to_f64()).collect()).is_break() {
                return Ok(());
            }
        }
        Ok(())
    }
}
