//! The recorded outcome of a run.

use crate::{ColumnKind, Columns};

/// An event that was met on the way.
#[derive(Clone, Debug, PartialEq)]
pub struct Occurrence {
    /// Name of the event.
    pub name: String,
    /// When.
    pub t: f64,
    /// The state (coordinates, velocities) there, before any jump.
    pub state: Vec<f64>,
}

/// Samples of a run: the columns `t`, the state in the card's order, the observables; row by row.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Trajectory {
    /// The columns.
    pub columns: Columns,
    /// All numbers, row by row.
    pub numbers: Vec<f64>,
    /// Events in the order of time.
    pub events: Vec<Occurrence>,
}

impl Trajectory {
    /// Number of samples.
    pub fn len(&self) -> usize {
        if self.columns.is_empty() { 0 } else { self.numbers.len() / self.columns.len() }
    }
    /// Whether nothing was recorded.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
    /// The samples, one slice each.
    pub fn rows(&self) -> impl ExactSizeIterator<Item = &[f64]> {
        let width = if self.columns.is_empty() { 1 } else { self.columns.len() };
        self.numbers.chunks_exact(width)
    }
    /// One sample.
    pub fn row(&self, k: usize) -> &[f64] {
        &self.numbers[k * self.columns.len()..][..self.columns.len()]
    }
    /// Index of a column.
    pub fn index(&self, name: &str) -> Option<usize> {
        self.columns.iter().position(|c| c.name == name)
    }
    /// The numbers of a column.
    pub fn column(&self, name: &str) -> Option<Vec<f64>> {
        let k = self.index(name)?;
        Some(self.rows().map(|row| row[k]).collect())
    }
    /// Number of leading columns that make the result proper: time and state.
    pub fn state_columns(&self) -> usize {
        self.columns.count_leading(|kind| matches!(kind, ColumnKind::Time | ColumnKind::State))
    }
}
