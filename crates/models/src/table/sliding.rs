//! A body that keeps to the table and slips: the normal force from the constraint.
//!
//! With `e_x`, `e_y`, gamma the table's axes in body axes, u = v + omega x r the slip, c = r x gamma, and a contact that acts
//! with the force N gamma + |N| k and the moment |N| d gamma (k and d from the law of friction; s the sign of base):
//!
//!     z' = -c.omega                                                       (the contact point stays on the table)
//!     base = -G_z - gamma'.(omega x r) - gamma.(omega x r') + (I^-1 c).(omega x I omega - T)
//!     N = base / (1/m + (I^-1 c).(c + s (r x k + d gamma)))
//!     I omega' = N (c + s (r x k + d gamma)) - omega x I omega + T,     m x'' = |N| k_x + m G_x,     m y'' = |N| k_y
//!
//! Where N reaches zero a free contact lifts off; one that is kept pulls, as a guide with two sides, and rubs all the same; where the denominator does, no finite force keeps the body from the
//! table (Painleve 1895). See `regimes.rs`.

use super::body::{Body, Touch, minus, plus, scaled};
use super::friction::Grip;
use crate::inertia::{apply, solve};
use crate::rotation::{Vector, cross, dot};
use precess_scalar::Scalar;

/// What the contact does to a body that slips.
pub(super) struct Sliding<S> {
    pub omega_dot: Vector<S>,
    /// Normal force.
    pub normal: S,
    /// Its size, which friction goes by.
    pub pressed: S,
    /// Normal acceleration of the contact point per normal force: Painleve's denominator.
    pub denominator: S,
}

/// Sliding; `rows` are the table's axes in body axes, `fall` the gravity along the normal.
#[inline(always)]
pub(super) fn slide<S: Scalar>(
    body: &Body<S>,
    touch: &Touch<S>,
    rows: &[Vector<S>; 3],
    omega: Vector<S>,
    fall: S,
    torque: Vector<S>,
    grip: &Grip<S>,
) -> Sliding<S> {
    let Touch { gamma, gamma_dot, r, r_dot } = *touch;
    let spin = minus(cross(omega, apply(body.inertia, omega)), torque);
    let arm = cross(r, gamma);
    let turned = solve(body.inertia, arm);
    let push = plus(scaled(rows[0], grip.k[0]), scaled(rows[1], grip.k[1]));
    let base = dot(turned, spin) - fall - dot(gamma_dot, cross(omega, r)) - dot(gamma, cross(omega, r_dot));
    let side = S::select(base.lt(S::from(0.0)), S::from(-1.0), S::from(1.0));
    let moment = plus(arm, scaled(plus(cross(r, push), scaled(gamma, grip.drill)), side));
    let denominator = S::from(1.0) / body.mass + dot(turned, moment);
    let normal = base / denominator;
    let omega_dot = solve(body.inertia, minus(scaled(moment, normal), spin));
    Sliding { omega_dot, normal, pressed: normal * side, denominator }
}
