//! Arc functions: all are the angle of a point, whose coordinates may come in two parts.

use super::exact::{fast_two_sum, quotient, square_root, two_prod, two_sum};
use super::polynomial::pairs;

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
fn magnitude(x: (f64, f64)) -> (f64, f64) {
    (x.0.abs(), if x.0 < 0.0 { -x.1 } else { x.1 })
}

/// Angle of the point (x, y), for finite coordinates well inside the range of exponents.
#[inline(always)]
fn angle(y: (f64, f64), x: (f64, f64)) -> f64 {
    let (tall, wide) = (magnitude(y), magnitude(x));
    // Fold into the first octant, then about its middle: |t| <= tan(pi/8).
    let steep = tall.0 > wide.0;
    let long = if steep { tall } else { wide };
    let short = if steep { wide } else { tall };
    let folded = short.0 > long.0 * 0.41421356237309503;
    let difference = two_sum(short.0, -long.0);
    let sum = fast_two_sum(long.0, short.0);
    let difference = (difference.0, difference.1 + (short.1 - long.1));
    let sum = (sum.0, sum.1 + (long.1 + short.1));
    let numerator = if folded { difference } else { short };
    let denominator = if folded { sum } else { long };
    let denominator = if denominator.0 == 0.0 { (1.0, 0.0) } else { denominator };
    let (t, error) = quotient(numerator, denominator);
    // Below this the remainder of the division is itself subject to underflow.
    let error = if numerator.0.abs() < 1e-280 { 0.0 } else { error };
    let square = t * t;
    let rest = (t * square) * pairs(square, ATAN) + error * (1.0 - square);

    let eighths = if folded { 1.0 } else { 0.0 };
    let eighths = if steep { 2.0 - eighths } else { eighths };
    let behind = x.0.is_sign_negative();
    let eighths = if behind { 4.0 - eighths } else { eighths };
    let sign = if steep == behind { 1.0 } else { -1.0 };
    let (high, low) = fast_two_sum(eighths * FRAC_PI_4[0], sign * t);
    let angle = high + (low + (eighths * FRAC_PI_4[1] + sign * rest));
    angle.copysign(y.0)
}

/// Angle of the point (`x`, `y`), within 2 ulp.
#[inline(always)]
pub fn atan2(y: f64, x: f64) -> f64 {
    let (tall, wide) = (y.abs(), x.abs());
    let long = if tall > wide { tall } else { wide };
    let factor = if long < 1e-210 { 1.2676506002282294e30 } else { 1.0 };
    let factor = if long > 1e270 { 7.888609052210118e-31 } else { factor };
    // Infinite coordinates lie on the axes and the diagonals.
    let infinite = long == f64::INFINITY;
    let corner = |size: f64| if size == f64::INFINITY { 1.0 } else { 0.0 };
    let (tall_corner, wide_corner) = (corner(tall), corner(wide));
    let (tall, wide) = (tall * factor, wide * factor);
    let tall = if infinite { tall_corner } else { tall };
    let wide = if infinite { wide_corner } else { wide };
    let angle = angle((tall.copysign(y), 0.0), (wide.copysign(x), 0.0));
    if x.is_nan() | y.is_nan() { f64::NAN } else { angle }
}

/// `sqrt(1 - x^2)` in two parts.
#[inline(always)]
fn complement(x: f64) -> (f64, f64) {
    let (square, error) = two_prod(x, x);
    let (high, low) = fast_two_sum(1.0, -square);
    square_root((high, low - error))
}

/// Arc sine, within 2 ulp; NaN outside [-1, 1].
#[inline(always)]
pub fn asin(x: f64) -> f64 {
    let angle = angle((x, 0.0), complement(x));
    if x.abs() <= 1.0 { angle } else { f64::NAN }
}

/// Arc cosine, within 2 ulp; NaN outside [-1, 1].
#[inline(always)]
pub fn acos(x: f64) -> f64 {
    let angle = angle(complement(x), (x, 0.0));
    if x.abs() <= 1.0 { angle } else { f64::NAN }
}
