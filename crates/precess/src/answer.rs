//! What a question beyond a run gives, for any face to show.

use crate::figure::Figure;
use precess_system::{Column, ColumnKind, Trajectory};
use std::ops::ControlFlow;

/// What comes out of an analysis.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Answer {
    /// The numbers, row by row under named columns.
    pub table: Trajectory,
    /// The picture.
    pub figure: Figure,
    /// What a person wants to know, line by line.
    pub summary: Vec<String>,
    /// Why the work ended before its time; what is there is right.
    pub failure: Option<String>,
}

/// Told how much of the work is done (from 0 to 1); ends it where it breaks.
pub type Progress<'a> = &'a mut dyn FnMut(f64) -> ControlFlow<()>;

/// A table from the names and units of its columns.
pub(crate) fn table(columns: &[(&str, &str)], numbers: Vec<f64>) -> Trajectory {
    let column = |&(name, unit): &(&str, &str)| Column {
        name: name.into(),
        unit: unit.into(),
        kind: ColumnKind::Signal,
    };
    Trajectory { columns: columns.iter().map(column).collect(), numbers, events: vec![] }
}
