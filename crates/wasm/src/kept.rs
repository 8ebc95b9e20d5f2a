//! A result that stays here under a handle, to be read in place.

use precess::system::{Occurrence, Trajectory};

/// Tables of numbers, row by row.
#[derive(Default)]
pub struct Kept {
    /// The samples; its list of events is empty, they are below.
    pub trajectory: Trajectory,
    /// The events as numbers: which of `names`, the time, the state.
    pub events: Vec<f64>,
    /// The names of the events that were met.
    pub names: Vec<String>,
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
        Self { trajectory, events, names }
    }
}
