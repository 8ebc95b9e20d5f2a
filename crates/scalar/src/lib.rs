//! The numbers of Precess.
//!
//! An equation of mechanics is written once, generic over [`Scalar`], and then runs as a plain `f64`, as a
//! block of lanes ([`Batch`]), with twice the digits ([`DoubleDouble`]), as a derivative ([`Dual`]), as a
//! recorded expression ([`Traced`]) and on units of measure ([`Unit`]).

mod abreast;
mod batch;
mod carlson;
mod dependence;
mod double_double;
mod dual;
pub mod elementary;
mod elliptic;
mod isa;
mod lanes;
mod real;
pub mod register;
mod scalar;
mod traced;
mod unit;

pub use abreast::Abreast;
pub use batch::Batch;
pub use carlson::{rf, rj};
pub use dependence::Dependence;
pub use double_double::DoubleDouble;
pub use dual::Dual;
pub use elliptic::{Jacobi, jacobi};
pub use isa::{Isa, UnknownIsa};
pub use lanes::Lanes;
pub use register::{Narrow, Wide, Widest};
pub use scalar::{Kernel, Scalar};
pub use traced::{Entry, Notation, Printed, Tape, Taylor, Traced, Workspace};
pub use unit::{Dimension, Unit};
