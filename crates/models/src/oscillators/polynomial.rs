//! Polynomials given by their coefficients, the constant first.

use precess_scalar::Scalar;

/// The value at x, and the slope there (Horner).
#[inline(always)]
pub(super) fn value_and_slope<S: Scalar>(coefficients: &[S], x: S) -> (S, S) {
    let (mut value, mut slope) = (S::from(0.0), S::from(0.0));
    for &c in coefficients.iter().rev() {
        slope = slope * x + value;
        value = value * x + c;
    }
    (value, slope)
}
