//! The blow of a body that lands: Newton's restitution along the normal, Coulomb's friction across.
//!
//! A blow P at the contact changes the velocity u of the contact point by K P, with the axes e of the table
//!
//!     K_ij = delta_ij / m + (r x e_i).I^-1 (r x e_j)
//!
//! The normal part of u turns to -restitution of it. Across, the contact sticks where that takes at most mu times the
//! normal part of P; else P across is so large, against the slip before the blow. (That the slip may turn during a blow is left out, as in most
//! programs; with much eccentricity and friction Newton's rule can gain energy then: Kane 1984.)

use super::body::{plus, scaled};
use super::top::Seen;
use crate::inertia::solve;
use crate::rotation::{Vector, cross, dot, quotient};
use precess_scalar::Scalar;

/// The blow along the table's axes that stops the contact velocity u (its last component, downwards, below zero).
#[inline(always)]
pub(super) fn blow<S: Scalar>(seen: &Seen<S>, u: Vector<S>, mu: S, restitution: S) -> Vector<S> {
    let body = &seen.body;
    let arms = seen.rows.map(|row| cross(seen.touch.r, row));
    let turned = arms.map(|arm| solve(body.inertia, arm));
    let mut k = [0, 1, 2].map(|i| [0, 1, 2].map(|j| dot(arms[i], turned[j])));
    for i in 0..3 {
        k[i][i] = k[i][i] + S::from(1.0) / body.mass;
    }
    let back = -((restitution + 1.0) * u[2]);
    let sticking = solve(k, [-u[0], -u[1], back]);
    let slip = (u[0] * u[0] + u[1] * u[1]).sqrt();
    let [x, y] = [quotient(u[0], slip), quotient(u[1], slip)];
    let normal = back / (k[2][2] - mu * (k[2][0] * x + k[2][1] * y));
    let sliding = [-(mu * normal * x), -(mu * normal * y), normal];
    let across = (sticking[0] * sticking[0] + sticking[1] * sticking[1]).sqrt();
    let sticks = across.le(mu * sticking[2]);
    [0, 1, 2].map(|i| S::select(sticks, sticking[i], sliding[i]))
}

/// The change of the angular velocity that a blow makes, in body axes.
#[inline(always)]
pub(super) fn turn<S: Scalar>(seen: &Seen<S>, blow: Vector<S>) -> Vector<S> {
    let [x, y, z] = [0, 1, 2].map(|i| scaled(seen.rows[i], blow[i]));
    solve(seen.body.inertia, cross(seen.touch.r, plus(plus(x, y), z)))
}
