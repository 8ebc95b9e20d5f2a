//! Parts of a system that move nothing else (the asteroids of `cluster`), computed side by side in lanes and threads: each
//! with the rest of the system, in blocks, with the bits that all have together.

use crate::catalogue;
use crate::ensemble::ensemble_between;
use crate::members::Keep;
use crate::plan::{Plan, Step};
use crate::run::Runner;
use crate::workers::Workers;
use precess_integrate::{Failure, Report, Samples};
use precess_system::{Given, Layout, Satellites, Values};
use std::ops::ControlFlow;

/// Methods whose steps know of no other number than those an equation holds: no iteration, no error norm.
const EXPLICIT: [&str; 8] =
    ["euler", "euler_taylor", "euler_cromer", "verlet", "yoshida4", "yoshida6", "yoshida8", "rk4"];
/// Satellites of a part: the rest of the system, which every part computes anew, then costs little beside them.
const COUNT: usize = 16;
/// Parts whose samples are held at once.
const TOGETHER: usize = 256;
/// Lots of samples in which a run is recorded.
const LOTS: u64 = 64;

/// The parts of a plan's system, where they can be computed one by one.
pub(crate) fn of(plan: &Plan) -> Option<Satellites> {
    if catalogue::FIRST {
        // Neither is there such a system, nor are lanes and threads in the program.
        return None;
    }
    let fits = matches!(plan.step, Step::Fixed(_)) && EXPLICIT.contains(&plan.method.card().id);
    let Satellites { rest, each, .. } = plan.system.satellites(&plan.values, COUNT)?;
    let all = (plan.layout.coordinates.len() - rest) / each;
    let fits = fits && plan.watches.is_empty() && all > 0;
    fits.then(|| plan.system.satellites(&plan.values, COUNT.min(all))).flatten()
}

/// Time and state of every sample, in the first columns of rows of this width. Nothing where some part does not come
/// through: the run as a whole then tells when and why.
///
/// All parts are taken from sample to sample, some samples at a time: what is recorded is where they go on from, and a run
/// that is interrupted keeps it.
pub(crate) fn run(
    plan: &Plan,
    Satellites { rest, each, values }: &Satellites,
    width: usize,
    progress: &mut dyn FnMut(f64) -> ControlFlow<()>,
) -> Option<(Report, Vec<f64>)> {
    let layout = plan.system.layout(values, &Given::default());
    let workers = Workers::chosen().unwrap_or_else(|_| Workers::all());
    let (coordinates, small) = (plan.layout.coordinates.len(), layout.coordinates.len());
    let (all, count) = ((coordinates - rest) / each, (small - rest) / each);
    let parts = all.div_ceil(count);
    // Where the numbers of a part with the rest stand in a row. The last part repeats the last satellite.
    let place = |part: usize, j: usize| {
        let (half, j) = (j / small * coordinates, j % small);
        let satellite = |k: usize| rest + (part * count + k / each).min(all - 1) * each + k % each;
        1 + half + if j < *rest { j } else { satellite(j - rest) }
    };
    let first: Vec<f64> = (0..2 * small).map(|j| plan.start[place(0, j) - 1]).collect();
    let alone = alone(plan, values, layout, first.clone());

    // One part tells how many steps there are.
    let whole = Samples::new(plan.until, plan.every);
    let steps = |samples: Samples, progress: &mut dyn FnMut(f64) -> ControlFlow<()>| {
        Runner::new(&alone).over(samples).drive(&first, &mut |_, _| {}, progress)
    };
    let mut rows = Vec::with_capacity((whole.last() as usize + 1) * width);
    rows.resize(width, f64::NAN);
    rows[0] = whole.time(0);
    rows[1..=2 * coordinates].copy_from_slice(&plan.start[..2 * coordinates]);
    let report = steps(whole, &mut |t| progress(t / parts as f64));
    match report.failure {
        None => {}
        Some(Failure::Interrupted { .. }) => return Some((interrupted(report, 0.0), rows)),
        Some(_) => return None,
    }
    rows.resize((whole.last() as usize + 1) * width, f64::NAN);
    for from in (0..whole.last()).step_by(stride(whole)) {
        let to = (from + stride(whole) as u64).min(whole.last());
        let stretch = whole.between(from, to);
        let (known, new) = rows.split_at_mut((from as usize + 1) * width);
        let now = &known[from as usize * width..];
        let (begin, length) = (whole.time(from), whole.time(to) - whole.time(from));
        for group in (0..parts).step_by(TOGETHER) {
            let some = group..(group + TOGETHER).min(parts);
            let starts: Vec<f64> =
                some.clone().flat_map(|part| (0..2 * small).map(move |j| now[place(part, j)])).collect();
            let mut ended = false;
            let mut look = |done| {
                if ended {
                    return ControlFlow::Break(());
                }
                let answer = progress(begin + length * (group + done) as f64 / parts as f64);
                ended |= answer.is_break();
                answer
            };
            let members =
                ensemble_between(&alone, &starts, stretch, Keep::Samples, workers, &mut look).ok()?;
            if ended {
                rows.truncate((from as usize + 1) * width);
                let report = steps(whole.between(0, from), &mut |_| ControlFlow::Continue(()));
                return Some((interrupted(report, begin), rows));
            }
            if !members.failures.is_empty() {
                return None;
            }
            for (k, part) in some.enumerate() {
                let states = members.member(k).chunks(2 * small).skip(1);
                for (row, state) in new.chunks_mut(width).zip(states) {
                    for (j, x) in state.iter().enumerate() {
                        row[place(part, j)] = *x;
                    }
                }
            }
        }
        for (k, row) in new.chunks_mut(width).take((to - from) as usize).enumerate() {
            row[0] = whole.time(from + 1 + k as u64);
        }
    }
    Some((report, rows))
}

/// The plan of a part: what a run needs, and nothing of the size of the whole.
fn alone(plan: &Plan, values: &Values<f64>, layout: Layout, start: Vec<f64>) -> Plan {
    Plan {
        structure: precess_system::structure(plan.system, values, &layout),
        values: values.clone(),
        layout,
        start,
        title: String::new(),
        label: String::new(),
        system: plan.system,
        card: plan.card.clone(),
        method: plan.method,
        options: plan.options.clone(),
        step: plan.step,
        until: plan.until,
        every: plan.every,
        watches: vec![],
        members: vec![],
        panels: vec![],
        ensemble: None,
    }
}

/// Samples that are taken at once: a part is set up again for each lot.
fn stride(whole: Samples) -> usize {
    whole.last().div_ceil(LOTS).max(1) as usize
}

fn interrupted(report: Report, t: f64) -> Report {
    Report { failure: Some(Failure::Interrupted { t }), ..report }
}
