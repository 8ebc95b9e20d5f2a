//! Starts on a grid: every combination of values of a few named quantities.

use crate::error::{Error, input, unknown};
use crate::plan::Plan;
use precess_system::Quantity;

/// Evenly spaced starts of one quantity, both ends included.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// Name of an initial value.
    pub name: String,
    /// First value.
    pub low: f64,
    /// Last value.
    pub high: f64,
    /// How many.
    pub points: usize,
}

impl Axis {
    /// The k-th value.
    pub fn value(&self, k: usize) -> f64 {
        if self.points < 2 {
            return self.low;
        }
        self.low + (self.high - self.low) * (k as f64 / (self.points - 1) as f64)
    }
}

/// More starts than this do not fit a machine's memory.
const MOST: usize = 100_000_000;

/// Full states at the start, one after another: the plan's own with the values of the axes in place. The first axis
/// runs fastest.
///
/// # Errors
/// Where a name is no initial value, an axis has no points or too many, or a start makes no sense.
pub fn grid(plan: &Plan, axes: &[Axis]) -> Result<Vec<f64>, Error> {
    let quantities: Vec<Quantity> =
        plan.layout.state().into_iter().chain(plan.card.starts.iter().cloned()).collect();
    let mut members = 1_usize;
    for axis in axes {
        let Some(quantity) = quantities.iter().find(|q| q.name == axis.name) else {
            let names = quantities.iter().map(|q| q.name.as_str());
            return Err(unknown(&format!("start of {}", plan.card.id), &axis.name, names));
        };
        if axis.points == 0 {
            return input(format!("the grid along {} has no points", axis.name));
        }
        if let Some(x) = [axis.low, axis.high].into_iter().find(|&x| !quantity.range.contains(x)) {
            return input(format!("{} cannot start at {x}", axis.name));
        }
        members = members.saturating_mul(axis.points);
    }
    if members > MOST {
        return input(format!("{members} starts are too many: at most {MOST}"));
    }
    let mut starts = Vec::with_capacity(members * plan.start.len());
    let names: Vec<&str> = axes.iter().map(|axis| axis.name.as_str()).collect();
    for member in 0..members {
        let mut rest = member;
        let values: Vec<f64> = axes
            .iter()
            .map(|axis| {
                let k = rest % axis.points;
                rest /= axis.points;
                axis.value(k)
            })
            .collect();
        starts.extend(plan.start_at(&names, &values)?);
    }
    Ok(starts)
}
