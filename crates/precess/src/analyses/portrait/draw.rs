//! The picture of a portrait.

use super::check;
use crate::analyses::Progress;
use crate::analyses::subject::Subject;
use crate::error::Error;
use crate::figure::{Curve, Mark, Panel, Sign, Stroke};
use crate::picture::axis;
use crate::plan::Plan;
use precess_analysis::{self as analysis, FixedPoint, Flow, Kind};
use precess_scalar::Scalar;

/// A portrait that has been found.
pub(in crate::analyses) struct Portrait {
    pub points: Vec<FixedPoint>,
    pub panel: Panel,
}

/// The portrait of a plan's system inside a window.
pub(in crate::analyses) fn of_plan(
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
