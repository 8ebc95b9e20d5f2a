//! Hyperbolic functions: half of `e^x` plus or minus `e^-x`, both in two parts; a polynomial near zero.

use super::exact::{fast_two_sum, quotient, two_sum};
use super::exp;
use super::polynomial::pairs;

/// `(sinh x / x - 1) / x^2` in `x^2`, error below `2^-58` of the hyperbolic sine on `|x| <= 1/2`.
const SINH: [[f64; 2]; 3] = [
    [0.16666666666666666, 0.008333333333333456],
    [0.0001984126984095235, 2.7557319600354687e-06],
    [2.505188285143091e-08, 1.6125502642635846e-10],
];

/// Hyperbolic sine and cosine of `x >= 0`, each in two parts.
#[inline(always)]
fn sinh_cosh(x: f64) -> ((f64, f64), (f64, f64)) {
    let growing = exp::parts(x, 0.0);
    let n = growing.exponent;
    let half = n.wrapping_sub(1);
    let (high, low) = (exp::scale(growing.high, half), exp::scale(growing.low, half));
    let reciprocal = quotient((0.5, 0.0), (growing.high, growing.low));
    let down = n.wrapping_neg();
    let (tiny, tiny_low) = (exp::scale(reciprocal.0, down), exp::scale(reciprocal.1, down));
    let pair = |sign: f64| {
        let (sum, error) = two_sum(high, sign * tiny);
        // Here e^x may have overflowed, and e^-x is long negligible.
        let error = if x < 40.0 { error + (low + sign * tiny_low) } else { low };
        (sum, error)
    };
    let square = x * x;
    let small = (x, x * square * pairs(square, SINH));
    (if x < 0.5 { small } else { pair(-1.0) }, pair(1.0))
}

/// Hyperbolic sine, within 2 ulp.
#[inline(always)]
pub fn sinh(x: f64) -> f64 {
    let (sinh, _) = sinh_cosh(x.abs());
    (sinh.0 + sinh.1).copysign(x)
}

/// Hyperbolic cosine, within 2 ulp.
#[inline(always)]
pub fn cosh(x: f64) -> f64 {
    let (_, cosh) = sinh_cosh(x.abs());
    cosh.0 + cosh.1
}

/// Hyperbolic tangent, within 2 ulp.
#[inline(always)]
pub fn tanh(x: f64) -> f64 {
    let size = x.abs();
    let (sinh, cosh) = sinh_cosh(if size > 22.0 { 22.0 } else { size });
    let sinh = fast_two_sum(sinh.0, sinh.1);
    let cosh = fast_two_sum(cosh.0, cosh.1);
    let (high, low) = quotient(sinh, cosh);
    (high + low).copysign(x)
}
