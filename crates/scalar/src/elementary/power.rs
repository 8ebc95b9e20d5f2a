//! Powers: repeated squaring for integers, `e^(y ln x)` with a logarithm in two parts for reals.

use super::exact::{fast_two_sum, two_prod};
use super::{exp, ln};
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
pub fn powi(x: f64, n: i32) -> f64 {
    repeated_squaring(x, n)
}

/// Whether `y` is an integer, and whether it is odd.
#[inline(always)]
fn parity(y: f64) -> (bool, bool) {
    let size = y.abs();
    let shifted = size + 4503599627370496.0;
    let fits = size < 4503599627370496.0;
    let integer = !fits | (shifted - 4503599627370496.0 == size);
    let bits = if fits { shifted.to_bits() } else { size.to_bits() };
    (integer, integer & (bits & 1 == 1) & (size < 9007199254740992.0))
}

/// Real power, within 2 ulp.
#[inline(always)]
pub fn powf(x: f64, y: f64) -> f64 {
    let size = x.abs();
    let (log, log_low) = ln::parts(size);
    // Beyond this exponent every power but that of one is zero or infinite.
    let bound = 18446744073709551616.0;
    let exponent = if y > bound { bound } else { y };
    let exponent = if exponent < -bound { -bound } else { exponent };
    let (product, error) = two_prod(exponent, log);
    let (high, low) = fast_two_sum(product, error + exponent * log_low);
    let parts = exp::parts(high, low);
    let power = exp::scale(parts.high, parts.exponent);

    let grows = (size > 1.0) == (y > 0.0);
    let limit = if grows { f64::INFINITY } else { 0.0 };
    let at_limit = (size == 0.0) | (size == f64::INFINITY) | (y.abs() == f64::INFINITY);
    let power = if at_limit { limit } else { power };
    let (integer, odd) = parity(y);
    let negative = x.is_sign_negative();
    let power = if negative & odd { -power } else { power };
    // A broken power of a negative number: none, except at zero and at infinity.
    let broken = (x < 0.0) & !integer & (size < f64::INFINITY);
    let undefined = broken | x.is_nan() | y.is_nan();
    let power = if undefined { f64::NAN } else { power };
    let one = (x == 1.0) | (y == 0.0) | ((size == 1.0) & (y.abs() == f64::INFINITY));
    if one { 1.0 } else { power }
}
