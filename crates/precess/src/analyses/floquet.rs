//! Floquet multipliers of a periodically driven motion, and the tongues of parameters where it is unstable.

use super::subject::{Subject, failed, period, smooth};
use super::{Answer, Progress, Sweep, rounded, sweep, table};
use crate::canonical::scenario_toml;
use crate::error::{Error, input};
use crate::figure::{Curve, Figure, Map, Panel};
use crate::picture::{axis, subtitle};
use crate::plan::Plan;
use crate::scenario::Scenario;
use crate::value::Value;
use precess_analysis::{Multipliers, multipliers};
use precess_scalar::Scalar;

/// Which multipliers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FloquetSpec {
    /// None: the multipliers; one: the largest against a parameter; two: a map of stable and unstable parameters.
    pub sweeps: Vec<String>,
}

/// A modulus this much above one is growth and no rounding.
const GROWS: f64 = 1e-6;

/// The multipliers.
///
/// # Errors
/// Where the scenario or a sweep makes no sense, or there is no drive.
pub fn floquet(scenario: &Scenario, spec: &FloquetSpec, progress: Progress) -> Result<Answer, Error> {
    let plan = Plan::new(scenario)?;
    smooth(&plan, "Floquet multipliers")?;
    let sweeps = spec.sweeps.iter().map(|text| Sweep::parse(text)).collect::<Result<Vec<_>, _>>()?;
    let answer = match &sweeps[..] {
        [] => alone(&plan, progress)?,
        [one] => along(scenario, &plan, one, progress)?,
        [x, y] => tongues(scenario, &plan, [x, y], progress)?,
        _ => return input("at most two parameters are swept at once"),
    };
    let figure = Figure {
        title: format!("{}: Floquet multipliers", plan.title),
        subtitle: subtitle(&plan),
        scenario: scenario_toml(&plan),
        ..answer.figure
    };
    Ok(Answer { figure, ..answer })
}

/// The multipliers of the periodic motion near the start.
fn of_plan(plan: &Plan, progress: Progress) -> Result<(Multipliers, f64), Error> {
    let period = period(plan, "a Floquet multiplier")?;
    let subject = Subject::new(plan)?;
    let mut watch = |_: f64| progress(0.5);
    let flow = subject.flow(&mut watch);
    match multipliers(&flow, &plan.start, period, true) {
        Ok(found) => Ok((found, period)),
        Err(failure) => failed(&failure),
    }
}

fn alone(plan: &Plan, progress: Progress) -> Result<Answer, Error> {
    let (found, period) = of_plan(plan, progress)?;
    let row = |(k, v): (usize, &precess_analysis::Complex)| [(k + 1) as f64, v.re, v.im, v.modulus()];
    let numbers: Vec<f64> = found.values.iter().enumerate().flat_map(row).collect();
    let state = plan.layout.state();
    let orbit: Vec<String> =
        state.iter().zip(&found.state).map(|(q, x)| format!("{} = {}", q.name, rounded(*x))).collect();
    let rate = Scalar::ln(found.largest()) / period;
    let summary = vec![
        format!("periodic motion through {} (period {period:.6} s, gap {:.1e})", orbit.join(", "), found.gap),
        match found.largest() {
            m if m > 1.0 + GROWS => format!("unstable: departures grow by {m:.6} a period, at {rate:.6} 1/s"),
            m if m < 1.0 - GROWS => format!("stable: departures shrink by {m:.6} a period, at {rate:.6} 1/s"),
            _ => "neutral: departures neither grow nor shrink".into(),
        },
    ];
    let circle: Vec<f64> = (0..=360).map(|d| f64::from(d) * std::f64::consts::PI / 180.0).collect();
    let panel = Panel {
        x_label: "Re μ".into(),
        y_label: "Im μ".into(),
        equal_scales: true,
        curves: vec![Curve {
            x: circle.iter().map(|a| Scalar::cos(*a)).collect(),
            y: circle.iter().map(|a| Scalar::sin(*a)).collect(),
            ..Curve::default()
        }],
        marks: found
            .values
            .iter()
            .map(|v| crate::figure::Mark { x: v.re, y: v.im, ink: Some(1), ..crate::figure::Mark::default() })
            .collect(),
        ..Panel::default()
    };
    let columns = [("index", ""), ("re", ""), ("im", ""), ("modulus", "")];
    let figure = Figure { panels: vec![panel], ..Figure::default() };
    Ok(Answer { table: table(&columns, numbers), figure, summary, failure: None })
}

