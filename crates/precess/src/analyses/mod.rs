//! Questions beyond a run, asked of a scenario; each gives an [`Answer`] that any face can show.

mod bifurcation;
mod fit;
mod floquet;
mod frenet;
mod lyapunov;
mod numbers;
mod panel;
mod poincare;
mod portrait;
mod response;
mod sensitivity;
mod subject;
mod sweep;
mod trust;

pub use bifurcation::{BifurcationSpec, bifurcation};
pub use fit::{Data, Fit, Fitted, fit};
pub use floquet::{FloquetSpec, floquet, floquet_part, floquet_points, floquet_whole};
pub(crate) use frenet::osculating;
pub use frenet::{FrenetSpec, frenet};
pub use lyapunov::lyapunov;
pub(crate) use panel::panel;
pub use poincare::{PoincareSpec, poincare};
pub use portrait::{PortraitSpec, portrait};
pub use response::{ResponseSpec, response};
pub use sensitivity::{Sensitivities, sensitivities, sensitivity};
pub use sweep::{Sweep, Window};
pub use trust::trust;

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

/// Six decimals for a reader; a zero has no sign.
fn rounded(x: f64) -> String {
    let text = format!("{x:.6}");
    if text.trim_start_matches('-').chars().all(|c| c == '0' || c == '.') { "0".into() } else { text }
}

/// A table from the names and units of its columns.
fn table(columns: &[(&str, &str)], numbers: Vec<f64>) -> Trajectory {
    let column = |&(name, unit): &(&str, &str)| Column {
        name: name.into(),
        unit: unit.into(),
        kind: ColumnKind::Signal,
    };
    Trajectory { columns: columns.iter().map(column).collect(), numbers, events: vec![] }
}
