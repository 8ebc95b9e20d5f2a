//! The integration methods of Precess, and what drives them.
//!
//! A method ([`Method`]) gives a [`Stepper`] for every kind of number; step-size control, dense output, events
//! and the drive that joins them are parts of their own, so that each method gets all of them.

mod adaptive;
mod block;
mod coefficient;
mod controller;
mod dense;
mod drive;
mod engine;
mod entered;
mod event;
mod failure;
mod fixed;
mod linear;
mod method;
mod methods;
mod pacer;
mod roster;
mod samples;
mod shadow;
mod side_by_side;
mod stretch;
mod tableau;

pub use block::Block;
pub use controller::{Controller, Tolerance};
pub use dense::Dense;
pub use drive::{Drive, Pace, Report, drive};
pub use event::{Observed, Occurred, Source, Watched};
pub use failure::Failure;
pub use method::{
    AnyMethod, Kind, LawNumbers, Method, MethodCard, Needs, NoConvergence, OptionCard, Options, Step,
    Stepper, Steps,
};
pub use methods::{FIRST, METHODS};
pub use roster::{Roster, Stepped};
pub use samples::Samples;
pub use shadow::Shadow;
