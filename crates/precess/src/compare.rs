//! Several methods on the same start, side by side.

use crate::error::Error;
use crate::plan::Plan;
use crate::scenario::Scenario;
use crate::value::Value;
use crate::{Drift, Outcome, drifts, run};
use precess_scalar::Scalar;
use precess_system::Trajectory;
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

/// One method's run.
#[derive(Clone, Debug, PartialEq)]
pub struct Contender {
    /// Method id.
    pub method: String,
    /// Its outcome.
    pub outcome: Outcome,
    /// The largest distance of its state from the reference at a sample, each number measured by its own largest
    /// size on the reference; NaN where it has lost its way.
    pub error: f64,
    /// The drift of each invariant.
    pub drifts: Vec<Drift>,
    /// How long it took.
    pub time: Duration,
}

/// Several methods side by side.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// The methods in the order asked for.
    pub contenders: Vec<Contender>,
    /// The error of the reference itself, as the distance between two tight tolerances: nothing below it counts.
    pub floor: f64,
}

/// Tolerances of the reference and of the run that it is held against.
const REFERENCE: [f64; 2] = [1e-14, 1e-13];

/// Runs the scenario under several methods.
///
/// # Errors
/// Where the scenario, a method or their combination makes no sense.
pub fn compare(
    scenario: &Scenario,
    methods: &[String],
    progress: &mut dyn FnMut(&str, f64) -> ControlFlow<()>,
) -> Result<Comparison, Error> {
    let plans: Vec<(String, Plan)> = methods
        .iter()
        .map(|id| Ok((id.clone(), Plan::new(&scenario.by(id)?)?)))
        .collect::<Result<_, Error>>()?;
    let references = REFERENCE.map(|tolerance| {
        let mut tight = scenario.for_reference();
        tight.run.push(("rtol".into(), Value::number(tolerance)));
        tight.run.push(("atol".into(), Value::number(tolerance)));
        Plan::new(&tight).map(|plan| run(&plan, &mut |t| progress("reference", t)).trajectory)
    });
    let [reference, looser] = references;
    let (reference, looser) = (reference?, looser?);
    let contenders = plans.into_iter().map(|(method, plan)| {
        let began = Instant::now();
        let outcome = run(&plan, &mut |t| progress(&method, t));
        let time = began.elapsed();
        Contender {
            error: distance(&outcome.trajectory, &reference),
            drifts: drifts(&outcome.trajectory),
            method,
            outcome,
            time,
        }
    });
    Ok(Comparison { contenders: contenders.collect(), floor: distance(&looser, &reference) })
}

/// The largest distance between two runs with the same samples.
fn distance(one: &Trajectory, reference: &Trajectory) -> f64 {
    let width = reference.state_columns();
    let size = |k: usize| reference.rows().fold(0.0, |largest: f64, row| row[k].abs().larger(largest));
    let scales: Vec<f64> = (0..width).map(size).collect();
    if one.len() != reference.len() {
        return f64::NAN;
    }
    let mut largest = 0.0;
    for (a, b) in one.rows().zip(reference.rows()) {
        for k in 1..width {
            let scale = if scales[k] == 0.0 { 1.0 } else { scales[k] };
            let distance = (a[k] - b[k]).abs() / scale;
            if !distance.is_finite() {
                return f64::NAN;
            }
            largest = distance.larger(largest);
        }
    }
    largest
}
