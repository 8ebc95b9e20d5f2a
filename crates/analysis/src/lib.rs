//! What Precess asks of a mechanical system beyond a run: one question a file.
//!
//! All of them work on [`Field`](precess_system::Field)s, whatever the system, and on the methods of
//! `precess-integrate`. Derivatives come from dual numbers, never from differences.

mod flow;
mod frame;
mod least_squares;
mod lyapunov;
mod poincare;
mod student;
mod tangents;

pub use flow::{Flow, Stopped};
pub use least_squares::{Asked, Model, Outcome, Undetermined, least_squares};
pub use lyapunov::{Exponent, Lyapunov, lyapunov};
pub use poincare::{Crossing, Crossings, Section, section, strobe};
pub use student::quantile;
