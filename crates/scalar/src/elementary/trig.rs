//! Sine, cosine, tangent: reduction by multiples of pi/2 (Cody and Waite 1980), then a polynomial.

use super::exact::{fast_two_sum, quotient, round, select_pair};
use super::{huge, polynomial::pairs};
use crate::Lanes;
use crate::register::Word;

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
pub struct Reduced<S: Lanes> {
    /// Number of quarter turns, modulo a power of two.
    pub quadrant: Word<S::Register>,
    /// The rest.
    pub rest: S,
    /// What the rest leaves out.
    pub tail: S,
}

/// Ordinary reduction. Each subtraction is either exact or leaves its rounding error in the tail.
///
/// The double below [`HUGE`] that this serves worst, 46066.74387591393, has a rest 2.3 times the last
/// product: that one's own error is then 0.4 ulp of the sine, and nothing else errs.
#[inline(always)]
fn ordinary<S: Lanes>(x: S) -> Reduced<S> {
    let (n, quadrant) = round(x * std::f64::consts::FRAC_2_PI);
    let first = x - n * PIO2[0];
    let (rest, error) = fast_two_sum(first, -(n * PIO2[1]));
    Reduced { quadrant, rest, tail: error - n * PIO2[2] }
}

/// Reduction of any finite angle.
#[inline(always)]
fn reduce<S: Lanes>(x: S) -> Reduced<S> {
    let Reduced { mut quadrant, mut rest, mut tail } = ordinary(x);
    let far = S::from(HUGE).le(x.abs());
    if S::any(far) {
        // Field by field: assigned as a whole, the ordinary case would go through memory, too.
        let patched = huge::patch(x, S::truth(far), Reduced { quadrant, rest, tail });
        (quadrant, rest, tail) = (patched.quadrant, patched.rest, patched.tail);
    }
    Reduced { quadrant, rest, tail }
}

/// Sine and cosine of the rest, each as a leading part and a correction.
#[inline(always)]
fn kernel<S: Lanes>(r: S, tail: S) -> ((S, S), (S, S)) {
    let square = r * r;
    let half = square * 0.5;
    let one = S::from(1.0) - half;
    let bend = (r * square) * pairs(square, SIN);
    let sin = bend + tail * one;
    // The tail may be some units of the rest: its factor is sin r, and r would not do.
    let cos = ((S::from(1.0) - one) - half) + ((square * square) * pairs(square, COS) - (r + bend) * tail);
    ((r, sin), (one, cos))
}

/// Sine and cosine, each within 1 ulp for every argument.
#[inline(always)]
pub fn sin_cos<S: Lanes>(x: S) -> (S, S) {
    let angle = reduce(x);
    let (sin, cos) = kernel(angle.rest, angle.tail);
    // The sign of a zero would be lost in the sum.
    let sin = (sin.0 + sin.1).with_sign(angle.rest);
    let cos = cos.0 + cos.1;
    let odd = S::odd(angle.quadrant);
    let sin_sign = (angle.quadrant & 2).left(62);
    let cos_sign = ((angle.quadrant + 1) & 2).left(62);
    let (s, c) = (S::select(odd, cos, sin), S::select(odd, sin, cos));
    (S::of_bits(s.bits() ^ sin_sign), S::of_bits(c.bits() ^ cos_sign))
}

/// Tangent, within 2 ulp for every argument.
#[inline(always)]
pub fn tan<S: Lanes>(x: S) -> S {
    let angle = reduce(x);
    let (sin, cos) = kernel(angle.rest, angle.tail);
    let sin = fast_two_sum(sin.0, sin.1);
    let cos = fast_two_sum(cos.0, cos.1);
    let odd = S::odd(angle.quadrant);
    let minus_sin = (-sin.0, -sin.1);
    let (ratio, correction) = quotient(select_pair(odd, cos, sin), select_pair(odd, minus_sin, cos));
    // The sign of a zero, again.
    S::select(angle.rest.is(0.0) & !odd, angle.rest, ratio + correction)
}
