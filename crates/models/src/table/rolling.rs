//! A body that rolls without slipping.
//!
//! With v the velocity of G in body axes, G the gravity felt, T a torque besides, and F the force at the contact:
//!
//!     v = r x omega                                                             (the contact point of the body rests)
//!     m (v' + omega x v) = F + m G,    I omega' + omega x I omega = r x F + T
//!     (I + m (r.r 1 - r r^T)) omega' = T - omega x I omega + m r x (r' x omega + omega x (r x omega) - G)
//!     F = m (r' x omega + r x omega' + omega x (r x omega) - G)
//!
//! (T, frame on page 12, whose (9) lacks what the moving contact adds: here it is the term with r'.)

use super::body::{Body, Touch, minus, plus, scaled};
use crate::inertia::{apply, solve, transferred};
use crate::rotation::{Vector, cross};
use precess_scalar::Scalar;

/// Angular acceleration and contact force, in body axes.
pub(super) struct Rolling<S> {
    pub omega_dot: Vector<S>,
    pub force: Vector<S>,
}

/// Rolling without slipping; `gravity` and `torque` in body axes.
#[inline(always)]
pub(super) fn roll<S: Scalar>(
    body: &Body<S>,
    touch: &Touch<S>,
    omega: Vector<S>,
    gravity: Vector<S>,
    torque: Vector<S>,
) -> Rolling<S> {
    let Touch { r, r_dot, .. } = *touch;
    let known = minus(plus(cross(r_dot, omega), cross(omega, cross(r, omega))), gravity);
    let spin = cross(omega, apply(body.inertia, omega));
    let moment = plus(minus(torque, spin), cross(scaled(r, body.mass), known));
    let omega_dot = solve(transferred(body.inertia, body.mass, r), moment);
    let force = scaled(plus(known, cross(r, omega_dot)), body.mass);
    Rolling { omega_dot, force }
}
