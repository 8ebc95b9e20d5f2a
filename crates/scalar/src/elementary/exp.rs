//! The exponential: `2^n e^r` with `|r| <= ln 2 / 2` (Cody and Waite 1980) and a polynomial.

use super::exact::{fast_two_sum, power_of_two, round};
use super::polynomial::pairs;
use crate::Lanes;
use crate::register::Word;

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
pub struct Scaled<S: Lanes> {
    /// The leading part, in [0.7, 1.42].
    pub high: S,
    /// What it leaves out.
    pub low: S,
    /// The power of two.
    pub exponent: Word<S::Register>,
}

/// `e^(x + tail)` for a small tail; arguments beyond the range of results are brought to its border.
#[inline(always)]
pub fn parts<S: Lanes>(x: S, tail: S) -> Scaled<S> {
    let inside = x.below(720.0) & x.above(-760.0);
    let x = S::select(x.above(720.0), S::from(720.0), x);
    let x = S::select(x.below(-760.0), S::from(-760.0), x);
    let tail = S::select(inside, tail, S::from(0.0));
    let (n, exponent) = round(x * std::f64::consts::LOG2_E);
    let (r, error) = fast_two_sum(x - n * LN2[0], tail - n * LN2[1]);
    let square = r * r;
    let rest = square * 0.5 + ((square * r) * pairs(r, EXP) + error * (r + 1.0));
    let (sum, error) = fast_two_sum(S::from(1.0), r);
    let (high, low) = fast_two_sum(sum, error + rest);
    Scaled { high, low, exponent }
}

/// `x 2^n` for `n` in -2000..2000, in two steps of which only the second may round.
#[inline(always)]
pub fn scale<S: Lanes>(x: S, n: Word<S::Register>) -> S {
    let half = (n + 2048).right(1) - 1024;
    x * power_of_two::<S>(half) * power_of_two::<S>(n - half)
}

/// Exponential, within 1 ulp, subnormal results included.
#[inline(always)]
pub fn exp<S: Lanes>(x: S) -> S {
    let parts = parts(x, S::from(0.0));
    scale(parts.high, parts.exponent)
}
