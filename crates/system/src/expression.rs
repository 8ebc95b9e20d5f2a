//! The equations of a system with given parameters, written down.

use crate::{AnySystem, Layout, Rates, Values};
use precess_scalar::{Tape, Traced};

/// The rates of a full state: the inputs are time and the state, parameters are literals. It is simplified as real numbers
/// allow, so that a term with a factor of zero (no friction) is not there.
pub fn expression(system: &dyn AnySystem, values: &Values<f64>, layout: &Layout) -> Tape {
    let full = layout.shape().full();
    let recorded = Tape::record(1 + full, |x| {
        let values = values.map(|&x| Traced::from(x));
        Rates::rates(system, values, layout, x[0], &x[1..]).0
    });
    recorded.simplified()
}
