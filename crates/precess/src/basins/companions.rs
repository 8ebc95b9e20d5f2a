//! Whether a verdict could be another one by the errors of integration: a motion is followed again within other tolerances.
//!
//! Where a companion whose errors are far larger comes to the same end by the same way, the small errors of the motion itself
//! cannot matter. Most motions are confirmed by a cheap, coarse companion; who is not has a finer one, the last finer than the
//! motion. The verdict that none of them confirms is no proof: in the chaos before it the errors have grown too large.

use super::chase::Fate;
use super::judge::{Judge, Verdict};
use precess_integrate::{Pace, Tolerance};

/// Tolerances of the companions, to that of the motion.
const TOLERANCES: [f64; 2] = [1e3, 0.25];
/// No companion is coarser.
const COARSEST: f64 = 1e-3;
/// Steps of the companions, to those of the motion.
const STEPS: [f64; 2] = [2.0, 0.5];
/// The distance in units within which two ends are the same.
const NEAR: f64 = 0.03;
/// The share of the time within which two motions have come to rest alike.
const LATER: f64 = 0.05;

/// How closely starts are followed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Care {
    /// Once, within a million times the tolerance: for a first look.
    Draft,
    /// Once.
    Once,
    /// With companions: a label that none confirms is undecided.
    Confirmed,
}

/// A draft's tolerance, to that of the plan.
const DRAFT: f64 = 1e6;

/// The pace of a draft.
pub(super) fn draft(pace: &Pace) -> Pace {
    let mut pace = pace.clone();
    if let Pace::Adaptive(Tolerance { rtol, atol, .. }) = &mut pace {
        for tolerance in [rtol, atol] {
            let coarse = DRAFT * *tolerance;
            // Who asks for less than that gets it.
            if coarse < COARSEST {
                *tolerance = coarse;
            }
        }
    }
    pace
}

/// The paces of the companions, the cheapest first.
pub(super) fn companions(pace: &Pace) -> Vec<Pace> {
    match pace {
        Pace::Fixed(dt) => STEPS.map(|factor| Pace::Fixed(factor * dt)).to_vec(),
        Pace::Adaptive(own) => {
            let scaled = TOLERANCES.map(|factor| {
                let mut other = own.clone();
                (other.rtol, other.atol) = (factor * own.rtol, factor * own.atol);
                other
            });
            let fine = |other: &Tolerance| other.rtol <= COARSEST && other.atol <= COARSEST;
            scaled.into_iter().filter(fine).map(Pace::Adaptive).collect()
        }
    }
}

/// Whether two fates are those of one motion: the same verdict, and who had it first comes to where the other had it. Who has
/// come to where nothing moves is near it in any case: there the time tells, too.
pub(super) fn agree(judge: &Judge, one: &Fate, other: &Fate) -> bool {
    let (Fate::Judged(a, t, y), Fate::Judged(b, u, z)) = (one, other) else { return false };
    let later = (u - t).abs();
    let together = a == b && (later <= LATER * t || judge.still_moves(a));
    if !together || *a == Verdict::Escaped {
        return together;
    }
    // From where the equations do not depend on time, or after whole periods.
    let (from, to) = if t < u { (y, z) } else { (z, y) };
    let reached = if t == u { Some(from.clone()) } else { judge.ground.advance(from, later) };
    reached.is_some_and(|reached| judge.ground.distance(&reached, to) < NEAR)
}
