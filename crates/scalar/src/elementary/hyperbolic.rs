//! Hyperbolic functions: half of `e^x` plus or minus `e^-x`, both in two parts; a polynomial near zero.

use super::exact::{fast_two_sum, quotient, select_pair, two_sum};
use super::exp;
use super::polynomial::pairs;
use crate::Lanes;
use crate::register::Word;

/// `(sinh x / x - 1) / x^2` in `x^2`, error below `2^-58` of the hyperbolic sine on `|x| <= 1/2`.
const SINH: [[f64; 2]; 3] = [
    [0.16666666666666666, 0.008333333333333456],
    [0.0001984126984095235, 2.7557319600354687e-06],
    [2.505188285143091e-08, 1.6125502642635846e-10],
];

/// Half of `e^x` plus or minus half of `e^-x`. Where x is not near, `e^x` may have overflowed, and `e^-x` is long
/// negligible.
#[inline(always)]
fn sum<S: Lanes>(near: S::Mask, large: (S, S), tiny: (S, S)) -> (S, S) {
    let (sum, error) = two_sum(large.0, tiny.0);
    (sum, S::select(near, error + (large.1 + tiny.1), large.1))
}

/// Hyperbolic sine and cosine of `x >= 0`, each in two parts.
#[inline(always)]
fn sinh_cosh<S: Lanes>(x: S) -> ((S, S), (S, S)) {
    let growing = exp::parts(x, S::from(0.0));
    let n = growing.exponent;
    let half = n - 1;
    let (high, low) = (exp::scale(growing.high, half), exp::scale(growing.low, half));
    let reciprocal = quotient((S::from(0.5), S::from(0.0)), (growing.high, growing.low));
    let down = Word::splat(0) - n;
    let (tiny, tiny_low) = (exp::scale(reciprocal.0, down), exp::scale(reciprocal.1, down));
    let square = x * x;
    let small = (x, x * square * pairs(square, SINH));
    let near = x.below(40.0);
    let sinh = sum(near, (high, low), (-tiny, -tiny_low));
    let cosh = sum(near, (high, low), (tiny, tiny_low));
    (select_pair(x.below(0.5), small, sinh), cosh)
}

/// Hyperbolic sine, within 2 ulp.
#[inline(always)]
pub fn sinh<S: Lanes>(x: S) -> S {
    let (sinh, _) = sinh_cosh(x.abs());
    (sinh.0 + sinh.1).with_sign(x)
}

/// Hyperbolic cosine, within 2 ulp.
#[inline(always)]
pub fn cosh<S: Lanes>(x: S) -> S {
    let (_, cosh) = sinh_cosh(x.abs());
    cosh.0 + cosh.1
}

/// Hyperbolic tangent, within 2 ulp.
#[inline(always)]
pub fn tanh<S: Lanes>(x: S) -> S {
    let size = x.abs();
    let (sinh, cosh) = sinh_cosh(S::select(size.above(22.0), S::from(22.0), size));
    let sinh = fast_two_sum(sinh.0, sinh.1);
    let cosh = fast_two_sum(cosh.0, cosh.1);
    let (high, low) = quotient(sinh, cosh);
    (high + low).with_sign(x)
}
