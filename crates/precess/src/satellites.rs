//! Parts of a system that move nothing else (the asteroids of `cluster`), computed side by side in lanes and threads: each
//! with the rest of the system, in blocks, with the bits that all have together.

use crate::catalogue;
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
    if catalogue::FIRST {
        // Neither is there such a system, nor are lanes and threads in the program.
        return None;
    }
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

    // The start is all that every part has come to where the work ends early.
    let interrupted = |report| {
        let mut row = vec![0.0; width];
        row[1..=2 * coordinates].copy_from_slice(&plan.start[..2 * coordinates]);
        Some((Report { failure: Some(Failure::Interrupted { t: 0.0 }), ..report }, row))
    };
    let mut times = vec![];
    let mut share = |t| progress(t / parts as f64);
    let report = Runner::new(&alone).drive(&first, &mut |t, _| times.push(t), &mut share);
    match report.failure {
        None => {}
        Some(Failure::Interrupted { .. }) => return interrupted(report),
        Some(_) => return None,
    }
    let mut rows = vec![f64::NAN; times.len() * width];
    for (row, t) in rows.chunks_mut(width).zip(&times) {
        row[0] = *t;
    }
    for from in (0..parts).step_by(TOGETHER) {
        let some = from..(from + TOGETHER).min(parts);
        let starts: Vec<f64> = some.clone().flat_map(start).collect();
        let mut ended = false;
        let mut look = |done| {
            let answer = progress(plan.until * (from + done) as f64 / parts as f64);
            ended |= answer.is_break();
            answer
        };
        let members = ensemble(&alone, &starts, Keep::Samples, workers, &mut look).ok()?;
        if ended {
            return interrupted(report);
        }
        if !members.failures.is_empty() {
            return None;
        }
        for (k, part) in some.enumerate() {
            for (row, state) in rows.chunks_mut(width).zip(members.member(k).chunks(2 * small)) {
                for (j, x) in state.iter().enumerate() {
                    row[1 + place(part, j)] = *x;
                }
            }
        }
    }
    Some((report, rows))
}
