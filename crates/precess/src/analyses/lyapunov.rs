//! The Lyapunov spectrum of a scenario's motion.

use super::subject::{Subject, failed, forwards, smooth};
use super::{Answer, Progress, table};
use crate::canonical::scenario_toml;
use crate::error::Error;
use crate::figure::{Curve, Figure, Panel};
use crate::picture::subtitle;
use crate::plan::Plan;
use crate::scenario::Scenario;
use std::fmt::Write;

/// All exponents with their errors.
///
/// # Errors
/// Where the scenario makes no sense, has jumps, or cannot be integrated.
pub fn lyapunov(scenario: &Scenario, progress: Progress) -> Result<Answer, Error> {
    let plan = Plan::new(scenario)?;
    smooth(&plan, "a Lyapunov spectrum")?;
    forwards(&plan)?;
    let subject = Subject::new(&plan)?;
    let mut share = |t: f64| progress(t / plan.until);
    let flow = subject.flow(&mut share);
    let found = match precess_analysis::lyapunov(&flow, &plan.start, plan.until) {
        Ok(found) => found,
        Err(failure) => return failed(&failure),
    };
    let rows = found.exponents.iter().enumerate();
    let numbers = rows.flat_map(|(k, e)| [(k + 1) as f64, e.value, e.error]).collect();
    let sum = found.exponents.iter().fold(0.0, |sum, e| sum + e.value);
    let mut summary = vec![];
    for (k, e) in found.exponents.iter().enumerate() {
        let mut line = String::new();
        let _ = write!(line, "lambda{} = {:.6} +- {:.1e} 1/s", k + 1, e.value, e.error);
        summary.push(line);
    }
    summary.push(format!("sum = {sum:.9} 1/s, the mean divergence of the equations"));
    if let Some(first) = found.exponents.first().filter(|e| e.value > e.error) {
        summary
            .push(format!("neighbours move apart by e in {:.3} s: the motion is chaotic", 1.0 / first.value));
    }
    let curves = found.history.iter().enumerate().map(|(k, mean)| Curve {
        label: format!("λ{}", k + 1),
        x: found.times.clone(),
        y: mean.clone(),
        ..Curve::default()
    });
    let panel = Panel {
        x_label: "t [s]".into(),
        y_label: "mean growth [1/s]".into(),
        curves: curves.collect(),
        ..Panel::default()
    };
    let figure = Figure {
        title: format!("{}: Lyapunov exponents", plan.title),
        subtitle: subtitle(&plan),
        panels: vec![panel],
        scenario: scenario_toml(&plan),
    };
    let table = table(&[("index", ""), ("exponent", "1/s"), ("error", "1/s")], numbers);
    Ok(Answer { table, figure, summary, failure: None })
}
