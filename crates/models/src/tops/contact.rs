//! T's general formulation (4.2): the moment equation about a contact point A that rolls, step by step.
//!
//!     omega' = I_A^-1 (M_A - omega_e x I_A omega - I_A' omega)                                        (9)
//!
//! All components are those in (u, b, a), which turn with `omega_e = omega - phi' a`.

use crate::inertia::{Matrix, apply, solve};
use crate::rotation::{Vector, cross};
use precess_scalar::Scalar;
use precess_system::State;

/// The rates of omega's components. `rest` is what else stands on the left of (9), such as `I_A' omega`.
#[inline(always)]
pub(super) fn omega_rate<S: Scalar>(
    s: &State<S>,
    inertia: Matrix<S>,
    omega: Vector<S>,
    moment: Vector<S>,
    rest: Vector<S>,
) -> Vector<S> {
    let [_psi_dot, _theta_dot, phi_dot] = s.v();
    let omega_e = [omega[0], omega[1], omega[2] - phi_dot];
    let carried = cross(omega_e, apply(inertia, omega));
    let left = [
        moment[0] - carried[0] - rest[0],
        moment[1] - carried[1] - rest[1],
        moment[2] - carried[2] - rest[2],
    ];
    solve(inertia, left)
}

/// The vertical k in (u, b, a).
#[inline(always)]
pub(super) fn vertical<S: Scalar>(s: &State<S>) -> Vector<S> {
    let [_psi, theta] = s.q();
    let (sin, cos) = theta.sin_cos();
    [S::from(0.0), sin, cos]
}
