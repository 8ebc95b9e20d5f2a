//! How fast Precess is on this machine: as ratios first, since times are those of one machine on one day.
//!
//! A measurement gives [`Table`]s. All lanes of a measurement take turns, round after round, and the shortest time of
//! each counts; wherever trajectories are computed, every set of registers must give the same bits, or there is no
//! table at all.

pub mod clock;
pub mod elementary;
mod error;
mod lanes;
mod limits;
mod magnets;
mod methods;
mod peer;
mod positions;
mod settings;
mod systems;
mod table;

pub use error::Error;
pub use peer::Peer;
pub use settings::{Effort, Settings};
pub use table::{Column, Kind, Row, Table};

/// The measurements, in the order in which they are made.
pub const NAMES: [&str; 5] = ["limits", "magnets", "elementary", "methods", "systems"];

/// Makes a measurement. `progress` is told what is being measured.
///
/// # Errors
/// Where there is none of this name, a peer does not do its part, or two sets of registers differ in a bit.
pub fn measure(name: &str, settings: &Settings, progress: &mut dyn FnMut(&str)) -> Result<Vec<Table>, Error> {
    match name {
        "limits" => limits::measure(settings, progress),
        "magnets" => magnets::measure(settings, progress),
        "elementary" => elementary::measure(settings, progress),
        "methods" => methods::measure(settings, progress),
        "systems" => systems::measure(settings, progress),
        _ => Err(precess::unknown("benchmark", name, NAMES).into()),
    }
}
