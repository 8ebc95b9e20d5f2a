//! The part of the space of states that a portrait looks at.

use super::check;
use crate::analyses::Window;
use crate::analyses::subject::Subject;
use crate::error::{Error, unknown};
use crate::plan::Plan;
use crate::run::run;
use precess_analysis as analysis;
use precess_scalar::Scalar;
use std::ops::ControlFlow;

/// The window: what is given, and for every other number a range that shows what there is: two turns of an angle,
/// twice the reach of the run, velocities up to the highest potential inside.
pub(in crate::analyses) fn window(plan: &Plan, given: &[Window]) -> Result<analysis::Window, Error> {
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
