//! Polynomials, in an order of evaluation that keeps two additions in flight.

use crate::Lanes;

/// `sum c[i] x^i`, Horner's rule in `x^2` over pairs of coefficients.
#[inline(always)]
pub fn pairs<S: Lanes, const N: usize>(x: S, coefficients: [[f64; 2]; N]) -> S {
    let square = x * x;
    let [even, odd] = coefficients[N - 1];
    let mut sum = x * odd + even;
    let mut i = N - 1;
    while i > 0 {
        i -= 1;
        let [even, odd] = coefficients[i];
        sum = (x * odd + even) + square * sum;
    }
    sum
}
