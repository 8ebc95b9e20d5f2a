//! Cube root and hypotenuse.

use super::exact::{fast_two_sum, power_of_two, round, square_root, two_prod};
use super::polynomial::pairs;

/// `m^(1/3)` on [1/2, 4], relative error below `2^-9`.
const CBRT: [[f64; 2]; 3] = [
    [0.4979094771641229, 0.7129718414079559],
    [-0.2658941385368597, 0.06082650036863809],
    [-0.005484140014254771, 0.0],
];

/// Real cube root, within 1 ulp.
///
/// A polynomial gives 9 bits and Halley's iteration triples them; cut to 26 bits, so that its square is
/// exact, the root is then improved once more.
#[inline(always)]
pub fn cbrt(x: f64) -> f64 {
    let size = x.abs();
    let subnormal = size < f64::MIN_POSITIVE;
    let lifted = if subnormal { size * 18014398509481984.0 } else { size };
    let bits = lifted.to_bits();
    let biased = f64::from_bits((bits >> 52) | 0x4330000000000000) - 4503599627370496.0;
    let (_, third) = round(biased * 0.3333333333333333 - 341.0);
    let thrice = third.wrapping_add(third).wrapping_add(third);
    let m = f64::from_bits(bits.wrapping_sub(thrice << 52));

    let guess = pairs(m, CBRT);
    let cube = guess * guess * guess;
    let better = guess * ((cube + 2.0 * m) / (2.0 * cube + m));
    let short = f64::from_bits(better.to_bits() & !0x07ff_ffff);
    let ratio = m / (short * short);
    let root = short + short * ((ratio - short) / (short + short + ratio));

    let exponent = if subnormal { third.wrapping_sub(18) } else { third };
    let root = (root * power_of_two(exponent)).copysign(x);
    if (size > 0.0) & (size < f64::INFINITY) { root } else { x + x }
}

/// `sqrt(x^2 + y^2)` within 1 ulp, without overflow on the way.
#[inline(always)]
pub fn hypot(x: f64, y: f64) -> f64 {
    let (a, b) = (x.abs(), y.abs());
    let long = if a > b { a } else { b };
    let short = if a > b { b } else { a };
    let (down, up) = (power_of_two(600_u64.wrapping_neg()), power_of_two(600));
    let factor = if long > 1e150 { down } else { 1.0 };
    let factor = if long < 1e-120 { up } else { factor };
    let back = if long > 1e150 { up } else { 1.0 };
    let back = if long < 1e-120 { down } else { back };
    let (long, short) = (long * factor, short * factor);
    let (square, error) = two_prod(long, long);
    let (other, other_error) = two_prod(short, short);
    let (sum, sum_error) = fast_two_sum(square, other);
    let (root, correction) = square_root((sum, sum_error + (error + other_error)));
    let length = (root + correction) * back;
    let infinite = (a == f64::INFINITY) | (b == f64::INFINITY);
    let length = if a.is_nan() | b.is_nan() { f64::NAN } else { length };
    if infinite { f64::INFINITY } else { length }
}
