//! What Precess asks of a mechanical system beyond a run: one question a file.
//!
//! All of them work on [`Field`](precess_system::Field)s, whatever the system, and on the methods of
//! `precess-integrate`. Derivatives come from dual numbers, never from differences.

mod flow;
mod frame;
mod lyapunov;
mod poincare;
mod tangents;

pub use flow::{Flow, Stopped};
pub use lyapunov::{Exponent, Lyapunov, lyapunov};
pub use poincare::{Crossing, Crossings, Section, section, strobe};
