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

pub use crate::answer::{Answer, Progress};
pub use crate::trust::trust;
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

use crate::answer::table;

/// Six decimals for a reader; a zero has no sign.
fn rounded(x: f64) -> String {
    let text = format!("{x:.6}");
    if text.trim_start_matches('-').chars().all(|c| c == '0' || c == '.') { "0".into() } else { text }
}
