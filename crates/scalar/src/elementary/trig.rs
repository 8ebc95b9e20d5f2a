//! Sine, cosine, tangent: reduction by multiples of pi/2 (Cody and Waite 1980), then a polynomial.

use super::exact::{fast_two_sum, quotient, round};
use super::{huge, polynomial::pairs};

/// From here on the argument is reduced by [`huge`].
const HUGE: f64 = 262144.0;

/// pi/2 in three parts; the first two have 33 bits, so that their products with a quadrant are exact.
const PIO2: [f64; 3] = [1.5707963267341256, 6.077100506303966e-11, 2.0222662487959506e-21];

/// `(sin r / r - 1) / r^2` in `r^2`, error below `2^-56.7` of the sine on |r| <= pi/4.
const SIN: [[f64; 2]; 3] = [
    [-0.16666666666666632, 0.008333333333322314],
    [-0.00019841269829724942, 2.7557313661979493e-06],
    [-2.505075325375908e-08, 1.5896504385021326e-10],
];
/// `(cos r - 1 + r^2/2) / r^4` in `r^2`, error below `2^-59.6`.
const COS: [[f64; 2]; 3] = [
    [0.0416666666666666, -0.001388888888887399],
    [2.4801587289394574e-05, -2.7557314325944354e-07],
    [2.0875719548592885e-09, -1.1359448224718657e-11],
];

/// An angle as a quadrant (modulo four counts) and a rest of at most pi/4 in two parts.
#[derive(Clone, Copy)]
pub struct Reduced {
    /// Number of quarter turns, modulo a power of two.
    pub quadrant: u64,
    /// The rest.
    pub rest: f64,
    /// What the rest leaves out.
    pub tail: f64,
}

/// Whether the argument is finite and beyond the reach of the ordinary reduction.
#[inline(always)]
pub fn is_huge(x: f64) -> bool {
    let size = x.abs();
    (size >= HUGE) & (size < f64::INFINITY)
}

/// Ordinary reduction. Each subtraction is either exact or leaves its rounding error in the tail.
///
/// The double below [`HUGE`] that this serves worst, 46066.74387591393, has a rest 2.3 times the last
/// product: that one's own error is then 0.4 ulp of the sine, and nothing else errs.
#[inline(always)]
fn reduce(x: f64) -> Reduced {
    let (n, quadrant) = round(x * std::f64::consts::FRAC_2_PI);
    let first = x - n * PIO2[0];
    let (rest, error) = fast_two_sum(first, -(n * PIO2[1]));
    Reduced { quadrant, rest, tail: error - n * PIO2[2] }
}

/// Sine and cosine of the rest, each as a leading part and a correction.
#[inline(always)]
fn kernel(r: f64, tail: f64) -> ((f64, f64), (f64, f64)) {
    let square = r * r;
    let half = square * 0.5;
    let one = 1.0 - half;
    let bend = (r * square) * pairs(square, SIN);
    let sin = bend + tail * one;
    // The tail may be some units of the rest: its factor is sin r, and r would not do.
    let cos = ((1.0 - one) - half) + ((square * square) * pairs(square, COS) - (r + bend) * tail);
    ((r, sin), (one, cos))
}

#[inline(always)]
fn sin_cos_of(angle: Reduced) -> (f64, f64) {
    let (sin, cos) = kernel(angle.rest, angle.tail);
    // The sign of a zero would be lost in the sum.
    let sin = (sin.0 + sin.1).copysign(angle.rest);
    let cos = cos.0 + cos.1;
    let odd = angle.quadrant & 1 != 0;
    let sin_sign = (angle.quadrant & 2) << 62;
    let cos_sign = (angle.quadrant.wrapping_add(1) & 2) << 62;
    let (s, c) = (if odd { cos } else { sin }, if odd { sin } else { cos });
    (f64::from_bits(s.to_bits() ^ sin_sign), f64::from_bits(c.to_bits() ^ cos_sign))
}

#[inline(always)]
fn tan_of(angle: Reduced) -> f64 {
    let (sin, cos) = kernel(angle.rest, angle.tail);
    let sin = fast_two_sum(sin.0, sin.1);
    let cos = fast_two_sum(cos.0, cos.1);
    let odd = angle.quadrant & 1 != 0;
    let minus_sin = (-sin.0, -sin.1);
    let (ratio, correction) = quotient(if odd { cos } else { sin }, if odd { minus_sin } else { cos });
    // The sign of a zero, again.
    let tan = ratio + correction;
    if angle.rest == 0.0 && !odd { angle.rest } else { tan }
}

/// Sine and cosine of an argument that is not huge.
#[inline(always)]
pub fn ordinary_sin_cos(x: f64) -> (f64, f64) {
    sin_cos_of(reduce(x))
}

/// Tangent of an argument that is not huge.
#[inline(always)]
pub fn ordinary_tan(x: f64) -> f64 {
    tan_of(reduce(x))
}

/// Sine and cosine, each within 1 ulp for every argument.
#[inline(always)]
pub fn sin_cos(x: f64) -> (f64, f64) {
    sin_cos_of(if is_huge(x) { huge::reduce(x) } else { reduce(x) })
}

/// Tangent, within 2 ulp for every argument.
#[inline(always)]
pub fn tan(x: f64) -> f64 {
    tan_of(if is_huge(x) { huge::reduce(x) } else { reduce(x) })
}
