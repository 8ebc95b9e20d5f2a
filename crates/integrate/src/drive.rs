//! The drive: a stepper taken from the start to the end of a run, with samples and events on the way.

use crate::engine::Engine;
use crate::{AnyMethod, Failure, Needs, Occurred, Options, Samples, Tolerance, Watched};
use precess_system::{Direction, Field};
use std::ops::ControlFlow;

/// How long the steps are.
#[derive(Clone, Debug, PartialEq)]
pub enum Pace {
    /// Of this length; the last one before a sample is shortened.
    Fixed(f64),
    /// As long as the estimated error stays within the tolerance; samples come from dense output.
    Adaptive(Tolerance),
}

/// A run to be made.
pub struct Drive<'a> {
    /// The system with its parameters.
    pub field: &'a dyn Field<f64>,
    /// The method.
    pub method: &'a dyn AnyMethod,
    /// Its options.
    pub options: Options,
    /// The full state at t = 0.
    pub start: &'a [f64],
    /// The times of the samples; the last one is the end.
    pub samples: Samples,
    /// The steps.
    pub pace: Pace,
    /// Directions of the system's own events.
    pub directions: &'a [Direction],
    /// Functions that the user watches.
    pub watches: &'a [Watched<'a>],
}

/// What a run has cost and met.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Report {
    /// Accepted steps.
    pub steps: u64,
    /// Rejected steps.
    pub rejections: u64,
    /// Evaluations of the field.
    pub evaluations: u64,
    /// Events in the order of the integration.
    pub events: Vec<Occurred>,
    /// The time reached.
    pub end: f64,
    /// The full state there.
    pub state: Vec<f64>,
    /// The watch that ended the run.
    pub stopped_by: Option<usize>,
    /// Why the run ended before its time.
    pub failure: Option<Failure>,
}

/// Makes a run. `record` gets every sample (time and full state), `progress` the time now and then; the report
/// says what ended it. Whatever happens, the samples recorded so far are right.
///
/// A sample at the very time of an event shows the state before the jump; a run that a watch ends records the
/// state there.
pub fn drive(
    run: &Drive,
    record: &mut dyn FnMut(f64, &[f64]),
    progress: &mut dyn FnMut(f64) -> ControlFlow<()>,
) -> Report {
    if let Some(what) = nonsense(run) {
        return Report { failure: Some(Failure::Refused { what }), ..Report::default() };
    }
    Engine::new(run, record, progress).run()
}

/// What makes no sense in a run: it would never end, or mean nothing.
fn nonsense(run: &Drive) -> Option<&'static str> {
    let within = |x: f64| x.is_finite() && x >= 0.0;
    let pace = match &run.pace {
        Pace::Fixed(dt) => dt.is_finite() && *dt > 0.0,
        Pace::Adaptive(tolerance) => within(tolerance.rtol) && within(tolerance.atol),
    };
    match () {
        () if run.start.len() != run.field.shape().size() => {
            Some("the start is no full state of this system")
        }
        () if run.directions.len() != run.field.shape().events => {
            Some("each event of the system needs a direction")
        }
        () if run.method.card().needs == Needs::ClosedForm
            && !(run.directions.is_empty() && run.watches.is_empty()) =>
        {
            Some("a closed form is computed from sample to sample and meets no event on the way")
        }
        () if !run.samples.is_sensible() => {
            Some("the end of a run and the time between samples must be finite numbers")
        }
        () if !knows_equations(run) => Some("this method needs the recorded equations of just this state"),
        () if !pace => Some("a step must be above zero, a tolerance not below"),
        () => None,
    }
}

/// Whether the equations of these states were given, and not those of others, where the method needs them.
fn knows_equations(run: &Drive) -> bool {
    matches!(run.method.card().needs, Needs::Any | Needs::Separable)
        || run.options.equations.as_ref().is_some_and(|tape| tape.inputs() == run.field.shape().full() + 1)
}
