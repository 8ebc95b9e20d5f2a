//! Basins of attraction: where each start of a grid ends, and only what is proved.
//!
//! Where the energy sinks, a motion has been decided as soon as its energy is below the lowest pass of the well that it is
//! in (`wells.rs`). Elsewhere it has when it enters a neighbourhood of a fixed point or a cycle that nothing leaves
//! (`traps.rs`). What is neither by the end is undecided. Attractors are found: minima by descending, fixed points and
//! cycles by Newton's method from where motions end.

mod chase;
mod gate;
mod ground;
mod judge;
mod matrix;
mod parts;
mod report;
mod statistics;
mod traps;
mod wells;

use crate::error::{Error, input};
use crate::grid::{Axis, grid};
use crate::plan::{Plan, Step};
use crate::scenario::Scenario;
use crate::value::Value;
use crate::workers::Workers;
use chase::{Fate, chase};
use ground::{Ground, turned};
use judge::{Hold, Judge, Verdict};
use precess_integrate::Kind as Steps;
use std::collections::BTreeMap;
use std::ops::ControlFlow;

pub use judge::Kind;
pub use parts::{part, whole};
pub use statistics::{Estimate, entropy, fraction, uncertainty};

/// Neither settled nor gone at the end.
pub const UNDECIDED: i32 = -1;
/// A coordinate has gone a thousand times further than the starts reach.
pub const ESCAPED: i32 = -2;
/// The motion does not go on in numbers.
pub const DIVERGED: i32 = -3;

/// What is asked.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BasinsSpec {
    /// The starts; the first axis runs fastest.
    pub axes: Vec<Axis>,
    /// Attractors that differ by whole turns are one.
    pub wrap: bool,
}

/// An attractor.
#[derive(Clone, Debug, PartialEq)]
pub struct Attractor {
    /// A state of it: the fixed point, or a point of the cycle (at a whole period of the drive, where there is one).
    pub state: Vec<f64>,
    /// What it is.
    pub kind: Kind,
    /// The energy below which nothing leaves it, where that is the proof.
    pub pass: Option<f64>,
}

/// Where the starts end.
#[derive(Clone)]
pub struct Basins {
    /// The run of each start.
    pub plan: Plan,
    /// The axes.
    pub axes: Vec<Axis>,
    /// The label of each start, the first axis running fastest: the number of its attractor, or a negative one.
    pub labels: Vec<i32>,
    /// When it was known.
    pub times: Vec<f64>,
    /// The attractors in the order of their states.
    pub attractors: Vec<Attractor>,
    /// How motions were decided.
    pub proof: &'static str,
    /// Whether somebody ended the work before its time; those who were left are undecided.
    pub interrupted: bool,
}

/// Lengths of the card's run that a motion has to settle.
const PATIENCE: f64 = 5.0;
/// Starts that are followed to their ends before the others, to find attractors.
const SCOUTS: usize = 200;
/// Undecided ends from which attractors are looked for.
const MOST_SEARCHES: usize = 60;
/// More attractors than this are no attractors.
const MOST_ATTRACTORS: usize = 200;

/// The basins of a scenario. `progress` is told the share of the starts that is done and may end the work.
///
/// Where the scenario does not say otherwise, a start has five times the card's time, and an adaptive method a tolerance
/// of 1e-12.
///
/// # Errors
/// Where scenario or axes make no sense, the system has events, or nothing can attract.
pub fn basins(
    scenario: &Scenario,
    spec: &BasinsSpec,
    workers: Workers,
    progress: &mut dyn FnMut(f64) -> ControlFlow<()>,
) -> Result<Basins, Error> {
    court(scenario, spec, workers, progress, |judge, starts, mut interrupted, progress| {
        let fates = followed(&judge, starts, workers, interrupted, progress);
        interrupted |= fates.contains(&Fate::Interrupted);
        Ok(concluded(judge, fates, spec, interrupted))
    })
}

/// Asks a judge, who depends on scenario and grid alone: with all starts, and whether the scouts were interrupted.
fn court<T>(
    scenario: &Scenario,
    spec: &BasinsSpec,
    workers: Workers,
    progress: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ask: impl FnOnce(Judge, &[f64], bool, &mut dyn FnMut(f64) -> ControlFlow<()>) -> Result<T, Error>,
) -> Result<T, Error> {
    let mut plan = patient(scenario)?;
    if spec.axes.is_empty() {
        return input("basins need a grid of starts, such as --grid x=-2:2:200 --grid y=-2:2:200");
    }
    if plan.until <= 0.0 {
        return input(format!("the end must be above zero here, not {}", plan.until));
    }
    let starts = grid(&plan, &spec.axes)?;
    let original = plan.clone();
    let ground = Ground::new(&original, &starts)?;
    match ground.period {
        // Motions are judged at whole periods.
        Some(period) => {
            plan.every = period;
            plan.until = (plan.until / period).ceil() * period;
        }
        None if matches!(plan.step, Step::Adaptive { .. }) => plan.every = plan.until,
        None => {}
    }
    let mut judge = Judge::new(Ground { plan: &plan, ..ground })?;
    let mut interrupted = false;
    if judge.wells.is_empty() {
        let scouts = scouts(&starts, plan.start.len());
        let ends = chase(&judge, &scouts, workers, &mut |_| progress(0.0));
        interrupted = ends.contains(&Fate::Interrupted);
        settle(&mut judge, ends);
    }
    ask(judge, &starts, interrupted, progress)
}

