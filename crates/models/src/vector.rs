//! Vectors of three components and rotations by unit quaternions.

use precess_scalar::Scalar;

/// Cross product.
pub fn cross<S: Scalar>(a: [S; 3], b: [S; 3]) -> [S; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Scalar product.
pub fn dot<S: Scalar>(a: [S; 3], b: [S; 3]) -> S {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// A vector given in body axes, in space axes: q v q* for a unit quaternion q = (w, x, y, z).
pub fn to_space<S: Scalar>([w, x, y, z]: [S; 4], v: [S; 3]) -> [S; 3] {
    let u = [x, y, z];
    let once = cross(u, v);
    let twice = cross(u, once);
    std::array::from_fn(|i| v[i] + (w * once[i] + twice[i]) * 2.0)
}

/// Rate of the attitude under the angular velocity in body axes: q' = q (0, omega) / 2.
pub fn attitude_rate<S: Scalar>([w, x, y, z]: [S; 4], [a, b, c]: [S; 3]) -> [S; 4] {
    [
        -(x * a + y * b + z * c) * 0.5,
        (w * a + y * c - z * b) * 0.5,
        (w * b + z * a - x * c) * 0.5,
        (w * c + x * b - y * a) * 0.5,
    ]
}

/// The attitude Rz(psi) Rx(theta) Rz(phi) as a quaternion.
pub fn from_euler<S: Scalar>([psi, theta, phi]: [S; 3]) -> [S; 4] {
    let (sin, cos) = (theta * 0.5).sin_cos();
    let (sin_sum, cos_sum) = ((psi + phi) * 0.5).sin_cos();
    let (sin_difference, cos_difference) = ((psi - phi) * 0.5).sin_cos();
    [cos * cos_sum, sin * cos_difference, sin * sin_difference, cos * sin_sum]
}

/// The Euler angles (psi, theta, phi) of an attitude; theta in [0, pi], the others within a turn and a half.
pub fn to_euler<S: Scalar>([w, x, y, z]: [S; 4]) -> [S; 3] {
    let theta = x.hypot(y).atan2(w.hypot(z)) * 2.0;
    let (half_sum, half_difference) = (z.atan2(w), y.atan2(x));
    [half_sum + half_difference, theta, half_sum - half_difference]
}

/// Angular velocity in body axes from Euler angles and their rates.
pub fn spin_from_euler<S: Scalar>([_, theta, phi]: [S; 3], [psi_dot, theta_dot, phi_dot]: [S; 3]) -> [S; 3] {
    let ((sin_t, cos_t), (sin, cos)) = (theta.sin_cos(), phi.sin_cos());
    let across = psi_dot * sin_t;
    [across * sin + theta_dot * cos, across * cos - theta_dot * sin, psi_dot * cos_t + phi_dot]
}

/// Rates of the Euler angles from the angular velocity in body axes; singular at theta = 0 and pi.
pub fn euler_from_spin<S: Scalar>([_, theta, phi]: [S; 3], [w1, w2, w3]: [S; 3]) -> [S; 3] {
    let ((sin_t, cos_t), (sin, cos)) = (theta.sin_cos(), phi.sin_cos());
    let psi_dot = (w1 * sin + w2 * cos) / sin_t;
    [psi_dot, w1 * cos - w2 * sin, w3 - psi_dot * cos_t]
}
