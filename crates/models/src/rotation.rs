//! The little geometry that bodies share: cross products, unit quaternions, Euler angles.
//!
//! A quaternion `[w, x, y, z]` turns body axes into space; Euler angles are those of T, section 2.1:
//! R = Rz(psi) Rx(theta) Rz(phi).

use precess_scalar::Scalar;

/// A vector.
pub(crate) type Vector<S> = [S; 3];
/// A quaternion `[w, x, y, z]`.
pub(crate) type Quaternion<S> = [S; 4];

/// Scalar product.
#[inline(always)]
pub(crate) fn dot<S: Scalar>(a: Vector<S>, b: Vector<S>) -> S {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Vector product.
#[inline(always)]
pub(crate) fn cross<S: Scalar>(a: Vector<S>, b: Vector<S>) -> Vector<S> {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Body axes to space. A quaternion that is not of unit length also stretches, by its square.
#[inline(always)]
pub(crate) fn to_space<S: Scalar>([w, x, y, z]: Quaternion<S>, v: Vector<S>) -> Vector<S> {
    let rows = [
        [w * w + x * x - y * y - z * z, (x * y - w * z) * 2.0, (x * z + w * y) * 2.0],
        [(x * y + w * z) * 2.0, w * w - x * x + y * y - z * z, (y * z - w * x) * 2.0],
        [(x * z - w * y) * 2.0, (y * z + w * x) * 2.0, w * w - x * x - y * y + z * z],
    ];
    [dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)]
}

/// The product of two quaternions: first the turn `b`, then `a`.
#[inline(always)]
pub(crate) fn product<S: Scalar>(a: Quaternion<S>, b: Quaternion<S>) -> Quaternion<S> {
    let ([s, u, v, w], [t, x, y, z]) = (a, b);
    [
        s * t - u * x - v * y - w * z,
        s * x + u * t + v * z - w * y,
        s * y - u * z + v * t + w * x,
        s * z + u * y - v * x + w * t,
    ]
}

/// The rate of a quaternion whose body turns with `omega` in body axes: half the product of both.
#[inline(always)]
pub(crate) fn quaternion_rate<S: Scalar>(
    [w, x, y, z]: Quaternion<S>,
    [o1, o2, o3]: Vector<S>,
) -> Quaternion<S> {
    [
        -(x * o1 + y * o2 + z * o3) * 0.5,
        (w * o1 + y * o3 - z * o2) * 0.5,
        (w * o2 + z * o1 - x * o3) * 0.5,
        (w * o3 + x * o2 - y * o1) * 0.5,
    ]
}

/// The unit quaternion of Euler angles (psi, theta, phi).
#[inline(always)]
pub(crate) fn from_euler<S: Scalar>([psi, theta, phi]: Vector<S>) -> Quaternion<S> {
    let (sin, cos) = (theta * 0.5).sin_cos();
    let (sin_sum, cos_sum) = ((psi + phi) * 0.5).sin_cos();
    let (sin_difference, cos_difference) = ((psi - phi) * 0.5).sin_cos();
    [cos * cos_sum, sin * cos_difference, sin * sin_difference, cos * sin_sum]
}

/// Angular velocity in body axes from Euler angles and their rates.
#[inline(always)]
pub(crate) fn omega_from_rates<S: Scalar>(
    [_psi, theta, phi]: Vector<S>,
    [psi_dot, theta_dot, phi_dot]: Vector<S>,
) -> Vector<S> {
    let ((sin, cos), (sin_phi, cos_phi)) = (theta.sin_cos(), phi.sin_cos());
    let across = psi_dot * sin;
    [across * sin_phi + theta_dot * cos_phi, across * cos_phi - theta_dot * sin_phi, psi_dot * cos + phi_dot]
}

/// Euler angles and their rates.
///
/// Half the sum of psi and phi is the angle of (w, z), half their difference that of (x, y), so the angles
/// come by `atan2` alone. Where the axis is vertical one of the two has no meaning and rests at zero.
#[inline(always)]
pub(crate) fn euler<S: Scalar>([w, x, y, z]: Quaternion<S>, omega: Vector<S>) -> [Vector<S>; 2] {
    let zero = S::from(0.0);
    let (upright, tilted) = (w * w + z * z, x * x + y * y);
    let (half_sum, half_difference) = (z.atan2(w), y.atan2(x));
    let theta = tilted.sqrt().atan2(upright.sqrt()) * 2.0;
    let phi = half_sum - half_difference;
    let (sin_phi, cos_phi) = phi.sin_cos();
    let theta_dot = omega[0] * cos_phi - omega[1] * sin_phi;
    // The rates of (w, z) and (x, y), less the halves of omega_3 in them, which would cancel in psi_dot.
    let across = omega[0] * (x * z - w * y) + omega[1] * (w * x + y * z);
    let (sum_rate, difference_rate) = (quotient(across, upright), quotient(across, tilted));
    let up = S::select(tilted.le(zero), omega[2], zero);
    let down = S::select(upright.le(zero), omega[2], zero);
    let psi_dot = (sum_rate + difference_rate + up - down) * 0.5;
    let phi_dot = omega[2] + (sum_rate - difference_rate - up - down) * 0.5;
    [[half_sum + half_difference, theta, phi], [psi_dot, theta_dot, phi_dot]]
}

/// `v` in axes whose third is the unit vector `normal` (from above; or its opposite, from below, where it points down):
/// turned by the shortest way, so that it is steady where the normal is.
#[inline(always)]
pub(crate) fn invariable_plane<S: Scalar>(normal: Vector<S>, v: Vector<S>) -> Vector<S> {
    let (zero, one) = (S::from(0.0), S::from(1.0));
    let side = S::select(normal[2].lt(zero), -one, one);
    let along = dot(normal, v);
    let share = (along + side * v[2]) / (side * normal[2] + 1.0);
    [v[0] - normal[0] * share, v[1] - normal[1] * share, along]
}

/// `a / b` for `b >= 0`, and zero where `b` is.
#[inline(always)]
pub(crate) fn quotient<S: Scalar>(a: S, b: S) -> S {
    let zero = S::from(0.0);
    S::select(b.le(zero), zero, a / b)
}
