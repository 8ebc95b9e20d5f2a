//! Sums and products with their rounding error (Dekker, Numer. Math. 18 (1971) 224; Knuth, TAOCP 2, 4.2.2).

use crate::Lanes;
use crate::register::Word;

/// `1.5 * 2^52`: added to a number below `2^51`, it rounds it to an integer, kept in the low bits.
pub const MAGIC: f64 = 6755399441055744.0;

/// Rounds to an integer: as a number, and as two's complement bits.
#[inline(always)]
pub fn round<S: Lanes>(x: S) -> (S, Word<S::Register>) {
    let shifted = x + MAGIC;
    (shifted - MAGIC, shifted.bits() - MAGIC.to_bits())
}

/// `2^n` for `n` in `-1022..=1023` (two's complement).
#[inline(always)]
pub fn power_of_two<S: Lanes>(n: Word<S::Register>) -> S {
    S::of_bits((n + 1023).left(52))
}

/// `a + b` and its rounding error, for `|a| >= |b|` or `a = 0`.
#[inline(always)]
pub fn fast_two_sum<S: Lanes>(a: S, b: S) -> (S, S) {
    let sum = a + b;
    (sum, (a - sum) + b)
}

/// `a + b` and its rounding error.
#[inline(always)]
pub fn two_sum<S: Lanes>(a: S, b: S) -> (S, S) {
    let sum = a + b;
    let b_part = sum - a;
    (sum, (a - (sum - b_part)) + (b - b_part))
}

/// Two halves of 26 bits each; overflows above `2^996`.
#[inline(always)]
fn split<S: Lanes>(x: S) -> (S, S) {
    let scaled = x * 134217729.0;
    let high = scaled - (scaled - x);
    (high, x - high)
}

/// `a * b` and its rounding error: exact while the factors are below `2^996`, the product finite and
/// the error no less than the smallest subnormal number.
#[inline(always)]
pub fn two_prod<S: Lanes>(a: S, b: S) -> (S, S) {
    let product = a * b;
    let (a1, a0) = split(a);
    let (b1, b0) = split(b);
    (product, ((a1 * b1 - product) + a1 * b0 + a0 * b1) + a0 * b0)
}

/// The quotient of two numbers in two parts, in two parts; the denominator above `2^-1022`.
#[inline(always)]
pub fn quotient<S: Lanes>(numerator: (S, S), denominator: (S, S)) -> (S, S) {
    let ratio = numerator.0 / denominator.0;
    // For the small rest a product does, and need not wait for the first division.
    let reciprocal = S::from(1.0) / denominator.0;
    let (product, error) = two_prod(ratio, denominator.0);
    let remainder = ((numerator.0 - product) - error) + (numerator.1 - ratio * denominator.1);
    (ratio, remainder * reciprocal)
}

/// The square root of a number in two parts, in two parts.
#[inline(always)]
pub fn square_root<S: Lanes>(x: (S, S)) -> (S, S) {
    let root = x.0.sqrt();
    let (square, error) = two_prod(root, root);
    let remainder = ((x.0 - square) - error) + x.1;
    (root, S::select(root.is(0.0), S::from(0.0), remainder / (root + root)))
}

/// One of two numbers in two parts.
#[inline(always)]
pub fn select_pair<S: Lanes>(mask: S::Mask, a: (S, S), b: (S, S)) -> (S, S) {
    (S::select(mask, a.0, b.0), S::select(mask, a.1, b.1))
}
