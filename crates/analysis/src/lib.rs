//! What Precess asks of a mechanical system beyond a run: one question a file.
//!
//! All of them work on [`Field`](precess_system::Field)s, whatever the system, and on the methods of
//! `precess-integrate`. Derivatives come from dual numbers, never from differences.

mod bifurcation;
mod contour;
mod eigenvalues;
mod fixed_points;
mod floquet;
mod flow;
mod frame;
mod least_squares;
mod linear;
mod lyapunov;
mod matrix;
mod poincare;
mod portrait;
mod response;
mod student;
mod tangents;

pub use bifurcation::{Visit, visits};
pub use contour::{Line, contour};
pub use eigenvalues::{Complex, eigenvalues};
pub use fixed_points::{FixedPoint, Kind, Window, classify, fixed_points};
pub use floquet::{Multipliers, multipliers};
pub use flow::{Flow, Stopped};
pub use least_squares::{Asked, Model, Outcome, Undetermined, least_squares};
pub use linear::{Linear, linear};
pub use lyapunov::{Exponent, Lyapunov, lyapunov};
pub use matrix::Matrix;
pub use poincare::{Crossing, Crossings, Section, section, strobe};
pub use portrait::{Branch, at_rest, levels, separatrices, trail};
pub use response::{Response, exact_response, response};
pub use student::quantile;
pub use tangents::jacobian;
