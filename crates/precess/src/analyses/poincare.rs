//! The Poincaré section of a scenario's motion.

use super::subject::{Subject, forwards, period};
use super::{Answer, Progress};
use crate::canonical::scenario_toml;
use crate::error::{Error, input, quoted};
use crate::figure::{Curve, Figure, Panel, Stroke};
use crate::picture::{axis, subtitle};
use crate::plan::Plan;
use crate::resolve;
use crate::run::{columns, quantity};
use crate::scenario::Scenario;
use crate::value;
use precess_analysis::{Crossing, Crossings, Section, section, strobe};
use precess_system::Trajectory;
use std::f64::consts::TAU;

/// Which section.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PoincareSpec {
    /// `theta = 0`, `theta = 0 mod 2*pi`, `t = 0 mod period`.
    pub section: String,
    /// `rising`, `falling` or `either` (where absent).
    pub direction: Option<String>,
    /// Horizontal quantity of the picture; the first coordinate that is not the section's own where absent.
    pub x: Option<String>,
    /// Vertical one; the velocity of the horizontal one where absent.
    pub y: Option<String>,
}

/// A section held against a plan.
struct Cut {
    column: usize,
    value: f64,
    period: Option<f64>,
}

/// All passages: time and state.
///
/// # Errors
/// Where the scenario or the section makes no sense.
pub fn poincare(scenario: &Scenario, spec: &PoincareSpec, progress: Progress) -> Result<Answer, Error> {
    let plan = Plan::new(scenario)?;
    let ((crossings, failure), panel) = of_plan(&plan, spec, progress)?;
    let state = plan.layout.shape().state();
    let table = Trajectory {
        columns: columns(&plan).first(1 + state),
        numbers: crossings
            .iter()
            .flat_map(|c| std::iter::once(c.t).chain(c.state[..state].to_vec()))
            .collect(),
        events: vec![],
    };
    let figure = Figure {
        title: plan.title.clone(),
        subtitle: subtitle(&plan),
        panels: vec![panel],
        scenario: scenario_toml(&plan),
    };
    let summary = vec![format!("{} passages through {}", crossings.len(), spec.section.trim())];
    Ok(Answer { table, figure, summary, failure: failure.map(|f| f.to_string()) })
}

/// The passages of a plan's motion, and their panel.
pub(super) fn of_plan(
    plan: &Plan,
    spec: &PoincareSpec,
    progress: Progress,
) -> Result<(Crossings, Panel), Error> {
    forwards(plan)?;
    let cut = cut(plan, &spec.section)?;
    let direction = resolve::direction(spec.direction.as_deref().unwrap_or("either"))?;
    let subject = Subject::new(plan)?;
    let mut share = |t: f64| progress(t / plan.until);
    let flow = subject.flow(&mut share);
    let found: Crossings = match (cut.column, cut.period) {
        (0, Some(period)) => {
            let first = cut.value - (cut.value / period).floor() * period;
            strobe(&flow, &plan.start, plan.until, (first, period))
        }
        (column, period) => {
            let quantity = quantity(plan, subject.field.as_ref(), column);
            let at = Section { quantity: &quantity, value: cut.value, period, direction };
            section(&flow, &plan.start, plan.until, &at)
        }
    };
    let [x, y] = axes(plan, &cut, spec)?;
    let quantities = plan.columns();
    // Values and label of an axis; an angle is drawn without its turns.
    let of = |k: usize| {
        let quantity = quantity(plan, subject.field.as_ref(), k);
        let values: Vec<f64> = found.0.iter().map(|c| quantity(c.t, &c.state)).collect();
        let label = axis(&quantities[k]);
        if turns(&subject, k, &found.0) {
            return (values.iter().map(|x| x - (x / TAU).round() * TAU).collect(), format!("{label} mod 2π"));
        }
        (values, label)
    };
    let ((x, x_label), (y, y_label)) = (of(x), of(y));
    let panel = Panel {
        title: format!("Section {}", spec.section.trim()),
        x_label,
        y_label,
        curves: vec![Curve { x, y, stroke: Stroke::Dots, ..Curve::default() }],
        ..Panel::default()
    };
    Ok((found, panel))
}

/// `theta = 0 mod 2*pi`.
fn cut(plan: &Plan, text: &str) -> Result<Cut, Error> {
    let at = |e: Error| e.at(&format!("section {}", quoted(text)));
    let Some((name, rest)) = text.split_once('=') else {
        return input("a section is written as \"theta = 0\" or \"theta = 0 mod 2*pi\"").map_err(at);
    };
    let column = resolve::column(plan, name.trim()).map_err(at)?;
    let unit = plan.column(column).unit;
    let (value, again) = rest.split_once("mod").map_or((rest, None), |(value, p)| (value, Some(p.trim())));
    let number = |text: &str| value::parse(text.trim()).and_then(|v| v.in_unit(&unit)).map_err(at);
    let value = number(value)?;
    let period = match again {
        None => None,
        Some("period") if column == 0 => Some(period(plan, "'mod period'").map_err(at)?),
        Some(text) => Some(number(text)?),
    };
    if period.is_some_and(|p| p <= 0.0) {
        return input("a period is above zero").map_err(at);
    }
    Ok(Cut { column, value, period })
}

/// Whether a column is an angle that has gone round: a coordinate after a turn of which all rates are the same.
fn turns(subject: &Subject, column: usize, crossings: &[Crossing]) -> bool {
    let shape = subject.plan.layout.shape();
    let Some(i) = column.checked_sub(1).filter(|i| *i < shape.coordinates) else { return false };
    let radians = subject.plan.layout.state()[i].unit == "rad";
    let round = crossings.iter().any(|c| c.state[i].abs() > TAU / 2.0);
    let rate = |t: f64, y: &[f64]| {
        let mut rate = vec![0.0; y.len()];
        subject.field.rate(t, y, &mut rate);
        rate
    };
    let mut same = true;
    for c in crossings.iter().take(20) {
        let mut turned = c.state.clone();
        turned[i] += TAU;
        let pairs = rate(c.t, &c.state).into_iter().zip(rate(c.t, &turned));
        same &= pairs.into_iter().all(|(a, b)| (a - b).abs() <= 1e-9 * (1.0 + a.abs()));
    }
    // Nothing depends on a cyclic coordinate, be it a length or an angle.
    round && same && (radians || !subject.plan.structure.cyclic[i])
}

/// What is drawn against what.
fn axes(plan: &Plan, cut: &Cut, spec: &PoincareSpec) -> Result<[usize; 2], Error> {
    let shape = plan.layout.shape();
    let x = match &spec.x {
        Some(name) => resolve::column(plan, name)?,
        None => (1..=shape.coordinates).find(|&k| k != cut.column).unwrap_or(1),
    };
    let velocity = shape.pairs().find(|(i, _)| i + 1 == x).map(|(_, v)| v + 1);
    let other = (1..=shape.state()).find(|&k| k != cut.column && k != x);
    let y = match &spec.y {
        Some(name) => resolve::column(plan, name)?,
        None => velocity.filter(|&k| k != cut.column).or(other).unwrap_or(x),
    };
    Ok([x, y])
}
