//! The phase portrait of a system without a clock: fixed points, levels of the energy, separatrices, the potential.

mod draw;
mod window;

pub(super) use draw::of_plan;
pub(super) use window::window;

use super::subject::Subject;
use super::{Answer, Progress, Window, rounded, table};
use crate::canonical::scenario_toml;
use crate::error::{Error, input};
use crate::figure::{Curve, Figure, Panel};
use crate::picture::{axis, readable, subtitle};
use crate::plan::Plan;
use crate::scenario::Scenario;
use precess_analysis::{self as analysis, FixedPoint, Kind};
use std::fmt::Write;

/// Which portrait.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PortraitSpec {
    /// `x=-2:2`: the part of the space of states that is looked at; chosen for each number where absent.
    pub windows: Vec<String>,
    /// About how many levels of the energy; 12 where absent.
    pub levels: Option<usize>,
}

/// Numbers of a state beyond which the search for fixed points would be a guess.
const MOST: usize = 8;

/// The fixed points with their eigenvalues, and the picture.
///
/// # Errors
/// Where the scenario or the window makes no sense, or time enters the equations.
pub fn portrait(scenario: &Scenario, spec: &PortraitSpec, progress: Progress) -> Result<Answer, Error> {
    let plan = Plan::new(scenario)?;
    let given = spec.windows.iter().map(|text| Window::parse(text)).collect::<Result<Vec<_>, _>>()?;
    let window = window(&plan, &given)?;
    let drawn = of_plan(&plan, &window, spec.levels, progress)?;
    let state = plan.layout.state();
    let mut columns: Vec<(String, String)> = state.iter().map(|q| (q.name.clone(), q.unit.clone())).collect();
    for k in 1..=state.len() {
        columns.extend([(format!("re{k}"), "1/s".into()), (format!("im{k}"), "1/s".into())]);
    }
    columns.extend([("kind".into(), String::new()), ("stable".into(), String::new())]);
    let columns: Vec<(&str, &str)> = columns.iter().map(|(n, u)| (n.as_str(), u.as_str())).collect();
    let numbers = drawn.points.iter().flat_map(row).collect();
    let potential = potential_panel(&plan, &window);
    let figure = Figure {
        title: format!("{}: phase portrait", plan.title),
        subtitle: subtitle(&plan),
        panels: potential.into_iter().chain([drawn.panel]).collect(),
        scenario: scenario_toml(&plan),
    };
    let mut summary: Vec<String> = drawn.points.iter().map(|p| told(&plan, p)).collect();
    if summary.is_empty() {
        summary.push("no fixed point inside the window".into());
    }
    Ok(Answer { table: table(&columns, numbers), figure, summary, failure: None })
}

fn row(point: &FixedPoint) -> Vec<f64> {
    let mut row = point.state.clone();
    row.extend(point.eigenvalues.iter().flat_map(|e| [e.re, e.im]));
    row.extend([code(point.kind), if point.stable { 1.0 } else { 0.0 }]);
    row
}

/// The kind as a number: 0 centre, 1 saddle, 2 node, 3 focus, 4 degenerate.
fn code(kind: Kind) -> f64 {
    match kind {
        Kind::Centre => 0.0,
        Kind::Saddle => 1.0,
        Kind::Node => 2.0,
        Kind::Focus => 3.0,
        Kind::Degenerate => 4.0,
    }
}

/// `saddle at theta = 3.141593, theta_dot = 0; eigenvalues 3.132, -3.132 1/s`.
fn told(plan: &Plan, point: &FixedPoint) -> String {
    let mut line = match point.kind {
        Kind::Node | Kind::Focus if point.stable => format!("stable {} at ", point.kind.name()),
        Kind::Node | Kind::Focus => format!("unstable {} at ", point.kind.name()),
        kind => format!("{} at ", kind.name()),
    };
    let state = plan.layout.state();
    let places = state.iter().zip(&point.state).map(|(q, x)| format!("{} = {}", q.name, rounded(*x)));
    line.push_str(&places.collect::<Vec<_>>().join(", "));
    let values = point.eigenvalues.iter().map(|e| match e.im {
        0.0 => rounded(e.re),
        im => format!("{} {} {} i", rounded(e.re), if im < 0.0 { '-' } else { '+' }, rounded(im.abs())),
    });
    let _ = write!(line, "; eigenvalues {} 1/s", values.collect::<Vec<_>>().join(", "));
    line
}

/// The potential along the coordinate of one degree of freedom.
fn potential_panel(plan: &Plan, window: &analysis::Window) -> Option<Panel> {
    let place = |name: &str| plan.layout.observables.iter().position(|o| o.quantity.name == name);
    let shape = plan.layout.shape();
    let observable = place("potential").or_else(|| place("energy"))?;
    if (shape.coordinates, shape.state()) != (1, 2) {
        return None;
    }
    let subject = Subject::new(plan).ok()?;
    let (x, y) = analysis::at_rest(subject.field.as_ref(), observable, window, 600).into_iter().unzip();
    Some(Panel {
        title: format!("{} at rest", readable(&plan.layout.observables[observable].quantity.name)),
        x_label: axis(&plan.layout.state()[0]),
        y_label: axis(&plan.layout.observables[observable].quantity),
        x_range: Some(window.ranges[0]),
        curves: vec![Curve { x, y, ..Curve::default() }],
        ..Panel::default()
    })
}

/// Refuses what has no portrait.
fn check(plan: &Plan) -> Result<(), Error> {
    let id = plan.card.id;
    if plan.structure.time_enters {
        return input(format!(
            "a portrait needs equations without a clock, and time enters {id} with these parameters: see poincare"
        ));
    }
    let size = plan.layout.shape().state();
    if size > MOST {
        return input(format!(
            "{id} has {size} numbers of state: fixed points are searched among up to {MOST}"
        ));
    }
    Ok(())
}
