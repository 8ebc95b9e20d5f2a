//! Basins in parts: whoever has the fates of some starts needs nothing of the others, so they may be found anywhere.

use super::chase::Fate;
use super::judge::{Judge, Verdict};
use super::{Basins, BasinsSpec, Court, concluded};
use crate::error::{Error, input};
use crate::scenario::Scenario;
use crate::workers::Workers;
use std::ops::{ControlFlow, Range};

/// What the first number of a row says.
const SETTLED: f64 = 0.0;
const ESCAPED: f64 = 1.0;
const OPEN: f64 = 2.0;
const DIVERGED: f64 = 3.0;
const DOUBTFUL: f64 = 4.0;
const INTERRUPTED: f64 = 5.0;

/// The fates of the starts in a range as numbers, a row each, and the length of a row: for [`whole`], and no one else.
///
/// # Errors
/// As [`super::basins`], and where the range goes beyond the grid.
pub fn part(
    scenario: &Scenario,
    spec: &BasinsSpec,
    members: Range<usize>,
    workers: Workers,
    progress: &mut dyn FnMut(f64) -> ControlFlow<()>,
) -> Result<(Vec<f64>, usize), Error> {
    let court = Court::new(scenario, spec, workers, progress)?;
    let full = court.plan().start.len();
    let Some(mine) = court.starts.get(members.start * full..members.end * full) else {
        return input(format!("there are {} starts, not {}", court.starts.len() / full, members.end));
    };
    let fates = court.fates(mine, spec.care(), workers, progress);
    Ok((fates.iter().flat_map(|fate| row(fate, &court.judge)).collect(), width(&court.judge)))
}

/// The basins from the rows of all parts, in the order of the starts: the bits of [`super::basins`].
///
/// # Errors
/// As [`super::basins`], and where these are not the rows of this grid.
pub fn whole(
    scenario: &Scenario,
    spec: &BasinsSpec,
    rows: &[f64],
    workers: Workers,
    progress: &mut dyn FnMut(f64) -> ControlFlow<()>,
) -> Result<Basins, Error> {
    let court = Court::new(scenario, spec, workers, progress)?;
    let (members, width) = (court.starts.len() / court.plan().start.len(), width(&court.judge));
    if rows.len() != members * width {
        return input(format!("{members} starts have {} numbers, not {}", members * width, rows.len()));
    }
    let fates: Vec<Fate> = rows.chunks(width).map(|row| fate(row, &court.judge)).collect();
    Ok(concluded(court, fates, spec, workers, progress))
}

/// What it says, a time, an attractor, its turns, a state.
fn width(judge: &Judge) -> usize {
    3 + judge.ground.coordinates + judge.ground.plan.start.len()
}

fn row(fate: &Fate, judge: &Judge) -> Vec<f64> {
    let mut row = vec![0.0; width(judge)];
    let state = 3 + judge.ground.coordinates;
    match fate {
        Fate::Judged(verdict, t, end) => {
            row[..2].copy_from_slice(&[ESCAPED, *t]);
            if let Verdict::Settled(attractor, turns) = verdict {
                (row[0], row[2]) = (SETTLED, *attractor as f64);
                row[3..].iter_mut().zip(turns).for_each(|(place, turn)| *place = f64::from(*turn));
            }
            row[state..].copy_from_slice(end);
        }
        Fate::Open(end) => {
            row[0] = OPEN;
            row[state..].copy_from_slice(end);
        }
        Fate::Diverged(t) => row[..2].copy_from_slice(&[DIVERGED, *t]),
        Fate::Doubtful => row[0] = DOUBTFUL,
        Fate::Interrupted => row[0] = INTERRUPTED,
    }
    row
}

fn fate(row: &[f64], judge: &Judge) -> Fate {
    let state = 3 + judge.ground.coordinates;
    let end = row[state..].to_vec();
    match row[0] {
        // Whatever stands here, no attractor is asked for that there is not.
        SETTLED if row[2] >= 0.0 && row[2] < judge.attractors.len() as f64 => {
            let turns = row[3..state].iter().map(|turn| *turn as i32).collect();
            Fate::Judged(Verdict::Settled(row[2] as usize, turns), row[1], end)
        }
        ESCAPED => Fate::Judged(Verdict::Escaped, row[1], end),
        OPEN => Fate::Open(end),
        DIVERGED => Fate::Diverged(row[1]),
        DOUBTFUL => Fate::Doubtful,
        _ => Fate::Interrupted,
    }
}
