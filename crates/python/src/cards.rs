//! What there is, as JSON and texts.

use crate::error::exception;
use precess::scalar::Notation;
use precess::{catalogue, equations, json, scenarios};
use pyo3::prelude::*;

/// The version of Precess.
#[pyfunction]
pub fn version() -> &'static str {
    env!("CARGO_PKG_VERSION")
}

/// The ids of all systems.
#[pyfunction]
pub fn system_ids() -> Vec<&'static str> {
    catalogue::systems().iter().map(|system| system.card().id).collect()
}

/// A system's card with its equations, as JSON.
#[pyfunction]
pub fn system_card(id: &str) -> PyResult<String> {
    catalogue::system(id).map(|system| json::system(system).to_string()).map_err(exception)
}

/// A system's equations as text: names given to expressions that occur several times, then one for each coordinate.
#[pyfunction]
pub fn system_equations(id: &str) -> PyResult<Vec<(String, String)>> {
    let equations =
        catalogue::system(id).map(|system| equations(system, Notation::Text)).map_err(exception)?;
    Ok(equations.definitions.into_iter().chain(equations.equations).collect())
}

/// The cards of all methods, as JSON.
#[pyfunction]
pub fn method_cards() -> String {
    json::methods().to_string()
}

/// File name and text of every scenario that comes with the program.
#[pyfunction]
pub fn scenario_texts() -> Vec<(&'static str, &'static str)> {
    scenarios::all()
}

/// The sentence for a name that does not exist, with the nearest that does.
#[pyfunction]
pub fn unknown(what: &str, name: &str, names: Vec<String>) -> String {
    precess::unknown(what, name, names.iter().map(String::as_str)).to_string()
}
