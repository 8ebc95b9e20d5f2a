//! Where systems, methods and users meet: what every face of Precess depends on.
//!
//! A [`Scenario`] (TOML, or built in code) is held against the cards and becomes a [`Plan`]; running it gives
//! an [`Outcome`] with a trajectory, what it cost and the drift of its invariants; [`picture`] turns that
//! into a [`figure::Figure`].

#[cfg(feature = "analyses")]
pub mod analyses;
mod answer;
pub mod basins;
pub mod body;
mod canonical;
pub mod catalogue;
mod compare;
mod describe;
mod drift;
mod ensemble;
mod error;
mod family;
pub mod figure;
mod grid;
mod hash;
pub mod json;
mod members;
mod page;
mod panel;
mod picture;
mod plan;
mod premises;
mod random;
mod resolve;
mod run;
mod satellites;
mod scenario;
pub mod scenarios;
pub mod survey;
mod trust;
pub mod value;
mod workers;

pub use answer::{Answer, Progress};
pub use canonical::{scenario_toml, spelt_out};
pub use compare::{Comparison, Contender, compare};
pub use describe::{Equations, equations, parameter_names, record};
pub use drift::{Drift, departures, drifts};
pub use ensemble::ensemble;
pub use error::{Error, unknown};
pub use family::FamilyMember;
pub use grid::{Axis, combinations, grid, starts};
pub use hash::{hash, hash_numbers, hash_text};
pub use members::{Keep, Members};
pub use page::page;
pub use picture::picture;
pub use plan::{PanelPlan, Plan, Step, Watch};
pub use run::{Outcome, Provenance, columns, run};
pub use scenario::{
    EnsembleSpec, EventSpec, FamilySpec, FigureKind, FigureSpec, Kept, Scenario, Source, Words,
};
pub use trust::trust;
pub use workers::Workers;

#[cfg(feature = "analyses")]
pub use precess_analysis as analysis;
pub use precess_integrate as integrate;
pub use precess_scalar as scalar;
pub use precess_system as system;
