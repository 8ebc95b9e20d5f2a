//! The phase portrait of a system without a clock: fixed points, levels of the energy, separatrices, the potential.

use super::subject::Subject;
use super::{Answer, Progress, Window, rounded, table};
use crate::canonical::scenario_toml;
use crate::error::{Error, input, unknown};
use crate::figure::{Curve, Figure, Mark, Panel, Sign, Stroke};
use crate::picture::{axis, readable, subtitle};
use crate::plan::Plan;
use crate::run::run;
use crate::scenario::Scenario;
use precess_analysis::{self as analysis, FixedPoint, Flow, Kind};
use precess_scalar::Scalar;
use std::fmt::Write;
use std::ops::ControlFlow;

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

/// A portrait that has been found.
pub(super) struct Portrait {
    pub points: Vec<FixedPoint>,
    pub panel: Panel,
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

/// The portrait of a plan's system inside a window.
pub(super) fn of_plan(
    plan: &Plan,
    window: &analysis::Window,
    levels: Option<usize>,
    progress: Progress,
) -> Result<Portrait, Error> {
    check(plan)?;
    let subject = Subject::new(plan)?;
    let mut watch = |_: f64| progress(0.5);
    let flow = subject.flow(&mut watch);
    let shape = plan.layout.shape();
    let modes = &plan.start[shape.state()..];
    let points = analysis::fixed_points(&flow, modes, window);
    let state = plan.layout.state();
    let plane = shape.state() >= 2;
    let mut panel = Panel {
        x_label: axis(&state[0]),
        y_label: if plane { axis(&state[1]) } else { String::new() },
        x_range: Some(window.ranges[0]),
        y_range: plane.then(|| window.ranges[1]),
        ..Panel::default()
    };
    if !plane {
        return Ok(Portrait { points, panel });
    }
    let wanted = levels.unwrap_or(12);
    match level(plan) {
        Some(observable) => panel.curves.extend(level_curves(&subject, observable, window, &points, wanted)),
        None if shape.state() == 2 && wanted > 0 => panel.curves.extend(flow_curves(&flow, window)),
        None => {}
    }
    if shape.state() == 2 {
        let span = plan.until.abs().larger(20.0);
        for branch in analysis::separatrices(&flow, &points, window, span) {
            let (x, y) = branch.line.into_iter().unzip();
            panel.curves.push(Curve { x, y, ink: Some(1), ..Curve::default() });
        }
    }
    panel.marks = points.iter().map(|p| mark(p, points.len() <= 5)).collect();
    Ok(Portrait { points, panel })
}

/// A fixed point as it is drawn.
fn mark(point: &FixedPoint, named: bool) -> Mark {
    let sign = match point.kind {
        Kind::Saddle => Sign::Cross,
        Kind::Node | Kind::Focus if !point.stable => Sign::Ring,
        _ => Sign::Dot,
    };
    let label = if named { point.kind.name().into() } else { String::new() };
    Mark { label, x: point.state[0], y: point.state[1], sign, ink: None }
}

/// The observable whose levels are drawn: the energy where it stays, over one degree of freedom; over two, the
/// potential.
fn level(plan: &Plan) -> Option<usize> {
    let shape = plan.layout.shape();
    let place = |name: &str| plan.layout.observables.iter().position(|o| o.quantity.name == name);
    let energy = place("energy");
    match (shape.coordinates, shape.state()) {
        (1, 2) => energy.filter(|&k| plan.is_invariant(k)),
        (2, 4) => place("potential").or(energy),
        _ => None,
    }
}

/// Points of a side of the grid on which levels are found.
const GRID: usize = 301;

/// Levels through evenly spaced points above the deepest point of rest, so that the lines lie evenly; and those below
/// it, where there are any, through points of the axis.
fn level_curves(
    subject: &Subject,
    observable: usize,
    window: &analysis::Window,
    points: &[FixedPoint],
    wanted: usize,
) -> Vec<Curve> {
    let field = subject.field.as_ref();
    let mut state = subject.plan.start.clone();
    let mut observed = vec![0.0; field.shape().observables];
    let mut value = |x: f64, y: f64| {
        state.fill(0.0);
        (state[0], state[1]) = (x, y);
        field.observe(0.0, &state, &mut observed);
        observed[observable]
    };
    let ([x, y], n) = ([window.ranges[0], window.ranges[1]], wanted as f64);
    let rests = points.iter().filter(|p| p.stable || p.kind == Kind::Centre);
    let deepest = rests.map(|p| (value(p.state[0], p.state[1]), p)).min_by(|a, b| a.0.total_cmp(&b.0));
    let middle = ((x.0 + x.1) * 0.5, (y.0 + y.1) * 0.5);
    let (floor, from) =
        deepest.map_or((f64::INFINITY, middle), |(level, p)| (level, (p.state[0], p.state[1])));
    let share = |k: usize| (k as f64 + 0.5) / n;
    let mut levels: Vec<f64> =
        (0..wanted).map(|k| value(from.0, from.1 + (y.1 - from.1) * share(k))).collect();
    let across = (0..wanted).map(|k| value(x.0 + (x.1 - x.0) * share(k), from.1));
    levels.extend(across.filter(|level| *level < floor).collect::<Vec<_>>());
    levels.retain(|level| level.is_finite());
    let of_level = |levels: &[f64], ink: usize| {
        let lines = analysis::levels(field, observable, window, levels, GRID).into_iter();
        let curve = move |line: analysis::Line| {
            let (x, y) = line.into_iter().unzip();
            Curve { x, y, ink: Some(ink), stroke: Stroke::Thin, ..Curve::default() }
        };
        lines.map(curve).collect::<Vec<_>>()
    };
    let mut curves = of_level(&levels, 0);
    if subject.plan.layout.shape().coordinates > 1 {
        let passes = points.iter().filter(|p| p.kind == Kind::Saddle);
        let passes: Vec<f64> = passes.map(|p| value(p.state[0], p.state[1])).collect();
        curves.extend(of_level(&passes, 1));
    }
    curves
}

/// Where there are no levels: trajectories from the border of the window.
fn flow_curves(flow: &Flow, window: &analysis::Window) -> Vec<Curve> {
    let [x, y] = [window.ranges[0], window.ranges[1]];
    let starts = (0..STARTS).flat_map(|k| {
        let s = (f64::from(k) + 0.5) / f64::from(STARTS);
        let (across, up) = (x.0 + (x.1 - x.0) * s, y.0 + (y.1 - y.0) * s);
        [[across, y.0], [across, y.1], [x.0, up], [x.1, up]]
    });
    let curve = |start: [f64; 2]| {
        let (x, y) = analysis::trail(flow, window, &start, SPAN).into_iter().unzip();
        Curve { x, y, ink: Some(5), stroke: Stroke::Thin, ..Curve::default() }
    };
    starts.map(curve).collect()
}

/// Starts on a side of the window, and how long they are followed.
const STARTS: u32 = 8;
const SPAN: f64 = 25.0;

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

/// The window: what is given, and for every other number a range that shows what there is: two turns of an angle,
/// twice the reach of the run, velocities up to the highest potential inside.
pub(super) fn window(plan: &Plan, given: &[Window]) -> Result<analysis::Window, Error> {
    let state = plan.layout.state();
    if let Some(stranger) = given.iter().find(|w| !state.iter().any(|q| q.name == w.name)) {
        let what = format!("number of the state of {}", plan.card.id);
        return Err(unknown(&what, &stranger.name, state.iter().map(|q| q.name.as_str())));
    }
    check(plan)?;
    let reached = reach(plan);
    let coordinates = plan.layout.shape().coordinates;
    let mut ranges: Vec<(f64, f64)> = (0..state.len())
        .map(|k| match (k < coordinates, state[k].unit.as_str()) {
            (true, "rad") => (-2.0 * std::f64::consts::PI, 2.0 * std::f64::consts::PI),
            _ => (-2.0 * reached[k], 2.0 * reached[k]),
        })
        .collect();
    for window in given {
        let k = state.iter().position(|q| q.name == window.name).unwrap_or(0);
        ranges[k] = window.range(&state[k].unit)?;
    }
    if (coordinates, state.len()) == (1, 2)
        && !given.iter().any(|w| w.name == state[1].name)
        && let Some(fastest) = fastest(plan, &ranges)
    {
        ranges[1] = (-fastest, fastest);
    }
    Ok(analysis::Window { ranges })
}

/// The largest size of each number over the run; one where it stays at zero.
fn reach(plan: &Plan) -> Vec<f64> {
    let trajectory = run(plan, &mut |_| ControlFlow::Continue(())).trajectory;
    let size = |k: usize| {
        let rows = trajectory.rows().map(|row| row[k + 1].abs()).filter(|x| x.is_finite());
        let largest = rows.fold(0.0, |most: f64, x| most.larger(x));
        if largest > 1e-6 { largest } else { 1.0 }
    };
    (0..plan.layout.shape().state()).map(size).collect()
}

/// A little more than the velocity that climbs from the lowest to the highest potential inside the window.
fn fastest(plan: &Plan, ranges: &[(f64, f64)]) -> Option<f64> {
    let energy = plan.layout.observables.iter().position(|o| o.quantity.name == "energy")?;
    let subject = Subject::new(plan).ok()?;
    let window = analysis::Window { ranges: ranges.to_vec() };
    let curve = analysis::at_rest(subject.field.as_ref(), energy, &window, 200);
    let by_height = |a: &&(f64, f64), b: &&(f64, f64)| a.1.total_cmp(&b.1);
    let (low, high) = (curve.iter().min_by(by_height)?, curve.iter().max_by(by_height)?);
    let mut observed = vec![0.0; plan.layout.observables.len()];
    let mut state = plan.start.clone();
    (state[0], state[1]) = (low.0, 1.0);
    subject.field.observe(0.0, &state, &mut observed);
    let kinetic = observed[energy] - low.1;
    let fastest = ((high.1 - low.1) / kinetic).sqrt() * 1.3;
    (fastest.is_finite() && fastest > 0.0).then_some(fastest)
}
