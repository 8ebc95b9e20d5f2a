//! How a run ends before its time.

use std::fmt;

/// A loop that comes this close may be meant to end there.
const NEARLY: f64 = 1e-6;

/// What happened, at what time, and what to try. The samples up to then stay with the caller.
#[derive(Clone, Debug, PartialEq)]
pub enum Failure {
    /// The run makes no sense as it was asked for.
    Refused {
        /// What does not.
        what: &'static str,
    },
    /// A number of the state became infinite or NaN.
    Diverged {
        /// Time reached.
        t: f64,
    },
    /// The step that the tolerance asks for is below the resolution of time.
    StepTooSmall {
        /// Time reached.
        t: f64,
        /// The step.
        h: f64,
    },
    /// At this pace the run would not end in a day.
    TooSlow {
        /// Time reached.
        t: f64,
        /// The latest steps.
        h: f64,
    },
    /// An implicit step did not converge.
    NoConvergence {
        /// Time reached.
        t: f64,
        /// The step.
        h: f64,
        /// Iterations after which the loop gave up.
        iterations: u32,
        /// How much the last of them still changed the state, relative to its size.
        residual: f64,
    },
    /// Events follow one another without time passing.
    TooManyEvents {
        /// Time reached.
        t: f64,
    },
    /// The system knows what happened there.
    Trouble {
        /// Time reached.
        t: f64,
        /// What happened.
        what: String,
    },
    /// Whoever watched asked the run to end.
    Interrupted {
        /// Time reached.
        t: f64,
    },
}

impl Failure {
    /// The time reached.
    pub fn time(&self) -> f64 {
        match *self {
            Self::Refused { .. } => 0.0,
            Self::Diverged { t }
            | Self::StepTooSmall { t, .. }
            | Self::TooSlow { t, .. }
            | Self::NoConvergence { t, .. }
            | Self::TooManyEvents { t }
            | Self::Trouble { t, .. }
            | Self::Interrupted { t } => t,
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Refused { what } => f.write_str(what),
            Self::Diverged { t } => write!(
                f,
                "the state is no longer finite after t = {t:?} s: the motion diverges there, or the step is too \
                 long (try a smaller dt, or dop853)"
            ),
            Self::StepTooSmall { t, h } => write!(
                f,
                "at t = {t:?} s a step of {h:.1e} s would be needed, which is below the resolution of time: \
                 the motion is singular there, or the tolerance too tight (try a larger rtol)"
            ),
            Self::TooSlow { t, h } => write!(
                f,
                "at t = {t:?} s the tolerance allows steps of about {h:.1e} s only, too short to reach the end: the \
                 motion is stiff or jumps there, or the run is too long (try a larger rtol, an earlier end, or a \
                 fixed-step method)"
            ),
            Self::NoConvergence { t, h, iterations, residual } => {
                write!(
                    f,
                    "at t = {t:?} s the loop of the implicit step did not converge in {iterations} iterations \
                     with a step of {h:?} s: "
                )?;
                match residual {
                    x if !x.is_finite() => f.write_str("it ran away (try a smaller dt)"),
                    x => write!(
                        f,
                        "the last one still changed the state by {x:.1e} of its size (try a smaller dt{})",
                        if *x < NEARLY { ", or a larger epsilon" } else { "" }
                    ),
                }
            }
            Self::TooManyEvents { t } => write!(
                f,
                "at t = {t:?} s events follow one another without time passing: the motion comes to rest at the \
                 event, or the jump does not lead away from it (stop the run there, or check the parameters)"
            ),
            Self::Trouble { t, what } => write!(f, "the run ends at t = {t:?} s, where {what}"),
            Self::Interrupted { t } => write!(f, "interrupted at t = {t:?} s"),
        }
    }
}
impl std::error::Error for Failure {}
