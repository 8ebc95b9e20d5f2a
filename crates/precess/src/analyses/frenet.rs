//! The frames that move along a plane path: Frenet's, tangent and normal, and the polar one (P, section 9).
//!
//! ```text
//! a = v' T + v^2 / R N        a = (r'' - r theta'^2) R + (2 r' theta' + r theta'') S
//! ```
//!
//! Velocity and acceleration of any two quantities come from the equations: a state of dual numbers moves with its rate,
//! and the second derivative of an observable is the slope of its slope.

mod motion;

use super::subject::Subject;
use super::{Answer, Progress, table};
use crate::canonical::scenario_toml;
use crate::error::{Error, input};
use crate::figure::{Curve, Figure, Mark, Panel, Stroke};
use crate::picture::{axis, subtitle};
use crate::plan::Plan;
use crate::resolve;
use crate::run::run;
use crate::scenario::Scenario;
use motion::{Motion, motion};
use precess_scalar::Scalar;
use precess_system::View;

/// Which path.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FrenetSpec {
    /// Horizontal quantity; that of the card's first plane path where absent.
    pub x: Option<String>,
    /// Vertical one.
    pub y: Option<String>,
}

/// Speed, accelerations in both frames, curvature and centre of curvature at every sample.
///
/// # Errors
/// Where the scenario makes no sense, or no plane path is known or given.
pub fn frenet(scenario: &Scenario, spec: &FrenetSpec, progress: Progress) -> Result<Answer, Error> {
    let plan = Plan::new(scenario)?;
    let [x, y] = plane(&plan, spec)?;
    let subject = Subject::new(&plan)?;
    let mut share = |t: f64| progress(t / plan.until);
    let outcome = run(&plan, &mut share);
    let motions: Vec<(f64, Motion)> =
        outcome.trajectory.rows().map(|row| (row[0], motion(&subject, row, [x, y]))).collect();
    let row = |(t, m): &(f64, Motion)| {
        let ([px, py], [cx, cy]) = (m.place, m.centre());
        let frenet = [m.speed(), m.tangential(), m.normal(), m.curvature(), cx, cy];
        [&[*t, px, py], &frenet[..], &[m.radial(), m.transverse()]].concat()
    };
    let columns = plan.columns();
    let unit = columns[x].unit.clone();
    let per = |more: &str| if unit.is_empty() { String::new() } else { format!("{unit}{more}") };
    let (speed, acceleration) = (per("/s"), per("/s^2"));
    let curvature = if unit.is_empty() { String::new() } else { format!("1/{unit}") };
    let names = [
        ("t", "s"),
        (columns[x].name.as_str(), unit.as_str()),
        (columns[y].name.as_str(), unit.as_str()),
        ("speed", speed.as_str()),
        ("tangential", acceleration.as_str()),
        ("normal", acceleration.as_str()),
        ("curvature", curvature.as_str()),
        ("centre_x", unit.as_str()),
        ("centre_y", unit.as_str()),
        ("radial", acceleration.as_str()),
        ("transverse", acceleration.as_str()),
    ];
    let figure = Figure {
        title: format!("{}: Frenet's frame", plan.title),
        subtitle: subtitle(&plan),
        panels: panels(&plan, [x, y], &motions),
        scenario: scenario_toml(&plan),
    };
    let tightest = motions.iter().map(|(t, m)| (m.curvature().abs(), *t)).max_by(|a, b| a.0.total_cmp(&b.0));
    let summary =
        tightest.map(|(k, t)| format!("smallest radius of curvature {:.6} at t = {t:.4} s", 1.0 / k));
    Ok(Answer {
        table: table(&names, motions.iter().flat_map(row).collect()),
        figure,
        summary: summary.into_iter().collect(),
        failure: outcome.failure.map(|f| f.to_string()),
    })
}

/// The columns of the path.
fn plane(plan: &Plan, spec: &FrenetSpec) -> Result<[usize; 2], Error> {
    let pair = match (&spec.x, &spec.y) {
        (Some(x), Some(y)) => Some((x.clone(), y.clone())),
        (None, None) => path(plan),
        _ => return input("a plane path has both x and y"),
    };
    let Some((x, y)) = pair else {
        return input(format!("{} has no plane path of its own: give x and y", plan.card.id));
    };
    let columns = [resolve::column(plan, &x)?, resolve::column(plan, &y)?];
    let units = columns.map(|k| plan.column(k).unit);
    if columns.contains(&0) || units[0] != units[1] {
        return input(format!("{x} and {y} are no coordinates of one plane"));
    }
    Ok(columns)
}

