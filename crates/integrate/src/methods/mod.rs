//! The methods, one file each.

mod collocation;
mod compensated;
mod composition;
pub(crate) mod dop853;
mod dopri5;
mod euler;
mod euler_cromer;
mod euler_cromer_implicit;
mod euler_taylor;
mod exact;
mod fixed_point;
mod gauss_legendre16;
mod gauss_legendre4;
mod gauss_legendre6;
mod glide;
mod implicit_midpoint;
mod lie_midpoint;
mod newmark;
mod radau5;
mod rk4;
pub(crate) mod taylor;
mod tsit5;
mod verlet;
mod yoshida4;
mod yoshida6;
mod yoshida8;

use crate::AnyMethod;

/// What the lab's first page runs by.
pub static FIRST: &[&dyn AnyMethod] = &[&dop853::Dop853];

/// Every method, in the order in which a catalogue shows them.
pub static METHODS: &[&dyn AnyMethod] = &[
    &euler::Euler,
    &euler_taylor::EulerTaylor,
    &euler_cromer::EulerCromer,
    &euler_cromer_implicit::EulerCromerImplicit,
    &verlet::Verlet,
    &yoshida4::Yoshida4,
    &yoshida6::Yoshida6,
    &yoshida8::Yoshida8,
    &newmark::Newmark,
    &implicit_midpoint::ImplicitMidpoint,
    &lie_midpoint::LieMidpoint,
    &gauss_legendre4::GaussLegendre4,
    &gauss_legendre6::GaussLegendre6,
    &gauss_legendre16::GaussLegendre16,
    &rk4::Rk4,
    &dopri5::Dopri5,
    &tsit5::Tsit5,
    &dop853::Dop853,
    &radau5::Radau5,
    &taylor::Taylor,
    &exact::Exact,
];
