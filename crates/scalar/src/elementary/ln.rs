//! The logarithm: `x = 2^n (1 + f)` with `1 + f` in `[sqrt 1/2, sqrt 2]`, then the series of the inverse
//! hyperbolic tangent in `s = f / (2 + f)`.

use super::exact::{fast_two_sum, quotient, two_prod, two_sum};
use super::exp::LN2;
use super::polynomial::pairs;
use crate::Lanes;

/// `(2 atanh s / s - 2) / s^2` in `s^2`, error below `2^-58` of the logarithm.
const LN: [[f64; 2]; 4] = [
    [0.6666666666666735, 0.3999999999940695],
    [0.2857142874424153, 0.22222198369533316],
    [0.1818357558077401, 0.15313746092079494],
    [0.14799155311996506, 0.0],
];
/// `((2 atanh s / s - 2) / s^2 - 2/3) / s^2` in `s^2`, error below `2^-64.7`.
const LN_TAIL: [[f64; 2]; 4] = [
    [0.4000000000000229, 0.2857142857008356],
    [0.222222225229079, 0.1818178409566734],
    [0.15386770273935588, 0.13256506872737678],
    [0.13199296312642436, 0.0],
];

const SQRT_HALF: u64 = 0x3fe6a09e667f3bcd;
const ONE: u64 = 0x3ff0000000000000;

/// `(n, f)` with `x = 2^n (1 + f)`, for a positive finite `x`.
#[inline(always)]
fn decompose<S: Lanes>(x: S) -> (S, S) {
    let subnormal = x.below(f64::MIN_POSITIVE);
    let x = S::select(subnormal, x * 18014398509481984.0, x);
    let bits = x.bits();
    let biased = (bits + (ONE - SQRT_HALF)).right(52);
    // An integer under the exponent of 2^52 is a number.
    let n = S::of_bits(biased | 0x4330000000000000)
        - S::select(subnormal, S::from(4503599627371573.0), S::from(4503599627371519.0));
    (n, S::of_bits(bits - biased.left(52) + ONE) - 1.0)
}

/// Natural logarithm, within 1 ulp.
#[inline(always)]
pub fn ln<S: Lanes>(x: S) -> S {
    let (n, f) = decompose(x);
    let s = f / (f + 2.0);
    let square = s * s;
    let half = f * 0.5 * f;
    let series = square * pairs(square, LN);
    let (sum, error) = fast_two_sum(n * LN2[0], f);
    let value = sum + (error + (n * LN2[1] - (half - s * (half + series))));
    let value = S::select(x.below(f64::INFINITY), value, x);
    let value = S::select(x.is(0.0), S::from(f64::NEG_INFINITY), value);
    S::select(x.below(0.0), S::from(f64::NAN), value)
}

/// Natural logarithm of a positive finite number in two parts, error below `2^-63` of it.
#[inline(always)]
pub fn parts<S: Lanes>(x: S) -> (S, S) {
    let (n, f) = decompose(x);
    let s = quotient((f, S::from(0.0)), two_sum(S::from(2.0), f));
    let s = fast_two_sum(s.0, s.1);
    let (square, square_error) = two_prod(s.0, s.0);
    let square_low = square_error + s.0 * 2.0 * s.1;
    // 2 s + s^3 (2/3 + s^2 tail), the 2/3 in two parts.
    let third = S::from(0.6666666666666666);
    let (inner, inner_error) = fast_two_sum(third, square * pairs(square, LN_TAIL));
    let inner_low = inner_error + 3.700743415417188e-17;
    let (cube, cube_error) = two_prod(s.0, square);
    let cube_low = cube_error + (s.0 * square_low + s.1 * square);
    let (term, term_error) = two_prod(cube, inner);
    let term_low = term_error + (cube * inner_low + cube_low * inner);
    let (series, series_error) = fast_two_sum(s.0 * 2.0, term);
    let (sum, sum_error) = fast_two_sum(n * LN2[0], series);
    fast_two_sum(sum, sum_error + (series_error + (term_low + (s.1 * 2.0 + n * LN2[1]))))
}