/// The first view of the card that is a plane of one unit and no phase plane.
fn path(plan: &Plan) -> Option<(String, String)> {
    plan.card.views.iter().find_map(|view| match view {
        View::Plane { pairs, equal_scales: true } => {
            let (x, y) = pairs.first()?;
            Some((x.replace('*', "1"), y.replace('*', "1")))
        }
        _ => None,
    })
}

/// Circles that are drawn along a path, and points of each.
const CIRCLES: usize = 6;
const POINTS: u32 = 180;

fn panels(plan: &Plan, [x, y]: [usize; 2], motions: &[(f64, Motion)]) -> Vec<Panel> {
    let columns = plan.columns();
    let times: Vec<f64> = motions.iter().map(|(t, _)| *t).collect();
    let of = |label: &str, get: &dyn Fn(&Motion) -> f64| Curve {
        label: label.into(),
        x: times.clone(),
        y: motions.iter().map(|(_, m)| get(m)).collect(),
        ..Curve::default()
    };
    let (px, py) = motions.iter().map(|(_, m)| (m.place[0], m.place[1])).unzip();
    let mut path = Panel {
        title: "The path, and circles of curvature".into(),
        x_label: axis(&columns[x]),
        y_label: axis(&columns[y]),
        equal_scales: true,
        curves: vec![Curve { x: px, y: py, ..Curve::default() }],
        ..Panel::default()
    };
    (path.x_range, path.y_range) = (wide(&path.curves[0].x), wide(&path.curves[0].y));
    for k in 0..CIRCLES {
        let Some((_, m)) = motions.get(k * motions.len() / CIRCLES) else { continue };
        path.curves.push(circle(m, 1 + k));
        let [x, y] = m.place;
        path.marks.push(Mark { x, y, ink: Some(1 + k), ..Mark::default() });
    }
    vec![
        path,
        Panel {
            title: "Acceleration in Frenet's frame".into(),
            x_label: "t [s]".into(),
            curves: vec![of("tangential", &Motion::tangential), of("normal", &Motion::normal)],
            ..Panel::default()
        },
        Panel {
            title: "Acceleration in the polar frame".into(),
            x_label: "t [s]".into(),
            curves: vec![of("radial", &Motion::radial), of("transverse", &Motion::transverse)],
            ..Panel::default()
        },
        Panel {
            title: "Curvature".into(),
            x_label: "t [s]".into(),
            curves: vec![of("curvature", &Motion::curvature)],
            ..Panel::default()
        },
    ]
}

/// The range of some values with a quarter more on either side.
fn wide(values: &[f64]) -> Option<(f64, f64)> {
    let fold = |(low, high): (f64, f64), x: &f64| (low.smaller(*x), high.larger(*x));
    let (low, high) = values.iter().filter(|x| x.is_finite()).fold((f64::INFINITY, f64::NEG_INFINITY), fold);
    let air = (high - low) * 0.25;
    (air > 0.0).then_some((low - air, high + air))
}

fn circle(m: &Motion, ink: usize) -> Curve {
    let ([cx, cy], radius) = (m.centre(), 1.0 / m.curvature());
    let at = |k: u32| Scalar::sin_cos(std::f64::consts::TAU * f64::from(k) / f64::from(POINTS));
    let (x, y) = (0..=POINTS).map(at).map(|(sin, cos)| (cx + radius * cos, cy + radius * sin)).unzip();
    Curve { x, y, ink: Some(ink), stroke: Stroke::Dashed, ..Curve::default() }
}

/// The circle of curvature at a sample of a run.
pub(crate) fn osculating(plan: &Plan, row: &[f64], columns: [usize; 2], ink: usize) -> Option<Curve> {
    let subject = Subject::new(plan).ok()?;
    columns.iter().all(|k| *k > 0).then(|| circle(&motion(&subject, row, columns), ink))
}
