//! The potential of one degree of freedom: the ball on the curve, at the height that its energy allows.

use super::curves::{chosen, own_inks};
use super::labels::axis;
use super::shown::Shown;
use crate::error::{Error, input};
use crate::figure::{Curve, Mark, Panel, Sign, Stroke};
use crate::plan::{PanelPlan, Plan};
use precess_scalar::Scalar;
use precess_system::{Bind, Quantity};

/// Points of the curve.
const POINTS: usize = 800;
/// The colour of the curve: grey, since the balls have those of their trajectories.
const GROUND: usize = 7;

/// The curve of the potential over the range of the panel (or of the trajectories), a ball at each start, and the level
/// of its energy between the points where the ball turns.
pub(super) fn potential(panel: &PanelPlan, shown: &[Shown]) -> Result<Panel, Error> {
    let chosen = chosen(panel, shown);
    let Some(first) = chosen.first() else { return Ok(Panel::default()) };
    let (coordinate, observable) = quantities(first.plan, panel)?;
    let columns = first.plan.columns();
    let (low, high) = panel.x_range.unwrap_or_else(|| reach(&chosen, coordinate));
    let x = |k: usize| low + (high - low) * (k as f64 / (POINTS - 1) as f64);
    let xs: Vec<f64> = (0..POINTS).map(x).collect();
    let mut drawn = Panel {
        title: panel.spec.title.clone(),
        x_label: axis(&columns[coordinate]),
        y_label: axis(&columns[observable]),
        x_range: panel.x_range,
        y_range: panel.y_range,
        equal_scales: panel.spec.equal_scales,
        ..Panel::default()
    };
    let curve = heights(first.plan, coordinate, observable, &xs);
    drawn.curves.push(Curve { x: xs.clone(), y: curve.clone(), ink: Some(GROUND), ..Curve::default() });
    for (one, ink) in chosen.iter().zip(own_inks(&chosen, shown)) {
        let state = one.plan.start.clone();
        let start = state[coordinate - 1];
        let height = heights(one.plan, coordinate, observable, &[start])[0];
        let level = energy(one).unwrap_or(height);
        let ink = Some(ink);
        let (x, y) = between_turns(&xs, &curve, start, level);
        drawn.curves.push(Curve { x, y, ink, stroke: Stroke::Dashed, ..Curve::default() });
        drawn.marks.push(Mark { x: start, y: height, ink, sign: Sign::Ball, ..Mark::default() });
    }
    Ok(drawn)
}

/// The level of an energy from where the ball turns on the left of its start to where it turns on the right.
fn between_turns(xs: &[f64], curve: &[f64], start: f64, level: f64) -> (Vec<f64>, Vec<f64>) {
    let beyond = |i: usize| curve[i] > level + 1e-9 * level.abs().larger(1e-9);
    let here = xs.iter().position(|x| *x >= start).unwrap_or(xs.len() - 1);
    // The point of the grid next to a start at rest may lie a little above its level.
    let open = |i: usize| !beyond(i) || i.abs_diff(here) < 2;
    let first = (0..=here).rev().take_while(|i| open(*i)).last().unwrap_or(here);
    let last = (here..xs.len()).take_while(|i| open(*i)).last().unwrap_or(here);
    (vec![xs[first], xs[last]], vec![level, level])
}

/// The coordinate along which, and the observable that is drawn: its potential, or its energy at rest.
pub(crate) fn quantities(plan: &Plan, panel: &PanelPlan) -> Result<(usize, usize), Error> {
    let columns = plan.columns();
    let place = |name: &str| columns.iter().position(|q: &Quantity| q.name == name);
    let coordinate = panel.spec.x.first().and_then(|name| place(name)).unwrap_or(1);
    if !(1..=plan.layout.shape().coordinates).contains(&coordinate) {
        return input(format!(
            "a potential is drawn along a coordinate, not along {}",
            columns[coordinate].name
        ));
    }
    let asked = panel.spec.y.first().and_then(|name| place(name));
    match asked.or_else(|| place("potential")).or_else(|| place("energy")) {
        Some(observable) => Ok((coordinate, observable)),
        None => input(format!("{} has neither potential nor energy: give y", plan.card.id)),
    }
}

/// An observable at rest, along a coordinate, the others at their starts.
pub(crate) fn heights(plan: &Plan, coordinate: usize, observable: usize, xs: &[f64]) -> Vec<f64> {
    let field = Bind::<f64>::bind(plan.system, plan.values.clone(), &plan.layout);
    let shape = plan.layout.shape();
    let mut state = plan.start.clone();
    state[shape.coordinates..shape.state()].fill(0.0);
    let mut observed = vec![0.0; shape.observables];
    let height = |&x: &f64| {
        state[coordinate - 1] = x;
        field.observe(0.0, &state, &mut observed);
        observed[observable - 1 - shape.state()]
    };
    xs.iter().map(height).collect()
}

fn energy(one: &Shown) -> Option<f64> {
    let column = one.column("energy")?;
    one.sample(0.0).map(|row| row[column])
}

/// From the leftmost to the rightmost point that is reached.
fn reach(chosen: &[&Shown], coordinate: usize) -> (f64, f64) {
    let mut reach = (f64::INFINITY, f64::NEG_INFINITY);
    for x in chosen.iter().flat_map(|one| one.trajectory.rows().map(|row| row[coordinate])) {
        reach = (reach.0.smaller(x), reach.1.larger(x));
    }
    let air = (reach.1 - reach.0) * 0.1;
    (reach.0 - air, reach.1 + air)
}
