//! Reduction of huge angles with as many bits of 2/pi as the exponent asks for (Payne and Hanek 1983).

use super::exact::{fast_two_sum, two_prod};
use super::trig::Reduced;
use crate::Lanes;

/// 2/pi, after a leading word of zeros.
const TWO_OVER_PI: [u64; 23] = [
    0x0000000000000000,
    0xa2f9836e4e441529,
    0xfc2757d1f534ddc0,
    0xdb6295993c439041,
    0xfe5163abdebbc561,
    0xb7246e3a424dd2e0,
    0x06492eea09d1921c,
    0xfe1deb1cb129a73e,
    0xe88235f52ebb4484,
    0xe99c7026b45f7e41,
    0x3991d639835339f4,
    0x9c845f8bbdf9283b,
    0x1ff897ffde05980f,
    0xef2f118b5a0a6d1f,
    0x6d367ecf27cb09b7,
    0x4f463f669e5fea2d,
    0x7527bac7ebe5f17b,
    0x3d0739f78a5292ea,
    0x6bfb5fb11f8d5d08,
    0x56033046fc7b6bab,
    0xf0cfbc209af4361d,
    0xa9e391615ee61b08,
    0x6599855f14a06840,
];

/// `x * 2/pi` for a finite `|x| >= 2^-8`: the nearest integer modulo four, and the rest (at most a half)
/// in two parts, to `2^-104` of itself for every double.
#[inline(never)]
pub fn turns(x: f64) -> (u64, (f64, f64)) {
    let bits = x.to_bits();
    let mantissa = (bits & ((1 << 52) - 1)) | (1 << 52);
    // x = mantissa 2^exponent; bits of 2/pi of weight 2^(2 - exponent) and more give whole turns.
    let exponent = ((bits >> 52) & 0x7ff).wrapping_sub(1075);
    let start = exponent.wrapping_add(62) as usize;
    let (word, shift) = (start / 64, start % 64);
    // The product modulo 2^256, most significant word first: the first two bits are the quadrant.
    let mut product = [0_u64; 4];
    let mut carry = 0_u64;
    for i in (0..4).rev() {
        let pair = (u128::from(TWO_OVER_PI[word + i]) << 64) | u128::from(TWO_OVER_PI[word + i + 1]);
        let window = ((pair << shift) >> 64) as u64;
        let sum = u128::from(window) * u128::from(mantissa) + u128::from(carry);
        product[i] = sum as u64;
        carry = (sum >> 64) as u64;
    }
    let mut quadrant = product[0] >> 62;
    let mut fraction = [0_u64; 4];
    for i in 0..4 {
        fraction[i] = (product[i] << 2) | (product.get(i + 1).unwrap_or(&0) >> 62);
    }
    let above_half = fraction[0] >> 63 == 1;
    if above_half {
        quadrant += 1;
        fraction = fraction.map(|word| !word);
    }
    let sign = if above_half == (x < 0.0) { 1.0 } else { -1.0 };
    let rest = leading(fraction);
    (if x < 0.0 { quadrant.wrapping_neg() } else { quadrant }, (sign * rest.0, sign * rest.1))
}

/// The fraction `words / 2^256` in two parts.
fn leading(words: [u64; 4]) -> (f64, f64) {
    let mut words = words;
    let mut scale = 1.0;
    // Fewer than 64 leading zeros, whatever the double.
    if words[0] == 0 {
        words = [words[1], words[2], words[3], 0];
        scale = 1.0 / 18446744073709551616.0;
    }
    let zeros = words[0].leading_zeros();
    let top = (u128::from(words[0]) << 64) | u128::from(words[1]);
    let top = if zeros == 0 { top } else { (top << zeros) | u128::from(words[2] >> (64 - zeros)) };
    // Pieces of 53, 53 and 22 bits are doubles without rounding.
    let piece = |shift: u32, bits: u32| ((top >> shift) & ((1 << bits) - 1)) as f64;
    let unit = scale / (1_u128 << zeros) as f64 / 9007199254740992.0;
    let first = piece(75, 53) * unit;
    let second = piece(22, 53) * unit / 9007199254740992.0;
    fast_two_sum(first, second)
}

/// Quadrant and rest of the huge angles among some; `far` tells which they are, a bit a lane. An infinite one keeps
/// the NaN that it has.
#[cold]
#[inline(never)]
pub fn patch<S: Lanes>(x: S, far: u32, mut reduced: Reduced<S>) -> Reduced<S> {
    let mut quadrants = S::of_bits(reduced.quadrant);
    for (lane, &x) in x.lanes().iter().enumerate() {
        if far >> lane & 1 == 1 && x.is_finite() {
            let (quadrant, rest, tail) = reduce(x);
            quadrants.lanes_mut()[lane] = f64::from_bits(quadrant);
            reduced.rest.lanes_mut()[lane] = rest;
            reduced.tail.lanes_mut()[lane] = tail;
        }
    }
    reduced.quadrant = quadrants.bits();
    reduced
}

/// Quadrant, rest and tail of a huge finite angle.
fn reduce(x: f64) -> (u64, f64, f64) {
    let (quadrant, (high, low)) = turns(x);
    let (product, error) = two_prod(high, std::f64::consts::FRAC_PI_2);
    let error = error + (high * 6.123233995736766e-17 + low * std::f64::consts::FRAC_PI_2);
    let (rest, tail) = fast_two_sum(product, error);
    (quadrant, rest, tail)
}
