//! Who decides where a motion ends: only by proof.

use super::ground::{Energy, Ground, turned};
use super::traps::{self, Meeting, Trap};
use super::wells::{self, Well};
use crate::error::{Error, input};

/// A coordinate so many times the largest start has escaped.
const FAR: f64 = 1e3;

/// What attracts.
#[derive(Clone, Debug)]
pub(super) enum Hold {
    /// The energy below a pass.
    Well(usize),
    /// Neighbourhoods.
    Traps(Vec<Trap>),
}

/// An attractor, told by its image in the first turn.
pub(super) struct Attractor {
    pub state: Vec<f64>,
    pub kind: Kind,
    pub hold: Hold,
}

/// What an attractor is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// It rests.
    FixedPoint,
    /// It comes back after so many periods of the drive.
    Driven {
        /// Periods.
        periods: usize,
    },
    /// It comes back by itself.
    Cycle,
}

/// The verdict on a motion.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Verdict {
    /// It ends at an attractor's image so many turns away.
    Settled(usize, Vec<i32>),
    Escaped,
}

pub(super) struct Judge {
    pub ground: Ground,
    pub energy: Energy,
    pub attractors: Vec<Attractor>,
    pub wells: Vec<Well>,
    /// Minima whose passes have been asked for.
    minima: Vec<Vec<f64>>,
    /// A coordinate that does not turn has escaped beyond this.
    pub far: f64,
    /// Nothing can settle above this energy.
    pub highest_pass: f64,
}

impl Judge {
    /// Finds the wells, where the energy sinks.
    pub fn new(ground: Ground) -> Result<Self, Error> {
        let energy = ground.energy_sinks();
        if energy == Energy::Stays {
            let id = ground.plan.card.id;
            return input(format!(
                "the energy of {id} stays constant with these parameters, so nothing attracts and there are no basins \
                 (let there be some friction)"
            ));
        }
        let largest = |y: &f64, most: f64| if y.abs() > most { y.abs() } else { most };
        let coordinates =
            ground.range[..ground.coordinates].iter().zip(&ground.turning).filter(|(_, turns)| !**turns);
        let size = coordinates.fold(0.0, |most, ((low, high), _)| largest(low, largest(high, most)));
        let far = if size > 0.0 { FAR * size } else { f64::INFINITY };
        let mut judge = Self {
            ground,
            energy,
            attractors: vec![],
            wells: vec![],
            minima: vec![],
            far,
            highest_pass: f64::NEG_INFINITY,
        };
        if energy == Energy::Sinks && judge.ground.coordinates <= 3 {
            judge.minima = wells::minima(&judge.ground);
            for k in 0..judge.minima.len() {
                judge.add_well(k);
            }
        }
        Ok(judge)
    }

    fn add_well(&mut self, k: usize) {
        let Some(well) = Well::new(&self.ground, &self.minima[k], &self.minima) else { return };
        let deep = well.pass > well.floor;
        if !deep {
            return;
        }
        if well.pass > self.highest_pass {
            self.highest_pass = well.pass;
        }
        self.attractors.push(Attractor {
            state: self.ground.at_rest(&well.place),
            kind: Kind::FixedPoint,
            hold: Hold::Well(self.wells.len()),
        });
        self.wells.push(well);
    }

    /// Looks for an attractor near the end of a motion that nothing known holds; true where one was found.
    pub fn discover(&mut self, y: &[f64], longest: f64) -> bool {
        let ground = &self.ground;
        if !y.iter().all(|x| x.is_finite()) {
            return false;
        }
        if self.energy == Energy::Sinks && ground.coordinates <= 3 {
            let end =
                wells::descend(ground, &y[..ground.coordinates], &ground.unit[..ground.coordinates], 0.02);
            if end.is_some_and(|end| wells::add(&self.ground, &mut self.minima, &end)) {
                let before = self.wells.len();
                self.add_well(self.minima.len() - 1);
                return self.wells.len() > before;
            }
        }
        let ground = &self.ground;
        let (found, kind) = match ground.period {
            Some(period) => {
                let found = traps::driven_cycle(ground, y, period);
                let periods = found.as_ref().map_or(0, |(_, traps)| traps.len());
                (found, Kind::Driven { periods })
            }
            None => match traps::fixed_point(ground, y) {
                Some(found) => (Some(found), Kind::FixedPoint),
                None => (traps::free_cycle(ground, y, longest), Kind::Cycle),
            },
        };
        let Some((state, mut traps)) = found else { return false };
        let turns = ground.turns_between(&state, &vec![0.0; ground.coordinates]);
        let state = turned(&state, &turns);
        for trap in &mut traps {
            trap.centre = turned(&trap.centre, &turns);
        }
        self.attractors.push(Attractor { state, kind, hold: Hold::Traps(traps) });
        true
    }

