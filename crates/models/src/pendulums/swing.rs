//! The pendulum without friction, in closed form.
//!
//!     sin(theta / 2) = k sn(omega t + c),     omega^2 = g / l,     k^2 = (theta' / (2 omega))^2 + sin^2(theta / 2)
//!
//! P has it that the equation cannot be solved; Jacobi's elliptic functions do. Beyond k = 1 it turns over, and the
//! functions of the modulus 1/k continue those of k. The start enters by their addition theorem, so that neither the
//! constant c is needed nor a case distinguished: with s, c, w the sine, the cosine and the speed at the start,
//!
//!     sin(theta / 2) = (s cn dn + w c sn) / n      cos(theta / 2) = (c dn - s w sn cn) / n
//!     theta' / (2 omega) = (w cn - s c sn dn) / n      n = c^2 + s^2 cn^2
//!
//! The angle is carried along over whole turns: it is never far from its mean motion, and the small rest is an arc tangent.

use precess_scalar::{Scalar, jacobi};

/// Angle and angular velocity after a time, for theta'' = -pull sin theta.
#[inline(always)]
pub(super) fn swing<S: Scalar>(pull: S, time: S, [theta, speed]: [S; 2]) -> [S; 2] {
    let (zero, one) = (S::from(0.0), S::from(1.0));
    let omega = pull.abs().sqrt();
    let (sin, cos) = (theta * 0.5).sin_cos();
    // Half the angle from where it hangs still: the top, if gravity points upwards.
    let upwards = pull.lt(zero);
    let (s, c) = (S::select(upwards, -cos, sin), S::select(upwards, sin, cos));
    let w = speed / (omega * 2.0);

    // 1 - k^2, negative where it turns over.
    let rest = (c.abs() - w.abs()) * (c.abs() + w.abs());
    let over = rest.lt(zero);
    let k = s.hypot(w);
    let u = omega * time * S::select(over, k, one);
    let f = jacobi(u, S::select(over, -(rest / (k * k)), rest));
    let sn = S::select(over, f.sn / k, f.sn);
    let (cn, dn) = (S::select(over, f.dn, f.cn), S::select(over, f.cn, f.dn));

    let n = c * c + s * s * cn * cn;
    let sine = (s * cn * dn + w * c * sn) / n;
    let cosine = (c * dn - s * w * sn * cn) / n;
    let rate = (w * cn - s * c * sn * dn) / n;

    // Half the angle that the mean motion makes, and what is ahead of it.
    let mean = S::select(over, w.sign() * f.mean * u, zero);
    let (sin_mean, cos_mean) = mean.sin_cos();
    let (s_mean, c_mean) = (s * cos_mean + c * sin_mean, c * cos_mean - s * sin_mean);
    let ahead = (sine * c_mean - cosine * s_mean).atan2(cosine * c_mean + sine * s_mean);
    let free = pull.abs().le(zero);
    [
        S::select(free, theta + speed * time, theta + (mean + ahead) * 2.0),
        S::select(free, speed, omega * rate * 2.0),
    ]
}
