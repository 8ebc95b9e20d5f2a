//! Powers: repeated squaring for integers, `e^(y ln x)` with a logarithm in two parts for reals.

use super::exact::{fast_two_sum, two_prod};
use super::{exp, ln};
use crate::Lanes;
use std::ops::{Div, Mul};

/// Integer power by repeated squaring from the lowest bit, the reciprocal at the end for a negative `n`.
#[inline(always)]
pub fn repeated_squaring<S>(x: S, n: i32) -> S
where
    S: Copy + From<f64> + Mul<Output = S> + Div<Output = S>,
{
    let mut left = n.unsigned_abs();
    let mut square = x;
    let mut power = S::from(1.0);
    while left != 0 {
        if left & 1 == 1 {
            power = power * square;
        }
        left >>= 1;
        if left != 0 {
            square = square * square;
        }
    }
    if n < 0 { S::from(1.0) / power } else { power }
}

/// Integer power by repeated squaring; relative error at most `|n| 2^-53` while nothing under- or
/// overflows. For a negative `n` it is the reciprocal of the positive power, and infinite (or zero)
/// where that one is zero (or infinite).
#[inline(always)]
pub fn powi<S: Lanes>(x: S, n: i32) -> S {
    repeated_squaring(x, n)
}

/// Whether `y` is an integer, and whether it is odd.
#[inline(always)]
fn parity<S: Lanes>(y: S) -> (S::Mask, S::Mask) {
    let size = y.abs();
    let shifted = size + 4503599627370496.0;
    let fits = size.below(4503599627370496.0);
    let integer = !fits | (shifted - 4503599627370496.0).equals(size);
    let bits = S::select_bits(fits, shifted.bits(), size.bits());
    (integer, integer & S::odd(bits) & size.below(9007199254740992.0))
}

/// Real power, within 2 ulp.
#[inline(always)]
pub fn powf<S: Lanes>(x: S, y: S) -> S {
    let size = x.abs();
    let (log, log_low) = ln::parts(size);
    // Beyond this exponent every power but that of one is zero or infinite.
    let bound = 18446744073709551616.0;
    let exponent = S::select(y.above(bound), S::from(bound), y);
    let exponent = S::select(exponent.below(-bound), S::from(-bound), exponent);
    let (product, error) = two_prod(exponent, log);
    let (high, low) = fast_two_sum(product, error + exponent * log_low);
    let parts = exp::parts(high, low);
    let power = exp::scale(parts.high, parts.exponent);

    let (large, rising) = (size.above(1.0), y.above(0.0));
    let grows = (large & rising) | !(large | rising);
    let limit = S::select(grows, S::from(f64::INFINITY), S::from(0.0));
    let endless = y.abs().is(f64::INFINITY);
    let at_limit = size.is(0.0) | size.is(f64::INFINITY) | endless;
    let power = S::select(at_limit, limit, power);
    let (integer, odd) = parity(y);
    let power = S::select(x.is_negative() & odd, -power, power);
    // A broken power of a negative number: none, except at zero and at infinity.
    let broken = x.below(0.0) & !integer & size.below(f64::INFINITY);
    let undefined = broken | x.is_nan() | y.is_nan();
    let power = S::select(undefined, S::from(f64::NAN), power);
    let one = x.is(1.0) | y.is(0.0) | (size.is(1.0) & endless);
    S::select(one, S::from(1.0), power)
}
