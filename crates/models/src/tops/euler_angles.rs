//! What the tops that T writes in Euler angles share.
//!
//! The axes are T's (u, b, a), which follow the axis but not the proper rotation; there
//!
//!     omega = (theta', psi' sin theta, psi' cos theta + phi')                                     (1)
//!     theta'' = omega1'    psi'' = (omega2' - psi' theta' cos theta) / sin theta
//!     phi'' = omega3' + psi' theta' sin theta - psi'' cos theta                                   (2)
//!
//! **On the vertical** (2) divides by zero. A motion that passes through it has there psi'' = 0 and one rate of
//! precession, such as `psi' = i3 omega3 / (2 I_A1)` for the gyroscope (minus that at theta = pi): the numerator vanishes
//! with the denominator. T's `psi' = psi'' = 0` at theta = 0 (2.1, 2.2) gives this rate to the proper rotation instead and
//! is wrong. A start on the vertical is therefore given that rate by [`start_on_the_vertical`].

use crate::rotation::Vector;
use precess_scalar::Scalar;
use precess_system::{Card, Coordinate, State, coordinate};
use std::f64::consts::PI;

/// A sine below this is on the vertical: pi itself, rounded, has one of 1.2e-16.
const VERTICAL: f64 = 1e-12;

/// T's (1): the angular velocity in (u, b, a). psi, theta, phi are the first coordinates, their rates the first
/// velocities, of every state that uses this.
#[inline(always)]
pub(super) fn omega<S: Scalar>(s: &State<S>) -> Vector<S> {
    let ([_psi, theta], [psi_dot, theta_dot, phi_dot]) = (s.q(), s.v());
    let (sin, cos) = theta.sin_cos();
    [theta_dot, psi_dot * sin, psi_dot * cos + phi_dot]
}

/// T's (2): (psi'', theta'', phi'') from the derivatives of omega's components in (u, b, a).
#[inline(always)]
pub(super) fn accelerations<S: Scalar>(s: &State<S>, omega_dot: Vector<S>) -> Vector<S> {
    let ([_psi, theta], [psi_dot, theta_dot]) = (s.q(), s.v());
    let (sin, cos) = theta.sin_cos();
    let psi_ddot = over_sine(omega_dot[1] - psi_dot * theta_dot * cos, sin);
    [psi_ddot, omega_dot[0], omega_dot[2] + psi_dot * theta_dot * sin - psi_ddot * cos]
}

/// A quotient by sin theta that vanishes on the vertical.
#[inline(always)]
pub(super) fn over_sine<S: Scalar>(numerator: S, sin: S) -> S {
    S::select(sin.abs().le(S::from(VERTICAL)), S::from(0.0), numerator / sin)
}

/// From (u, b, a) to space: the transpose of T's matrix S (2.1).
#[inline(always)]
pub(super) fn to_space<S: Scalar>(s: &State<S>, [u, b, a]: Vector<S>) -> Vector<S> {
    let [psi, theta] = s.q();
    let ((sin_psi, cos_psi), (sin, cos)) = (psi.sin_cos(), theta.sin_cos());
    let across = a * sin - b * cos;
    [u * cos_psi + across * sin_psi, u * sin_psi - across * cos_psi, b * sin + a * cos]
}

/// The axis in space.
#[inline(always)]
pub(super) fn axis<S: Scalar>(s: &State<S>) -> Vector<S> {
    let [psi, theta] = s.q();
    let ((sin_psi, cos_psi), (sin, cos)) = (psi.sin_cos(), theta.sin_cos());
    [sin_psi * sin, -(cos_psi * sin), cos]
}

/// The three angles, first or second order as `order` makes them, at T's start (6.1): tilted by pi/6.
pub(super) fn angles(card: Card, order: fn(Coordinate) -> Coordinate) -> Card {
    card.coordinate(order(coordinate("psi", "rad", "precession", "précession")))
        .coordinate(order(coordinate("theta", "rad", "nutation", "nutation").start(PI / 6.0)))
        .coordinate(order(coordinate("phi", "rad", "proper rotation", "rotation propre").start_dot(60.0)))
}

/// Adds the components of omega and the axis in space as observables.
pub(super) fn omega_and_axis(card: Card) -> Card {
    card.signal("omega1", "rad/s", "angular velocity along u", "vitesse angulaire selon u")
        .signal("omega2", "rad/s", "angular velocity along b", "vitesse angulaire selon b")
        .signal("omega3", "rad/s", "angular velocity along the axis", "vitesse angulaire selon l'axe")
        .signal("axis_x", "", "axis, first component", "axe, première composante")
        .signal("axis_y", "", "axis, second component", "axe, deuxième composante")
        .signal("axis_z", "", "axis, upward component", "axe, composante verticale")
}

/// Gives a start on the vertical that leaves it the rate of precession of the limit: `share` of omega3.
///
/// `y` is the coordinates, then the velocities from `first` on. A start at rest on the vertical (theta' = 0) stays there,
/// a sleeping top, whatever its psi'.
pub(super) fn start_on_the_vertical(y: &mut [f64], first: usize, share: f64) {
    let (sin, cos) = Scalar::sin_cos(y[1]);
    let [psi_dot, theta_dot, phi_dot] = [0, 1, 2].map(|i| y[first + i]);
    if sin.abs() > VERTICAL || theta_dot == 0.0 {
        return;
    }
    let up = Scalar::sign(cos);
    let omega3 = psi_dot * up + phi_dot;
    y[first] = omega3 * share * up;
    y[first + 2] = omega3 - omega3 * share;
}
