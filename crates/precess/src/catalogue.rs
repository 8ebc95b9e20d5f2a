//! Everything there is, by name.

use crate::error::{Error, unknown};
use precess_integrate::{AnyMethod, METHODS};
use precess_system::AnySystem;

/// Every system.
pub fn systems() -> &'static [&'static dyn AnySystem] {
    // What is not named here is not in the program either.
    if cfg!(feature = "first") { precess_models::FIRST } else { precess_models::ALL }
}

/// Every method.
pub fn methods() -> &'static [&'static dyn AnyMethod] {
    if cfg!(feature = "first") { precess_integrate::FIRST } else { METHODS }
}

/// The system of this id.
///
/// # Errors
/// With the nearest id.
pub fn system(id: &str) -> Result<&'static dyn AnySystem, Error> {
    let ids: Vec<&str> = systems().iter().map(|s| s.card().id).collect();
    let found = ids.iter().position(|i| *i == id);
    found.map(|k| systems()[k]).ok_or_else(|| unknown("system", id, ids))
}

/// The method of this id.
///
/// # Errors
/// With the nearest id.
pub fn method(id: &str) -> Result<&'static dyn AnyMethod, Error> {
    let ids = methods().iter().map(|m| m.card().id);
    let found = methods().iter().find(|m| m.card().id == id);
    found.copied().ok_or_else(|| unknown("method", id, ids))
}
