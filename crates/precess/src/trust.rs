//! How far a run can be trusted: until it leaves its shadow, the same motion in double-double.
//!
//! A run departs from the motion that its equations and start determine, by the error of its steps and by rounding; chaos makes
//! both grow exponentially. The shadow has twice the digits and a tolerance of 1e-22, so up to the horizon its own error
//! does not count.

use crate::answer::{Answer, Progress, table};
use crate::canonical::scenario_toml;
use crate::error::{Error, input};
use crate::figure::{Curve, Figure, Panel, Stroke};
use crate::picture::{axis, subtitle};
use crate::plan::Plan;
use crate::premises::{failed, forwards, smooth};
use crate::run::run;
use crate::scenario::Scenario;
use crate::value::shortest;
use precess_integrate::{Samples, Shadow};
use precess_scalar::{Tape, Traced};
use precess_system::Rates;
use std::cell::Cell;
use std::ops::{ControlFlow, Range};
use std::sync::Arc;

/// Tolerance of the shadow.
const TOLERANCE: f64 = 1e-22;
/// A shadow of more numbers than this takes hours.
const MOST_NUMBERS: usize = 1000;
/// The ink of what cannot be trusted: grey.
const GREY: usize = 7;

/// The distance between a run and its shadow at every sample (columns `t`, `error`, and `trusted`: one up to the horizon, zero
/// beyond), and the horizon: the last sample up to which the error stays `within`. The error is the largest of the state's
/// numbers, each as a share of the largest size so far of those with its unit; one radian is the most that counts for the size
/// of an angle, since many turns make it no more certain.
///
/// # Errors
/// Where the scenario makes no sense, has jumps, runs backwards, or the shadow cannot be integrated.
pub fn trust(scenario: &Scenario, within: f64, progress: Progress) -> Result<Answer, Error> {
    let plan = Plan::new(scenario)?;
    smooth(&plan, "a shadow")?;
    forwards(&plan)?;
    if !(within.is_finite() && within > 0.0) {
        return input(format!("the error that is borne must be above zero, not {within}"));
    }
    let shape = plan.layout.shape();
    if shape.full() > MOST_NUMBERS {
        return input(format!(
            "a shadow takes states of at most {MOST_NUMBERS} numbers, not {}",
            shape.full()
        ));
    }
    // The shadow takes nearly all of the time.
    let outcome = run(&plan, &mut |_| progress(0.0));
    let samples = Samples::new(plan.until, plan.every);
    let rows: Vec<&[f64]> = outcome.trajectory.rows().collect();
    // A watch that stops a run records where it does; the shadow is not sampled there.
    let rows: Vec<&[f64]> =
        (0..).zip(rows).take_while(|(k, row)| row[0] == samples.time(*k)).map(|(_, row)| row).collect();
    let (equations, parameters) = equations(&plan);
    let shadow = Shadow {
        equations: Arc::new(equations),
        start: &[&plan.start[..], &parameters].concat(),
        reported: shape.state(),
        skip: (0..plan.start.len() + parameters.len()).map(|i| i >= plan.start.len()).collect(),
        samples,
        tolerance: TOLERANCE,
    };
    let mut shadows: Vec<Vec<f64>> = vec![];
    let mut record = |y: Vec<f64>| {
        shadows.push(y);
        // A run that has ended needs no shadow any more.
        if shadows.len() < rows.len() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    };
    if let Err(failure) = shadow.run(&mut record, &mut |t| progress(t / plan.until)) {
        return failed(&failure);
    }
    let errors = errors(&plan, &rows, &shadows);
    // An error that is NaN is not borne.
    let trusted = errors.iter().take_while(|error| **error <= within).count();
    let numbers = rows.iter().zip(&errors).enumerate();
    let numbers =
        numbers.flat_map(|(k, (row, e))| [row[0], *e, if k < trusted { 1.0 } else { 0.0 }]).collect();
    let figure = Figure {
        title: format!("{}: how far to trust", plan.title),
        subtitle: subtitle(&plan),
        panels: panels(&plan, &rows, &shadows, &errors, trusted, within),
        scenario: scenario_toml(&plan),
    };
    let summary = vec![summary(&rows, &errors, trusted, within)];
    let failure = outcome.failure.map(|failure| failure.to_string());
    Ok(Answer {
        table: table(&[("t", "s"), ("error", ""), ("trusted", "")], numbers),
        figure,
        summary,
        failure,
    })
}