/// The largest modulus along a parameter.
fn along(scenario: &Scenario, plan: &Plan, one: &Sweep, progress: Progress) -> Result<Answer, Error> {
    let quantity = one.quantity(plan)?;
    let (mut x, mut y) = (vec![], vec![]);
    for (k, value) in one.numbers(plan)?.into_iter().enumerate() {
        let _ = progress(k as f64 / one.points as f64);
        let own = sweep::at(scenario, &one.name, value)?;
        x.push(value);
        y.push(of_plan(&own, progress)?.0.largest());
    }
    let grows = y.iter().filter(|m| **m > 1.0 + GROWS).count();
    let summary = vec![format!("unstable at {grows} of {} values", y.len())];
    let numbers = x.iter().zip(&y).flat_map(|(a, b)| [*a, *b]).collect();
    let panel = Panel {
        x_label: axis(&quantity),
        y_label: "largest |μ|".into(),
        curves: vec![Curve { x, y, ..Curve::default() }],
        ..Panel::default()
    };
    let columns = [(quantity.name.as_str(), quantity.unit.as_str()), ("modulus", "")];
    let figure = Figure { panels: vec![panel], ..Figure::default() };
    Ok(Answer { table: table(&columns, numbers), figure, summary, failure: None })
}

/// Stable and unstable over two parameters.
fn tongues(
    scenario: &Scenario,
    plan: &Plan,
    sweeps: [&Sweep; 2],
    progress: Progress,
) -> Result<Answer, Error> {
    let (panel, numbers) = map(scenario, plan, sweeps, progress)?;
    let [x, y] = [sweeps[0].quantity(plan)?, sweeps[1].quantity(plan)?];
    let grows = numbers.chunks(3).filter(|row| row[2] > 1.0 + GROWS).count();
    let summary = vec![format!("unstable at {grows} of {} points", numbers.len() / 3)];
    let columns = [(x.name.as_str(), x.unit.as_str()), (y.name.as_str(), y.unit.as_str()), ("modulus", "")];
    let figure = Figure { panels: vec![panel], ..Figure::default() };
    Ok(Answer { table: table(&columns, numbers), figure, summary, failure: None })
}

/// The map, and the largest modulus at each point, the first parameter running fastest.
pub(super) fn map(
    scenario: &Scenario,
    plan: &Plan,
    [x, y]: [&Sweep; 2],
    progress: Progress,
) -> Result<(Panel, Vec<f64>), Error> {
    let (xs, ys) = (x.numbers(plan)?, y.numbers(plan)?);
    let (mut classes, mut numbers) = (vec![], vec![]);
    for (k, &above) in ys.iter().enumerate() {
        let mut row = scenario.clone();
        Scenario::set(&mut row.parameters, &y.name, Value::number(above));
        for &across in &xs {
            let _ = progress(k as f64 / ys.len() as f64);
            let largest = of_plan(&sweep::at(&row, &x.name, across)?, progress)?.0.largest();
            classes.push(i32::from(largest > 1.0 + GROWS) - 1);
            numbers.extend([across, above, largest]);
        }
    }
    let end = |values: &[f64]| (values[0], values[values.len() - 1]);
    let map = Map { x: end(&xs), y: end(&ys), columns: xs.len(), classes, names: vec!["unstable".into()] };
    let panel = Panel {
        x_label: axis(&x.quantity(plan)?),
        y_label: axis(&y.quantity(plan)?),
        map: Some(map),
        ..Panel::default()
    };
    Ok((panel, numbers))
}
