//! What a question asks of a plan, and how it fails.

use crate::error::{Error, input};
use crate::plan::Plan;

/// Refuses what neither tangent vectors nor a shadow can follow.
pub(crate) fn smooth(plan: &Plan, what: &str) -> Result<(), Error> {
    if plan.structure.hybrid {
        let id = plan.card.id;
        return input(format!("{what} needs a motion without jumps, and {id} has events"));
    }
    Ok(())
}

/// A question follows a motion forwards.
pub(crate) fn forwards(plan: &Plan) -> Result<(), Error> {
    if plan.until > 0.0 {
        return Ok(());
    }
    input(format!("the end must be above zero here, not {}", plan.until))
}

/// A sentence for a failure, with the advice that is its own.
pub(crate) fn failed<T>(failure: &precess_integrate::Failure) -> Result<T, Error> {
    Err(Error::Failed(failure.to_string()))
}
