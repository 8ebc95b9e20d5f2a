//! The methods, one file each.

mod dop853;
mod dopri5;
mod euler;
mod euler_cromer;
mod euler_taylor;
mod glide;
mod newmark;
mod rk4;
mod verlet;

use crate::AnyMethod;

/// Every method, in the order in which a catalogue shows them.
pub static METHODS: &[&dyn AnyMethod] = &[
    &euler::Euler,
    &euler_taylor::EulerTaylor,
    &euler_cromer::EulerCromer,
    &verlet::Verlet,
    &newmark::Newmark,
    &rk4::Rk4,
    &dopri5::Dopri5,
    &dop853::Dop853,
];
