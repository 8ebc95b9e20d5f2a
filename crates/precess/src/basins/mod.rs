//! Basins of attraction: where each start of a grid ends, and only what is proved.
//!
//! Where the energy sinks, a motion has been decided as soon as its energy is below the lowest pass of the well that it is
//! in (`wells.rs`). Elsewhere it has when it enters a neighbourhood of a fixed point or a cycle that nothing leaves
//! (`traps.rs`). What is neither by the end is undecided, and so is what errors of integration may have decided
//! (`companions.rs`). Attractors are found: minima by descending, fixed points and cycles by Newton's method from where
//! motions end.

mod chase;
mod companions;
mod court;
mod gate;
mod ground;
mod judge;
mod matrix;
mod parts;
mod report;
mod statistics;
mod traps;
mod wells;

use crate::error::Error;
use crate::grid::Axis;
use crate::plan::Plan;
use crate::scenario::Scenario;
use crate::workers::Workers;
use chase::Fate;
use ground::turned;
use judge::{Hold, Judge, Verdict};
use std::collections::BTreeMap;
use std::ops::ControlFlow;

pub use companions::Care;
pub use court::Court;
pub use judge::Kind;
pub use parts::{part, whole};
pub use statistics::{Estimate, entropy, fraction, uncertainty};

/// Neither settled nor gone at the end, or by errors of integration.
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
    /// Each start is followed once: faster, but nobody tells the labels that the tolerance cannot tell.
    pub once: bool,
}

impl BasinsSpec {
    fn care(&self) -> Care {
        if self.once { Care::Once } else { Care::Confirmed }
    }
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
    let court = Court::new(scenario, spec, workers, progress)?;
    let fates = court.fates(&court.starts, spec.care(), workers, progress);
    Ok(concluded(court, fates, spec, workers, progress))
}

/// The basins from the fates of all starts.
fn concluded(
    mut court: Court,
    fates: Vec<Fate>,
    spec: &BasinsSpec,
    workers: Workers,
    progress: &mut dyn FnMut(f64) -> ControlFlow<()>,
) -> Basins {
    court.interrupted |= fates.contains(&Fate::Interrupted);
    let mut late: Vec<usize> = (0..fates.len()).filter(|&k| matches!(fates[k], Fate::Open(_))).collect();
    let mut fates = settle(&mut court.judge, fates);
    // Where the attractor was found only now, it is known now when a motion has been decided, and whether companions agree.
    late.retain(|&k| matches!(fates[k], Fate::Judged(..)));
    let full = court.judge.ground.plan.start.len();
    let starts: Vec<f64> = late.iter().flat_map(|&k| &court.starts[k * full..][..full]).copied().collect();
    let again = court.fates(&starts, spec.care(), workers, progress);
    let interrupted = court.interrupted || again.contains(&Fate::Interrupted);
    for (k, fate) in late.into_iter().zip(again) {
        if !matches!(fate, Fate::Open(_)) {
            fates[k] = fate;
        }
    }
    let judge = court.judge;
    let proof = if judge.wells.is_empty() {
        "inside a neighbourhood that nothing leaves"
    } else {
        "the energy has sunk below the pass"
    };
    let plan = judge.ground.plan.clone();
    let Told { labels, times, attractors } =
        tell(&judge, &fates, if spec.wrap { Listed::Met } else { Listed::Images });
    Basins { plan, axes: spec.axes.clone(), labels, times, attractors, proof, interrupted }
}

/// Looks for attractors from the ends of those that nothing holds yet, and judges these ends again.
fn settle(judge: &mut Judge, mut fates: Vec<Fate>) -> Vec<Fate> {
    let until = judge.ground.plan.until;
    let mut searches = 0;
    for k in 0..fates.len() {
        let Fate::Open(end) = &fates[k] else { continue };
        if let Some(verdict) = judge.look_round(end) {
            fates[k] = Fate::Judged(verdict, until, end.clone());
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
                fates[k] = Fate::Judged(verdict, until, end);
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

/// What is an attractor of its own.
#[derive(Clone, Copy, PartialEq)]
enum Listed {
    /// Each image of it, whole turns away, that somebody ended at.
    Images,
    /// What somebody ended at, wherever its images are.
    Met,
    /// What is known, whether or not somebody ends there.
    Known,
}

/// Labels in the order of the attractors' states, from the first number of a state on.
fn tell(judge: &Judge, fates: &[Fate], listed: Listed) -> Told {
    let ground = &judge.ground;
    let until = ground.plan.until;
    let none = vec![0; ground.coordinates];
    let image =
        |k: usize, turns: &Vec<i32>| (k, if listed == Listed::Images { turns.clone() } else { none.clone() });
    let mut met: BTreeMap<(usize, Vec<i32>), i32> = BTreeMap::new();
    for (k, attractor) in judge.attractors.iter().enumerate() {
        // Wells are there whether or not somebody ends in them.
        if matches!(attractor.hold, Hold::Well(_)) || listed == Listed::Known {
            met.insert((k, none.clone()), 0);
        }
    }
    for fate in fates {
        if let Fate::Judged(Verdict::Settled(k, turns), ..) = fate {
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
        Fate::Judged(Verdict::Settled(k, turns), t, _) => (met[&image(*k, turns)], *t),
        Fate::Judged(Verdict::Escaped, t, _) => (ESCAPED, *t),
        Fate::Open(_) | Fate::Doubtful => (UNDECIDED, until),
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
