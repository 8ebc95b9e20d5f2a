//! Precess in Python: the extension module under the package in `python/precess`, which is all that imports it.
//!
//! Here are runs, fields and cards as Python objects, the GIL and Ctrl-C; what people type and read is written in Python.

// What Python passes is converted, and so ours.
#![allow(clippy::needless_pass_by_value)]

mod analyses;
mod basins;
mod cards;
mod ensemble;
mod error;
mod field;
mod figure;
mod plan;
mod run;
mod value;
mod watch;

/// The extension module `precess._core`.
#[pyo3::pymodule]
mod _core {
    #[pymodule_export]
    use crate::analyses::{
        Answer, Fit, bifurcation, fit, floquet, floquet_part, floquet_points, floquet_whole, frenet,
        lyapunov, picture, poincare, portrait, response, sensitivities, trust,
    };
    #[pymodule_export]
    use crate::basins::{Basins, basins, basins_part, basins_whole};
    #[pymodule_export]
    use crate::cards::{
        method_cards, scenario_texts, system_card, system_equations, system_ids, unknown, version,
    };
    #[pymodule_export]
    use crate::ensemble::Members;
    #[pymodule_export]
    use crate::error::{InputError, RunError};
    #[pymodule_export]
    use crate::field::{expressions, jacobian, rate};
    #[pymodule_export]
    use crate::plan::Plan;
    #[pymodule_export]
    use crate::run::{Outcome, hash};
}
