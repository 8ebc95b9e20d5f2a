//! A result that stays here under a handle, to be read in place.

use precess::Members;
use precess::system::{Occurrence, Trajectory};

/// A run, or many.
pub enum Kept {
    /// A run.
    Run {
        /// The samples; its list of events is empty, they are below.
        trajectory: Trajectory,
        /// The events as numbers: which of `names`, the time, the state.
        events: Vec<f64>,
        /// The names of the events that were met.
        names: Vec<String>,
    },
    /// An ensemble.
    Ensemble {
        /// Its members.
        members: Members,
        /// The members that ended before their time, as numbers.
        failed: Vec<f64>,
    },
}

/// The tables of a result, by the number that the host gives.
#[derive(Clone, Copy)]
pub enum Table {
    /// The samples, row by row.
    Numbers = 0,
    /// The events of a run, row by row.
    Events = 1,
    /// The times of the samples of an ensemble.
    Times = 2,
    /// The members of an ensemble that ended before their time.
    Failed = 3,
}

impl Table {
    /// The table of this number.
    pub fn numbered(number: u32) -> Option<Self> {
        [Self::Numbers, Self::Events, Self::Times, Self::Failed].into_iter().find(|t| *t as u32 == number)
    }
}

impl Kept {
    /// A table; empty where a result of this kind has none.
    pub fn table(&self, table: Table) -> &[f64] {
        match (self, table) {
            (Self::Run { trajectory, .. }, Table::Numbers) => &trajectory.numbers,
            (Self::Run { events, .. }, Table::Events) => events,
            (Self::Ensemble { members, .. }, Table::Numbers) => &members.numbers,
            (Self::Ensemble { members, .. }, Table::Times) => &members.times,
            (Self::Ensemble { failed, .. }, Table::Failed) => failed,
            _ => &[],
        }
    }

    /// The SHA-256 of a member; a run is the only member of itself.
    pub fn hash(&self, member: usize) -> Option<String> {
        match self {
            Self::Run { trajectory, .. } => (member == 0).then(|| precess::hash(trajectory)),
            Self::Ensemble { members, .. } => {
                let size = members.state * members.times.len();
                (member < members.numbers.len() / size).then(|| members.hash(member))
            }
        }
    }

    /// Why a member of an ensemble ended before its time.
    pub fn failure(&self, member: usize) -> Option<String> {
        let Self::Ensemble { members, .. } = self else { return None };
        let at = members.failures.binary_search_by_key(&member, |(member, _)| *member).ok()?;
        Some(members.failures[at].1.to_string())
    }
}

impl From<Trajectory> for Kept {
    fn from(mut trajectory: Trajectory) -> Self {
        let (mut events, mut names) = (vec![], vec![]);
        // A section may have a hundred thousand of them: as numbers they need no parsing on the other side.
        for Occurrence { name, t, state } in std::mem::take(&mut trajectory.events) {
            let which = names.iter().position(|n| *n == name).unwrap_or_else(|| {
                names.push(name);
                names.len() - 1
            });
            events.extend([which as f64, t]);
            events.extend(state);
        }
        Self::Run { trajectory, events, names }
    }
}

impl From<Members> for Kept {
    fn from(members: Members) -> Self {
        let failed = members.failures.iter().map(|(member, _)| *member as f64).collect();
        Self::Ensemble { members, failed }
    }
}
