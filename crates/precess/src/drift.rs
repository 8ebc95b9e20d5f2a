//! How far the invariants of a run have drifted.

use precess_scalar::Scalar;
use precess_system::{Column, ColumnKind, Trajectory};

/// The drift of one invariant over a trajectory.
#[derive(Clone, Debug, PartialEq)]
pub struct Drift {
    /// Name of the invariant.
    pub name: String,
    /// Its unit.
    pub unit: String,
    /// Its value at the start.
    pub start: f64,
    /// The largest departure from it; NaN where the invariant became NaN.
    pub largest: f64,
}

impl Drift {
    /// The largest departure relative to the start; `None` where the start is zero.
    pub fn relative(&self) -> Option<f64> {
        (self.start != 0.0).then(|| self.largest / self.start.abs())
    }
}

/// How far each value lies from the first, relative to it; absolutely where the first is zero.
pub fn departures(values: &[f64]) -> Vec<f64> {
    let start = values.first().copied().unwrap_or(f64::NAN);
    let scale = if start == 0.0 { 1.0 } else { start.abs() };
    values.iter().map(|x| (x - start).abs() / scale).collect()
}

/// The invariants, and where they stand: behind the state.
pub(crate) fn invariants(trajectory: &Trajectory) -> impl Iterator<Item = (usize, Column)> + '_ {
    let columns = &trajectory.columns;
    let observables = (trajectory.state_columns()..columns.len()).map(|k| (k, columns.get(k)));
    observables.filter(|(_, column)| column.kind == ColumnKind::Invariant)
}

/// The drift of every invariant, in the order of the columns.
pub fn drifts(trajectory: &Trajectory) -> Vec<Drift> {
    let drift = |(k, column): (usize, Column)| {
        let start = trajectory.rows().next().map_or(f64::NAN, |row| row[k]);
        // `larger` keeps its second argument where they do not compare: a NaN met on the way stays.
        let largest = trajectory.rows().fold(0.0, |largest: f64, row| {
            let departure = (row[k] - start).abs();
            if largest.is_nan() { largest } else { largest.larger(departure) }
        });
        Drift { name: column.name, unit: column.unit, start, largest }
    };
    invariants(trajectory).map(drift).collect()
}
