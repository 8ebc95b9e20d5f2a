//! A convex body and where it touches the table.
//!
//! The support function h(n) = c.n + rho |n| + |A n|, A = diag(axes), says how far the body reaches in the direction n,
//! measured from G: a point c, made round by a ball of radius rho and by an ellipsoid. With the vertical gamma in body
//! axes (gamma' = gamma x omega) the body touches at
//!
//!     r = grad h(-gamma) = c - rho gamma - S gamma / sqrt(gamma.S gamma),   S = A^2
//!
//! and G is at the height h(-gamma) = -gamma.r. A test holds r and its rate against dual numbers of h.

use crate::inertia::Matrix;
use crate::rotation::{Vector, cross, dot};
use precess_scalar::Scalar;

/// Mass, inertia about G, and the support function.
#[derive(Clone, Copy)]
pub(super) struct Body<S> {
    pub mass: S,
    pub inertia: Matrix<S>,
    pub point: Vector<S>,
    pub radius: S,
    pub axes: Vector<S>,
}

/// Where a body touches, in body axes, from G; with the rates.
#[derive(Clone, Copy)]
pub(super) struct Touch<S> {
    pub gamma: Vector<S>,
    pub gamma_dot: Vector<S>,
    pub r: Vector<S>,
    pub r_dot: Vector<S>,
}

impl<S: Scalar> Body<S> {
    /// The contact point and its rate. G is at the height `-gamma.r`.
    #[inline(always)]
    pub fn touch(&self, gamma: Vector<S>, omega: Vector<S>) -> Touch<S> {
        let gamma_dot = cross(gamma, omega);
        let [a, b, c] = self.axes;
        let squares = [a * a, b * b, c * c];
        let along = componentwise(squares, gamma);
        let along_dot = componentwise(squares, gamma_dot);
        let square = dot(along, gamma);
        // A body without an ellipsoid has none to divide by.
        let none = square.le(S::from(0.0));
        let reach = S::select(none, self.radius, square.sqrt());
        let part = S::select(none, S::from(0.0), S::from(1.0) / reach);
        let turning = dot(along, gamma_dot) * part * part;
        let r = minus(minus(self.point, scaled(gamma, self.radius)), scaled(along, part));
        let bend = scaled(minus(along_dot, scaled(along, turning)), part);
        let r_dot = minus(scaled(gamma_dot, -self.radius), bend);
        Touch { gamma, gamma_dot, r, r_dot }
    }
}

/// Product component by component.
#[inline(always)]
fn componentwise<S: Scalar>(a: Vector<S>, b: Vector<S>) -> Vector<S> {
    [a[0] * b[0], a[1] * b[1], a[2] * b[2]]
}

/// a + b.
#[inline(always)]
pub(super) fn plus<S: Scalar>(a: Vector<S>, b: Vector<S>) -> Vector<S> {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// a - b.
#[inline(always)]
pub(super) fn minus<S: Scalar>(a: Vector<S>, b: Vector<S>) -> Vector<S> {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// k a.
#[inline(always)]
pub(super) fn scaled<S: Scalar>(a: Vector<S>, k: S) -> Vector<S> {
    [a[0] * k, a[1] * k, a[2] * k]
}
