//! What a scenario is fitted to.

use crate::error::{Error, input};
use crate::plan::Plan;
use crate::resolve;

/// What was measured.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Data {
    /// When, rising from zero (the start) on.
    pub times: Vec<f64>,
    /// Name of a column of the result (a number of the state, or an observable) and its values.
    pub columns: Vec<(String, Vec<f64>)>,
    /// The uncertainty of each column, one standard deviation; all or none.
    pub uncertainties: Vec<f64>,
}

impl Data {
    /// The columns of the plan that were measured.
    pub(super) fn check(&self, plan: &Plan, free: &[String]) -> Result<Vec<usize>, Error> {
        for (k, t) in self.times.iter().enumerate() {
            let before = if k == 0 { 0.0 } else { self.times[k - 1] };
            if !t.is_finite() || *t < 0.0 {
                return input(format!(
                    "time {} of the data is {t}: times count from the start at zero",
                    k + 1
                ));
            }
            if k > 0 && *t <= before {
                let what = if *t == before { "is there twice" } else { "comes after a later one" };
                return input(format!("time {} of the data, {t} s, {what}", k + 1));
            }
        }
        let mut columns = vec![];
        for (name, values) in &self.columns {
            let column = resolve::column(plan, name)?;
            if column == 0 || columns.contains(&column) {
                return input(format!("{name} is no column to be fitted, or is there twice"));
            }
            columns.push(column);
            if values.len() != self.times.len() {
                let (n, times) = (values.len(), self.times.len());
                return input(format!("{name} has {n} values for {times} times"));
            }
            if let Some(k) = values.iter().position(|x| !x.is_finite()) {
                return input(format!(
                    "{name} has no value at t = {} s: leave such times out",
                    self.times[k]
                ));
            }
        }
        if columns.is_empty() {
            return input("a fit needs a measured column beside the times");
        }
        if free.is_empty() {
            return input("a fit needs something free: numbers of the start, or parameters");
        }
        if let Some(k) = (1..free.len()).find(|k| free[..*k].contains(&free[*k])) {
            return input(format!("{} is free twice", free[k]));
        }
        let (numbers, unknowns) = (columns.len() * self.times.len(), free.len());
        if numbers <= unknowns {
            return input(format!(
                "{numbers} measured numbers are too few for {unknowns} free ones with an uncertainty: at least {}",
                unknowns + 1
            ));
        }
        if !self.uncertainties.is_empty() {
            if self.uncertainties.len() != columns.len() {
                return input("either every column has an uncertainty, or none");
            }
            if let Some(x) = self.uncertainties.iter().find(|x| !(x.is_finite() && **x > 0.0)) {
                return input(format!("an uncertainty is above zero, not {x}"));
            }
        }
        Ok(columns)
    }
}

/// The standard deviation of values about their mean; one where they are all the same.
pub(super) fn spread(values: &[f64]) -> f64 {
    let n = values.len() as f64;
    let mean = values.iter().fold(0.0, |sum, x| sum + x) / n;
    let square = values.iter().fold(0.0, |sum, x| sum + (x - mean) * (x - mean)) / n;
    if square > 0.0 { square.sqrt() } else { 1.0 }
}
