//! Parts of a system that move nothing else (the asteroids of `cluster`), computed side by side in lanes and threads: each
//! with the rest of the system, in blocks, with the bits that all have together.

use crate::ensemble::ensemble;
use crate::members::Keep;
use crate::plan::{Plan, Step};
use crate::run::Runner;
use crate::workers::Workers;
use precess_integrate::{Failure, Report};
use precess_system::{Given, Satellites};
use std::ops::ControlFlow;

/// Methods whose steps know of no other number than those an equation holds: no iteration, no error norm.
const EXPLICIT: [&str; 8] =
    ["euler", "euler_taylor", "euler_cromer", "verlet", "yoshida4", "yoshida6", "yoshida8", "rk4"];
/// Parts whose samples are held at once.
const TOGETHER: usize = 512;

/// The parts of a plan's system, where they can be computed one by one.
pub(crate) fn of(plan: &Plan) -> Option<Satellites> {
    let fits = matches!(plan.step, Step::Fixed(_)) && EXPLICIT.contains(&plan.method.card().id);
    let satellites = plan.system.satellites(&plan.values)?;
    let parts = plan.layout.coordinates.len() - satellites.rest;
    (fits && plan.watches.is_empty() && parts > 0).then_some(satellites)
}

/// Time and state of every sample, in the first columns of rows of this width. Nothing where some part does not come
/// through: the run as a whole then tells when and why.
pub(crate) fn run(
    plan: &Plan,
    Satellites { rest, each, one }: &Satellites,
    width: usize,
    progress: &mut dyn FnMut(f64) -> ControlFlow<()>,
) -> Option<(Report, Vec<f64>)> {
    let layout = plan.system.layout(one, &Given::default());
    let structure = precess_system::structure(plan.system, one, &layout);
    let workers = Workers::chosen().unwrap_or_else(|_| Workers::all());
    let (coordinates, small) = (plan.layout.coordinates.len(), rest + each);
    let parts = (coordinates - rest) / each;
    // Where the numbers of a part with the rest stand among all.
    let place = |part: usize, j: usize| {
        let (half, j) = (j / small * coordinates, j % small);
        half + if j < *rest { j } else { rest + part * each + (j - rest) }
    };
    let start = |part: usize| (0..2 * small).map(move |j| plan.start[place(part, j)]);

    let first: Vec<f64> = start(0).collect();
    let alone = Plan { values: one.clone(), layout, structure, start: first.clone(), ..plan.clone() };

    let mut rows = vec![];
    let mut times = vec![];
    let report =
        Runner::new(&alone).drive(&first, &mut |t, _| times.push(t), &mut |_| ControlFlow::Continue(()));
    if report.failure.is_some() {
        return None;
    }
    rows.resize(times.len() * width, f64::NAN);
    for (row, t) in rows.chunks_mut(width).zip(&times) {
        row[0] = *t;
    }
    for from in (0..parts).step_by(TOGETHER) {
        let some = from..(from + TOGETHER).min(parts);
        let starts: Vec<f64> = some.clone().flat_map(start).collect();
        let members =
            ensemble(&alone, &starts, Keep::Samples, workers, &mut |_| ControlFlow::Continue(())).ok()?;
        if !members.failures.is_empty() {
            return None;
        }
        for (k, part) in some.clone().enumerate() {
            for (row, state) in rows.chunks_mut(width).zip(members.member(k).chunks(2 * small)) {
                for (j, x) in state.iter().enumerate() {
                    row[1 + place(part, j)] = *x;
                }
            }
        }
        if progress(plan.until * some.end as f64 / parts as f64).is_break() {
            return Some((Report { failure: Some(Failure::Interrupted { t: 0.0 }), ..report }, vec![]));
        }
    }
    Some((report, rows))
}
