//! A scenario fitted to data: the parameters and starts for which the motion comes nearest to what was measured.

mod answer;
mod data;
mod search;

pub use data::Data;

use super::Progress;
use super::numbers::exists;
use super::subject::smooth;
use crate::error::Error;
use crate::plan::Plan;
use crate::scenario::Scenario;
use precess_analysis::{Undetermined, least_squares};
use search::Search;

/// One fitted number.
#[derive(Clone, Debug, PartialEq)]
pub struct Fitted {
    /// A number of the start, or a parameter.
    pub name: String,
    /// Its unit.
    pub unit: String,
    /// Its value.
    pub value: f64,
    /// Its standard error.
    pub error: f64,
    /// Where it lies with a probability of 95 %.
    pub interval: (f64, f64),
}

/// A fit.
#[derive(Clone)]
pub struct Fit {
    /// The fitted numbers.
    pub fitted: Vec<Fitted>,
    /// The correlation of each with each.
    pub correlation: Vec<Vec<f64>>,
    /// The scatter of the data about the motion: root mean square, a number for each column.
    pub scatter: Vec<f64>,
    /// The sum of the squared residuals over their uncertainties; without uncertainties, over the scatter.
    pub chi2: f64,
    /// Numbers measured less numbers fitted.
    pub freedom: usize,
    /// Motions that were computed.
    pub models: u32,
    /// The fitted columns at the times of the data, column by column.
    pub model: Vec<Vec<f64>>,
    /// The fitted scenario, ready to run.
    pub plan: Plan,
}

/// Without uncertainties, columns are weighed by their scatter, which is found in so many rounds.
const ROUNDS: usize = 3;

/// Fits the named numbers of the start and parameters; the scenario gives their first guesses.
///
/// # Errors
/// Where scenario, data or names make no sense, the data do not determine a name, or no motion can be integrated.
pub fn fit(scenario: &Scenario, data: &Data, free: &[String], progress: Progress) -> Result<Fit, Error> {
    let plan = Plan::new(scenario)?;
    smooth(&plan, "a fit")?;
    let columns = data.check(&plan, free)?;
    free.iter().try_for_each(|name| exists(&plan, name))?;
    let known = !data.uncertainties.is_empty();
    let mut weights: Vec<f64> = if known {
        data.uncertainties.clone()
    } else {
        data.columns.iter().map(|(_, values)| data::spread(values)).collect()
    };
    let rounds = if known || columns.len() == 1 { 1 } else { ROUNDS };
    let mut search = Search { plan, data, columns, free, progress };
    let mut guess: Vec<f64> = free.iter().map(|name| search.plan.number(name)).collect();
    if search.model(&guess, &weights)?.is_none() {
        return Err(Error::Failed("from the first guesses no motion gets to the end of the data".into()));
    }
    let mut round = 0;
    loop {
        round += 1;
        let found = least_squares(&guess, &mut |p| search.model(p, &weights))?;
        let found = found.map_err(|Undetermined(k)| undetermined(&free[k], free.len()))?;
        guess.clone_from(&found.parameters);
        search.plan = search.at(&guess)?;
        let (model, scatter) = search.scatter()?;
        if round == rounds {
            return Ok(search.finish(&found, model, scatter, known));
        }
        weights = scatter.iter().map(|s| if *s > 0.0 { *s } else { 1.0 }).collect();
    }
}

fn undetermined(name: &str, free: usize) -> Error {
    let others = if free > 1 { ", or cannot tell it from the others" } else { "" };
    Error::Input(format!("the data do not determine {name}{others}: leave it out of what is free"))
}
