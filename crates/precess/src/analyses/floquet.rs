//! Floquet multipliers of a periodically driven motion, and the tongues of parameters where it is unstable.

use super::subject::{Subject, failed, period, smooth};
use super::{Answer, Progress, Sweep, rounded, sweep, table};
use crate::canonical::scenario_toml;
use crate::error::{Error, input};
use crate::figure::{Curve, Figure, Map, Panel};
use crate::picture::{axis, subtitle};
use crate::plan::Plan;
use crate::scenario::Scenario;
use precess_analysis::{Multipliers, multipliers};
use precess_scalar::Scalar;
use std::ops::Range;

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
    if !spec.sweeps.is_empty() {
        let moduli = floquet_part(scenario, spec, 0..floquet_points(spec)?, progress)?;
        return floquet_whole(scenario, spec, &moduli);
    }
    let plan = Plan::new(scenario)?;
    smooth(&plan, "Floquet multipliers")?;
    alone(&plan, progress)
}

/// At how many values of the parameters a sweep asks.
///
/// # Errors
/// Where a sweep makes no sense.
pub fn floquet_points(spec: &FloquetSpec) -> Result<usize, Error> {
    Ok(sweeps(spec)?.iter().map(|sweep| sweep.points).product())
}

fn sweeps(spec: &FloquetSpec) -> Result<Vec<Sweep>, Error> {
    if spec.sweeps.len() > 2 {
        return input("at most two parameters are swept at once");
    }
    spec.sweeps.iter().map(|text| Sweep::parse(text)).collect()
}

/// The largest modulus at some points of a sweep, the first parameter running fastest: each is found alone, so a sweep may
/// be cut anywhere.
///
/// # Errors
/// As [`floquet`].
pub fn floquet_part(
    scenario: &Scenario,
    spec: &FloquetSpec,
    points: Range<usize>,
    progress: Progress,
) -> Result<Vec<f64>, Error> {
    let plan = Plan::new(scenario)?;
    smooth(&plan, "Floquet multipliers")?;
    let sweeps = sweeps(spec)?;
    let values = sweeps.iter().map(|sweep| sweep.numbers(&plan)).collect::<Result<Vec<_>, _>>()?;
    let (first, count) = (points.start, points.len());
    let modulus = |point: usize| {
        let mut rest = point;
        let place = |(sweep, values): (&Sweep, &Vec<f64>)| {
            let value = values[rest % values.len()];
            rest /= values.len();
            (sweep.name.clone(), value)
        };
        let at: Vec<_> = sweeps.iter().zip(&values).map(place).collect();
        let share = (point - first) as f64 / count as f64;
        Ok(of_plan(&sweep::at(scenario, &at)?, share, progress)?.0.largest())
    };
    points.map(modulus).collect()
}

/// The answer from the moduli at all points.
///
/// # Errors
/// As [`floquet`], and where they are not as many as there are points.
pub fn floquet_whole(scenario: &Scenario, spec: &FloquetSpec, moduli: &[f64]) -> Result<Answer, Error> {
    let plan = Plan::new(scenario)?;
    let points = floquet_points(spec)?;
    if moduli.len() != points {
        return input(format!("{points} points have one modulus each, not {}", moduli.len()));
    }
    let answer = match &sweeps(spec)?[..] {
        [one] => along(&plan, one, moduli)?,
        [x, y] => tongues(&plan, [x, y], moduli)?,
        _ => return input("one parameter or two are swept here"),
    };
    Ok(titled(&plan, answer))
}

fn titled(plan: &Plan, answer: Answer) -> Answer {
    let figure = Figure {
        title: format!("{}: Floquet multipliers", plan.title),
        subtitle: subtitle(plan),
        scenario: scenario_toml(plan),
        ..answer.figure
    };
    Answer { figure, ..answer }
}

/// The multipliers of the periodic motion near the start.
fn of_plan(plan: &Plan, share: f64, progress: Progress) -> Result<(Multipliers, f64), Error> {
    let period = period(plan, "a Floquet multiplier")?;
    let subject = Subject::new(plan)?;
    let mut watch = |_: f64| progress(share);
    let flow = subject.flow(&mut watch);
    match multipliers(&flow, &plan.start, period, true) {
        Ok(found) => Ok((found, period)),
        Err(failure) => failed(&failure),
    }
}

fn alone(plan: &Plan, progress: Progress) -> Result<Answer, Error> {
    let (found, period) = of_plan(plan, 0.5, progress)?;
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
    Ok(titled(plan, Answer { table: table(&columns, numbers), figure, summary, failure: None }))
}

/// The largest modulus along a parameter.
fn along(plan: &Plan, one: &Sweep, moduli: &[f64]) -> Result<Answer, Error> {
    let quantity = one.quantity(plan)?;
    let (x, y) = (one.numbers(plan)?, moduli.to_vec());
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
fn tongues(plan: &Plan, sweeps: [&Sweep; 2], moduli: &[f64]) -> Result<Answer, Error> {
    let [x, y] = [sweeps[0].quantity(plan)?, sweeps[1].quantity(plan)?];
    let [xs, ys] = [sweeps[0].numbers(plan)?, sweeps[1].numbers(plan)?];
    let point = |(k, modulus): (usize, &f64)| [xs[k % xs.len()], ys[k / xs.len()], *modulus];
    let numbers = moduli.iter().enumerate().flat_map(point).collect();
    let grows = moduli.iter().filter(|m| **m > 1.0 + GROWS).count();
    let summary = vec![format!("unstable at {grows} of {} points", moduli.len())];
    let columns = [(x.name.as_str(), x.unit.as_str()), (y.name.as_str(), y.unit.as_str()), ("modulus", "")];
    let figure = Figure { panels: vec![mapped(plan, sweeps, moduli)?], ..Figure::default() };
    Ok(Answer { table: table(&columns, numbers), figure, summary, failure: None })
}

/// The map over two sweeps.
pub(super) fn map(scenario: &Scenario, spec: &FloquetSpec, progress: Progress) -> Result<Panel, Error> {
    let [x, y] = &sweeps(spec)?[..] else { return input("a map goes over two parameters") };
    let moduli = floquet_part(scenario, spec, 0..floquet_points(spec)?, progress)?;
    mapped(&Plan::new(scenario)?, [x, y], &moduli)
}

fn mapped(plan: &Plan, [x, y]: [&Sweep; 2], moduli: &[f64]) -> Result<Panel, Error> {
    let (xs, ys) = (x.numbers(plan)?, y.numbers(plan)?);
    let classes = moduli.iter().map(|m| i32::from(*m > 1.0 + GROWS) - 1).collect();
    let end = |values: &[f64]| (values[0], values[values.len() - 1]);
    let map = Map { x: end(&xs), y: end(&ys), columns: xs.len(), classes, names: vec!["unstable".into()] };
    Ok(Panel {
        x_label: axis(&x.quantity(plan)?),
        y_label: axis(&y.quantity(plan)?),
        map: Some(map),
        ..Panel::default()
    })
}
