//! What comes out of an ensemble.

use crate::hash::hash_numbers;
use precess_integrate::Failure;

/// What is kept of each member.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Keep {
    /// The state at the end.
    Last,
    /// The state at every sample.
    Samples,
}

/// What came out of an ensemble.
#[derive(Clone, Debug, PartialEq)]
pub struct Members {
    /// Numbers of a state: coordinates, velocities.
    pub state: usize,
    /// The times of the states that are kept of each member.
    pub times: Vec<f64>,
    /// The states: member by member, sample by sample. NaN after a failure.
    pub numbers: Vec<f64>,
    /// The members that ended before their time, in order.
    pub failures: Vec<(usize, Failure)>,
}

impl Members {
    /// The states of a member, one after another.
    pub fn member(&self, k: usize) -> &[f64] {
        let size = self.state * self.times.len();
        &self.numbers[k * size..][..size]
    }

    /// SHA-256 of a member's times and states: the hash of the same run alone, where every sample is kept.
    pub fn hash(&self, k: usize) -> String {
        let rows = self.times.iter().zip(self.member(k).chunks(self.state));
        hash_numbers(rows.flat_map(|(&t, state)| std::iter::once(t).chain(state.iter().copied())))
    }
}
