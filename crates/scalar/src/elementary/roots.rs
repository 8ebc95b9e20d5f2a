//! Cube root and hypotenuse.

use super::exact::{fast_two_sum, power_of_two, round, square_root, two_prod};
use super::polynomial::pairs;
use crate::Lanes;

/// `m^(1/3)` on [1/2, 4], relative error below `2^-9`.
const CBRT: [[f64; 2]; 3] = [
    [0.4979094771641229, 0.7129718414079559],
    [-0.2658941385368597, 0.06082650036863809],
    [-0.005484140014254771, 0.0],
];

/// `2^-600` and `2^600`: squares stay in range.
const DOWN: f64 = f64::from_bits((1023 - 600) << 52);
const UP: f64 = f64::from_bits((1023 + 600) << 52);

/// Real cube root, within 1 ulp.
///
/// A polynomial gives 9 bits and Halley's iteration triples them; cut to 26 bits, so that its square is
/// exact, the root is then improved once more.
#[inline(always)]
pub fn cbrt<S: Lanes>(x: S) -> S {
    let size = x.abs();
    let subnormal = size.below(f64::MIN_POSITIVE);
    let lifted = S::select(subnormal, size * 18014398509481984.0, size);
    let bits = lifted.bits();
    let biased = S::of_bits(bits.right(52) | 0x4330000000000000) - 4503599627370496.0;
    let (_, third) = round(biased * 0.3333333333333333 - 341.0);
    let thrice = third + third + third;
    let m = S::of_bits(bits - thrice.left(52));

    let guess = pairs(m, CBRT);
    let cube = guess * guess * guess;
    let better = guess * ((cube + m * 2.0) / (cube * 2.0 + m));
    let short = S::of_bits(better.bits() & !0x07ff_ffff);
    let ratio = m / (short * short);
    let root = short + short * ((ratio - short) / (short + short + ratio));

    let exponent = S::select_bits(subnormal, third - 18, third);
    let root = (root * power_of_two::<S>(exponent)).with_sign(x);
    S::select(size.above(0.0) & size.below(f64::INFINITY), root, x + x)
}

/// `sqrt(x^2 + y^2)` within 1 ulp, without overflow on the way.
#[inline(always)]
pub fn hypot<S: Lanes>(x: S, y: S) -> S {
    let (a, b) = (x.abs(), y.abs());
    let wide = a.gt(b);
    let long = S::select(wide, a, b);
    let short = S::select(wide, b, a);
    let (down, up) = (S::from(DOWN), S::from(UP));
    let (large, small) = (long.above(1e150), long.below(1e-120));
    let factor = S::select(small, up, S::select(large, down, S::from(1.0)));
    let back = S::select(small, down, S::select(large, up, S::from(1.0)));
    let (long, short) = (long * factor, short * factor);
    let (square, error) = two_prod(long, long);
    let (other, other_error) = two_prod(short, short);
    let (sum, sum_error) = fast_two_sum(square, other);
    let (root, correction) = square_root((sum, sum_error + (error + other_error)));
    let length = (root + correction) * back;
    let length = S::select(a.is_nan() | b.is_nan(), S::from(f64::NAN), length);
    S::select(a.is(f64::INFINITY) | b.is(f64::INFINITY), S::from(f64::INFINITY), length)
}