fn summary(rows: &[&[f64]], errors: &[f64], trusted: usize, within: f64) -> String {
    match trusted.checked_sub(1) {
        None => format!("not trusted at all: the first error exceeds {within:?}"),
        Some(last) if trusted == rows.len() => {
            format!(
                "trusted to the end, t = {} s: the relative error there is {:.1e}",
                shortest(rows[last][0]),
                errors[last]
            )
        }
        Some(last) => {
            format!(
                "trusted up to t = {} s: beyond, the relative error exceeds {within:?}",
                shortest(rows[last][0])
            )
        }
    }
}

/// The equations with their parameters as numbers of the state that rest: a literal would be rounded with its
/// neighbours to one double. Zero and one lose nothing, and without them terms vanish.
fn equations(plan: &Plan) -> (Tape, Vec<f64>) {
    let full = plan.layout.shape().full();
    let is_literal = |x: f64| x == 0.0 || x == 1.0;
    let numbers = plan.values.numbers.iter().chain(plan.values.lists.iter().flat_map(|list| &list.items));
    let parameters: Vec<f64> = numbers.copied().filter(|x| !is_literal(*x)).collect();
    let tape = Tape::record(1 + full + parameters.len(), |x| {
        let next = Cell::new(1 + full);
        // In the order of the parameters above.
        let values = plan.values.map(|&value| {
            if is_literal(value) { Traced::from(value) } else { x[next.replace(next.get() + 1)] }
        });
        let mut rates = Rates::rates(plan.system, values, &plan.layout, x[0], &x[1..=full]).0;
        rates.resize(x.len() - 1, Traced::from(0.0));
        rates
    });
    (tape.simplified(), parameters)
}

/// The relative error of each sample.
fn errors(plan: &Plan, rows: &[&[f64]], shadows: &[Vec<f64>]) -> Vec<f64> {
    let state = plan.layout.state();
    let units: Vec<&str> = state.iter().map(|q| q.unit.as_str()).collect();
    // The first number of each unit keeps the size of all.
    let group: Vec<usize> = units.iter().map(|u| units.iter().position(|v| u == v).unwrap_or(0)).collect();
    let mut sizes = vec![0.0; units.len()];
    let mut error = |row: &[f64], shadow: &[f64]| {
        for (i, z) in row.iter().chain(shadow).map(|z| z.abs()).enumerate() {
            let i = i % units.len();
            let z = if units[i] == "rad" && z > 1.0 { 1.0 } else { z };
            let size = &mut sizes[group[i]];
            *size = if z > *size { z } else { *size };
        }
        let errors = row.iter().zip(shadow).zip(&group);
        errors.fold(0.0_f64, |most, ((x, y), &group)| {
            let error = if x == y { 0.0 } else { (x - y).abs() / sizes[group] };
            if error <= most { most } else { error }
        })
    };
    rows.iter().zip(shadows).map(|(row, shadow)| error(&row[1..=units.len()], shadow)).collect()
}

/// The first coordinate, grey where it is not to be trusted, and the error.
fn panels(
    plan: &Plan,
    rows: &[&[f64]],
    shadows: &[Vec<f64>],
    errors: &[f64],
    trusted: usize,
    within: f64,
) -> Vec<Panel> {
    let times: Vec<f64> = rows.iter().map(|row| row[0]).collect();
    let run: Vec<f64> = rows.iter().map(|row| row[1]).collect();
    let shadow: Vec<f64> = shadows.iter().map(|y| y[0]).collect();
    let curve = |label: &str, range: Range<usize>, y: &[f64], ink, stroke| Curve {
        label: label.into(),
        x: times[range.clone()].to_vec(),
        y: y[range].to_vec(),
        ink: Some(ink),
        stroke,
    };
    let all = 0..times.len();
    let mut curves = vec![curve("trusted", 0..trusted, &run, 0, Stroke::Line)];
    if trusted < times.len() {
        // Both parts meet in a point.
        let rest = trusted.saturating_sub(1)..times.len();
        curves.push(curve("not trusted", rest.clone(), &run, GREY, Stroke::Line));
        curves.push(curve("shadow", rest, &shadow, 1, Stroke::Dashed));
    }
    let bound = vec![within; times.len()];
    vec![
        Panel { x_label: "t [s]".into(), y_label: axis(&plan.column(1)), curves, ..Panel::default() },
        Panel {
            title: "Distance from the shadow".into(),
            x_label: "t [s]".into(),
            y_label: "relative error".into(),
            logarithmic: true,
            curves: vec![
                curve("error", all.clone(), errors, 0, Stroke::Line),
                curve("borne", all, &bound, GREY, Stroke::Dashed),
            ],
            ..Panel::default()
        },
    ]
}