/// The fates of some starts: nobody follows them where the work has been interrupted before.
fn followed(
    judge: &Judge,
    starts: &[f64],
    workers: Workers,
    interrupted: bool,
    progress: &mut dyn FnMut(f64) -> ControlFlow<()>,
) -> Vec<Fate> {
    let members = starts.len() / judge.ground.plan.start.len();
    if interrupted {
        return vec![Fate::Interrupted; members];
    }
    chase(judge, starts, workers, &mut |done| progress(done as f64 / members as f64))
}

/// The basins from the fates of all starts.
fn concluded(mut judge: Judge, fates: Vec<Fate>, spec: &BasinsSpec, interrupted: bool) -> Basins {
    let fates = settle(&mut judge, fates);
    let proof = if judge.wells.is_empty() {
        "inside a neighbourhood that nothing leaves"
    } else {
        "the energy has sunk below the pass"
    };
    let plan = judge.ground.plan.clone();
    let Told { labels, times, attractors } = tell(&judge, &fates, spec.wrap, plan.until);
    Basins { plan, axes: spec.axes.clone(), labels, times, attractors, proof, interrupted }
}

/// The plan, with time to settle and a tolerance that chaos does not spoil.
fn patient(scenario: &Scenario) -> Result<Plan, Error> {
    let plan = Plan::new(scenario)?;
    let mut patient = scenario.clone();
    let given = |name: &str| scenario.run.iter().any(|(n, _)| n == name);
    if !given("until") {
        patient.run.push(("until".into(), Value::number(PATIENCE * plan.card.defaults.until)));
    }
    for name in ["rtol", "atol"] {
        if plan.method.card().kind == Steps::Adaptive && !given(name) {
            patient.run.push((name.into(), Value::number(1e-12)));
        }
    }
    Plan::new(&patient)
}

/// Starts from all over the grid, one in so many.
fn scouts(starts: &[f64], full: usize) -> Vec<f64> {
    let members = starts.len() / full;
    // A stride that has nothing to do with the columns.
    let stride = members.div_ceil(SCOUTS) | 1;
    starts.chunks(full).step_by(stride).flatten().copied().collect()
}

/// Looks for attractors from the ends of those that nothing holds yet, and judges these ends again.
fn settle(judge: &mut Judge, mut fates: Vec<Fate>) -> Vec<Fate> {
    let until = judge.ground.plan.until;
    let mut searches = 0;
    for k in 0..fates.len() {
        let Fate::Open(end) = &fates[k] else { continue };
        if let Some(verdict) = judge.look_round(end) {
            fates[k] = Fate::Judged(verdict, until);
            continue;
        }
        if searches == MOST_SEARCHES || judge.attractors.len() == MOST_ATTRACTORS {
            continue;
        }
        searches += 1;
        let end = end.clone();
        if judge.discover(&end, until) {
            searches = 0;
            if let Some(verdict) = judge.look(&end) {
                fates[k] = Fate::Judged(verdict, until);
            }
        }
    }
    fates
}

struct Told {
    labels: Vec<i32>,
    times: Vec<f64>,
    attractors: Vec<Attractor>,
}

/// Labels in the order of the attractors' states, from the first number of a state on.
fn tell(judge: &Judge, fates: &[Fate], wrap: bool, until: f64) -> Told {
    let ground = &judge.ground;
    let none = vec![0; ground.coordinates];
    let image = |k: usize, turns: &Vec<i32>| (k, if wrap { none.clone() } else { turns.clone() });
    let mut met: BTreeMap<(usize, Vec<i32>), i32> = BTreeMap::new();
    for (k, attractor) in judge.attractors.iter().enumerate() {
        // Wells are there whether or not somebody ends in them.
        if matches!(attractor.hold, Hold::Well(_)) {
            met.insert((k, none.clone()), 0);
        }
    }
    for fate in fates {
        if let Fate::Judged(Verdict::Settled(k, turns), _) = fate {
            met.insert(image(*k, turns), 0);
        }
    }
    let state = |(k, turns): &(usize, Vec<i32>)| turned(&judge.attractors[*k].state, turns);
    let mut order: Vec<_> = met.keys().cloned().collect();
    order.sort_by(|a, b| before(&state(a), &state(b)));
    for (label, key) in (0..).zip(&order) {
        met.insert(key.clone(), label);
    }
    let attractors = order.iter().map(|key| Attractor {
        state: state(key),
        kind: judge.attractors[key.0].kind,
        pass: match judge.attractors[key.0].hold {
            Hold::Well(well) => Some(judge.wells[well].pass),
            Hold::Traps(_) => None,
        },
    });
    let label = |fate: &Fate| match fate {
        Fate::Judged(Verdict::Settled(k, turns), t) => (met[&image(*k, turns)], *t),
        Fate::Judged(Verdict::Escaped, t) => (ESCAPED, *t),
        Fate::Open(_) => (UNDECIDED, until),
        Fate::Diverged(t) => (DIVERGED, *t),
        Fate::Interrupted => (UNDECIDED, 0.0),
    };
    let (labels, times) = fates.iter().map(label).unzip();
    Told { labels, times, attractors: attractors.collect() }
}

/// The order of states, number by number; what differs by rounding alone does not differ.
fn before(a: &[f64], b: &[f64]) -> std::cmp::Ordering {
    let different = a.iter().zip(b).find(|(a, b)| (**a - **b).abs() > 1e-9 * (1.0 + a.abs()));
    different.map_or(std::cmp::Ordering::Equal, |(a, b)| a.total_cmp(b))
}
