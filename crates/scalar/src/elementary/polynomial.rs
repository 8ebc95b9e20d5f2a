//! Polynomials, in an order of evaluation that keeps two additions in flight.

/// `sum c[i] x^i`, Horner's rule in `x^2` over pairs of coefficients.
#[inline(always)]
pub fn pairs<const N: usize>(x: f64, coefficients: [[f64; 2]; N]) -> f64 {
    let square = x * x;
    let [even, odd] = coefficients[N - 1];
    let mut sum = even + odd * x;
    let mut i = N - 1;
    while i > 0 {
        i -= 1;
        let [even, odd] = coefficients[i];
        sum = (even + odd * x) + square * sum;
    }
    sum
}