    /// Whether a motion can only be judged at whole periods of a drive.
    pub fn strobes(&self) -> bool {
        self.ground.period.is_some()
    }

    pub fn has_escaped(&self, y: &[f64]) -> bool {
        let own = y[..self.ground.coordinates].iter().zip(&self.ground.turning);
        own.filter(|(_, turns)| !**turns).any(|(x, _)| x.abs() > self.far)
    }

    /// The verdict on a motion that is here (at a whole period of the drive, where there is one); none while it is open.
    pub fn look(&self, y: &[f64]) -> Option<Verdict> {
        if self.has_escaped(y) {
            return Some(Verdict::Escaped);
        }
        if !self.wells.is_empty() {
            let settled = self.in_well(y);
            if settled.is_some() {
                return settled;
            }
        }
        for (k, attractor) in self.attractors.iter().enumerate() {
            let Hold::Traps(traps) = &attractor.hold else { continue };
            for trap in traps {
                if !self.is_near(trap, y) {
                    continue;
                }
                if let Some(turns) = trap.holds(&self.ground, y) {
                    // All points of one cycle are told by the turns of the first.
                    return Some(Verdict::Settled(k, turns));
                }
            }
        }
        None
    }

    /// The verdict on a motion at its end: it may be anywhere on a cycle that it has reached.
    pub fn look_round(&self, y: &[f64]) -> Option<Verdict> {
        let cycles = self.attractors.iter().enumerate().filter_map(|(k, attractor)| match &attractor.hold {
            Hold::Traps(traps) if attractor.kind == Kind::Cycle => Some((k, traps.first()?)),
            _ => None,
        });
        let mut meets =
            cycles.filter_map(|(k, trap)| Some(Verdict::Settled(k, trap.meets(&self.ground, y)?)));
        self.look(y).or_else(|| meets.next())
    }

    /// Whether what a verdict is about still moves: in a well, or around a free cycle.
    pub fn still_moves(&self, verdict: &Verdict) -> bool {
        let Verdict::Settled(k, _) = verdict else { return false };
        let Attractor { kind, hold, .. } = &self.attractors[*k];
        *kind == Kind::Cycle || matches!(hold, Hold::Well(_))
    }

    /// A cycle is only looked at from near by: elsewhere its plane is another place.
    fn is_near(&self, trap: &Trap, y: &[f64]) -> bool {
        if !matches!(trap.meeting, Meeting::Section(..)) {
            return true;
        }
        let turns = self.ground.turns_between(&trap.centre, y);
        self.ground.distance(&turned(&trap.centre, &turns), y) < NEAR
    }

    fn in_well(&self, y: &[f64]) -> Option<Verdict> {
        let ground = &self.ground;
        let energy = ground.energy_of(y);
        let sunk = energy < self.highest_pass;
        if !sunk {
            return None;
        }
        let q = &y[..ground.coordinates];
        let held = |well: usize, turns: Vec<i32>| {
            let own = |a: &Attractor| matches!(a.hold, Hold::Well(k) if k == well);
            Some(Verdict::Settled(self.attractors.iter().position(own)?, turns))
        };
        let mut nearest: Vec<(f64, usize)> =
            self.wells.iter().enumerate().map(|(k, well)| (well.distance(ground, q), k)).collect();
        nearest.sort_by(|a, b| a.0.total_cmp(&b.0));
        for (_, k) in nearest {
            if let Some(turns) = self.wells[k].holds(ground, q, energy) {
                return held(k, turns);
            }
        }
        // No straight way down: the way that water takes.
        let end = wells::descend(ground, q, &ground.unit[..ground.coordinates], 0.02)?;
        let drains =
            self.wells.iter().enumerate().find_map(|(k, w)| Some((k, w.drains(ground, &end, energy)?)));
        drains.and_then(|(k, turns)| held(k, turns))
    }
}

/// The distance in units at which a cycle's section is looked at.
pub(super) const NEAR: f64 = 0.1;
