//! Arc functions: all are the angle of a point, whose coordinates may come in two parts.

use super::exact::{fast_two_sum, quotient, select_pair, square_root, two_prod, two_sum};
use super::polynomial::pairs;
use crate::Lanes;

/// pi/4 in two parts; the first ends in three zero bits, so that small multiples are exact.
const FRAC_PI_4: [f64; 2] = [std::f64::consts::FRAC_PI_4, 3.061616997868383e-17];

/// `(atan t / t - 1) / t^2` in `t^2`, error below `2^-58` of the angle on `|t| <= tan pi/8`.
const ATAN: [[f64; 2]; 6] = [
    [-0.33333333333333326, 0.19999999999997647],
    [-0.14285714285385281, 0.11111111088007201],
    [-0.0909090813833946, 0.07692282617772994],
    [-0.06666224661962555, 0.058770011324641255],
    [-0.05218270434515975, 0.045030010710911415],
    [-0.03346160745442328, 0.015182020762440955],
];

#[inline(always)]
fn magnitude<S: Lanes>(x: (S, S)) -> (S, S) {
    (x.0.abs(), S::select(x.0.below(0.0), -x.1, x.1))
}

/// Angle of the point (x, y), for finite coordinates well inside the range of exponents.
#[inline(always)]
fn angle<S: Lanes>(y: (S, S), x: (S, S)) -> S {
    let (zero, one) = (S::from(0.0), S::from(1.0));
    let (tall, wide) = (magnitude(y), magnitude(x));
    // Fold into the first octant, then about its middle: |t| <= tan(pi/8).
    let steep = tall.0.gt(wide.0);
    let long = select_pair(steep, tall, wide);
    let short = select_pair(steep, wide, tall);
    let folded = short.0.gt(long.0 * 0.41421356237309503);
    let difference = two_sum(short.0, -long.0);
    let sum = fast_two_sum(long.0, short.0);
    let difference = (difference.0, difference.1 + (short.1 - long.1));
    let sum = (sum.0, sum.1 + (long.1 + short.1));
    let numerator = select_pair(folded, difference, short);
    let denominator = select_pair(folded, sum, long);
    let denominator = select_pair(denominator.0.is(0.0), (one, zero), denominator);
    let (t, error) = quotient(numerator, denominator);
    // Below this the remainder of the division is itself subject to underflow.
    let error = S::select(numerator.0.abs().below(1e-280), zero, error);
    let square = t * t;
    let rest = (t * square) * pairs(square, ATAN) + error * (one - square);

    let eighths = S::select(folded, one, zero);
    let eighths = S::select(steep, S::from(2.0) - eighths, eighths);
    let behind = x.0.is_negative();
    let eighths = S::select(behind, S::from(4.0) - eighths, eighths);
    let turned = (steep & !behind) | (behind & !steep);
    let sign = S::select(turned, S::from(-1.0), one);
    let (high, low) = fast_two_sum(eighths * FRAC_PI_4[0], sign * t);
    let angle = high + (low + (eighths * FRAC_PI_4[1] + sign * rest));
    angle.with_sign(y.0)
}

/// Angle of the point (`x`, `y`), within 2 ulp.
#[inline(always)]
pub fn atan2<S: Lanes>(y: S, x: S) -> S {
    let (zero, one) = (S::from(0.0), S::from(1.0));
    let (tall, wide) = (y.abs(), x.abs());
    let long = S::select(tall.gt(wide), tall, wide);
    let factor = S::select(long.below(1e-210), S::from(1.2676506002282294e30), one);
    let factor = S::select(long.above(1e270), S::from(7.888609052210118e-31), factor);
    // Infinite coordinates lie on the axes and the diagonals.
    let infinite = long.is(f64::INFINITY);
    let tall_corner = S::select(tall.is(f64::INFINITY), one, zero);
    let wide_corner = S::select(wide.is(f64::INFINITY), one, zero);
    let tall = S::select(infinite, tall_corner, tall * factor);
    let wide = S::select(infinite, wide_corner, wide * factor);
    let angle = angle((tall.with_sign(y), zero), (wide.with_sign(x), zero));
    S::select(x.is_nan() | y.is_nan(), S::from(f64::NAN), angle)
}

/// `sqrt(1 - x^2)` in two parts.
#[inline(always)]
fn complement<S: Lanes>(x: S) -> (S, S) {
    let (square, error) = two_prod(x, x);
    let (high, low) = fast_two_sum(S::from(1.0), -square);
    square_root((high, low - error))
}

/// Arc sine, within 2 ulp; NaN outside [-1, 1].
#[inline(always)]
pub fn asin<S: Lanes>(x: S) -> S {
    inside(x, angle((x, S::from(0.0)), complement(x)))
}

/// Arc cosine, within 2 ulp; NaN outside [-1, 1].
#[inline(always)]
pub fn acos<S: Lanes>(x: S) -> S {
    inside(x, angle(complement(x), (x, S::from(0.0))))
}

/// NaN where no angle has such a sine.
#[inline(always)]
fn inside<S: Lanes>(x: S, angle: S) -> S {
    S::select(x.abs().le(S::from(1.0)), angle, S::from(f64::NAN))
}
