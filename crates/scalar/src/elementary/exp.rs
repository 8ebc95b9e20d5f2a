//! The exponential: `2^n e^r` with `|r| <= ln 2 / 2` (Cody and Waite 1980) and a polynomial.

use super::exact::{fast_two_sum, power_of_two, round};
use super::polynomial::pairs;

/// ln 2 in two parts; the first has 41 bits, so that its product with an exponent is exact.
pub const LN2: [f64; 2] = [0.693147180559663, 2.8235290563031577e-13];

/// `(e^r - 1 - r - r^2/2) / r^3`, error below `2^-57.2` of the exponential.
const EXP: [[f64; 2]; 5] = [
    [0.16666666666666688, 0.0416666666666024],
    [0.008333333333313478, 0.0013888888927442158],
    [0.00019841269905983134, 2.4801507856246374e-05],
    [2.7557225065746016e-06, 2.7625520053812365e-07],
    [2.5115427559585376e-08, 0.0],
];

/// A number `(high + low) 2^exponent`, the exponent in two's complement.
#[derive(Clone, Copy)]
pub struct Scaled {
    /// The leading part, in [0.7, 1.42].
    pub high: f64,
    /// What it leaves out.
    pub low: f64,
    /// The power of two.
    pub exponent: u64,
}

/// `e^(x + tail)` for a small tail; arguments beyond the range of results are brought to its border.
#[inline(always)]
pub fn parts(x: f64, tail: f64) -> Scaled {
    let inside = (x < 720.0) & (x > -760.0);
    let x = if x > 720.0 { 720.0 } else { x };
    let x = if x < -760.0 { -760.0 } else { x };
    let tail = if inside { tail } else { 0.0 };
    let (n, exponent) = round(x * std::f64::consts::LOG2_E);
    let (r, error) = fast_two_sum(x - n * LN2[0], tail - n * LN2[1]);
    let square = r * r;
    let rest = square * 0.5 + ((square * r) * pairs(r, EXP) + error * (1.0 + r));
    let (sum, error) = fast_two_sum(1.0, r);
    let (high, low) = fast_two_sum(sum, error + rest);
    Scaled { high, low, exponent }
}

/// `x 2^n` for `n` in -2000..2000, in two steps of which only the second may round.
#[inline(always)]
pub fn scale(x: f64, n: u64) -> f64 {
    let half = (n.wrapping_add(2048) >> 1).wrapping_sub(1024);
    x * power_of_two(half) * power_of_two(n.wrapping_sub(half))
}

/// Exponential, within 1 ulp, subnormal results included.
#[inline(always)]
pub fn exp(x: f64) -> f64 {
    let parts = parts(x, 0.0);
    scale(parts.high, parts.exponent)
}
