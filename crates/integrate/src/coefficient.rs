//! A coefficient of a method with twice the digits of an `f64`, read from its source as it is printed there.
//!
//! To an `f64` it is the nearest one; to a [`DoubleDouble`](precess_scalar::DoubleDouble) it has about 31 digits, so
//! that a run in double-double converges as far as its arithmetic goes.

use precess_scalar::Scalar;

/// `hi + lo`, with `lo` below half a unit in the last place of `hi`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Coefficient {
    hi: f64,
    lo: f64,
}

impl Coefficient {
    pub fn value<S: Scalar>(self) -> S {
        S::from(self.hi) + self.lo
    }
}

/// The product of two doubles, exactly (Dekker 1971).
const fn two_prod(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    let (ah, bh) = (upper(a), upper(b));
    let (al, bl) = (a - ah, b - bh);
    (product, ((ah * bh - product) + ah * bl + al * bh) + al * bl)
}

/// The upper half of a double's digits.
const fn upper(a: f64) -> f64 {
    let c = 134_217_729.0 * a;
    c - (c - a)
}

const fn whole(n: u128) -> Coefficient {
    let hi = n as f64;
    Coefficient { hi, lo: n.wrapping_sub(hi as u128).cast_signed() as f64 }
}

const fn quotient(n: Coefficient, d: Coefficient) -> Coefficient {
    let first = n.hi / d.hi;
    let (product, error) = two_prod(first, d.hi);
    let rest = ((n.hi - product) - error) + n.lo - first * d.lo;
    let second = rest / d.hi;
    let hi = first + second;
    Coefficient { hi, lo: (first - hi) + second }
}

const fn signed(negative: bool, x: Coefficient) -> Coefficient {
    if negative { Coefficient { hi: -x.hi, lo: -x.lo } } else { x }
}

/// A fraction.
pub(crate) const fn ratio(n: i64, d: u64) -> Coefficient {
    signed(n < 0, quotient(whole(n.unsigned_abs() as u128), whole(d as u128)))
}

/// A decimal number of at most 38 digits: `-5.8012039600105847814672114227e-1`.
pub(crate) const fn decimal(text: &str) -> Coefficient {
    let bytes = text.as_bytes();
    let negative = bytes[0] == b'-';
    let (mut digits, mut power, mut i, mut after_point) = (0_u128, 0_i32, negative as usize, false);
    while i < bytes.len() && bytes[i] != b'e' {
        if bytes[i] == b'.' {
            after_point = true;
        } else {
            assert!(bytes[i].is_ascii_digit(), "a digit");
            digits = digits * 10 + (bytes[i] - b'0') as u128;
            power -= after_point as i32;
        }
        i += 1;
    }
    if i < bytes.len() {
        power += exponent(bytes, i + 1);
    }
    let x = if power < 0 {
        quotient(whole(digits), whole(10_u128.pow(power.unsigned_abs())))
    } else {
        whole(digits * 10_u128.pow(power as u32))
    };
    signed(negative, x)
}

const fn exponent(bytes: &[u8], from: usize) -> i32 {
    let negative = bytes[from] == b'-';
    let (mut i, mut n) = (from + negative as usize, 0);
    while i < bytes.len() {
        n = n * 10 + (bytes[i] - b'0') as i32;
        i += 1;
    }
    if negative { -n } else { n }
}

#[cfg(test)]
mod tests {
    use super::{decimal, ratio};
    use precess_scalar::{DoubleDouble, Scalar};

    #[test]
    fn the_nearest_double_is_the_one_that_the_compiler_reads() {
        for text in [
            "5.26001519587677318785587544488e-2",
            "-4.34898841810699588477366255144e1",
            "0.25",
            "-8.298e-3",
            "1",
        ] {
            assert_eq!(decimal(text).value::<f64>(), text.parse::<f64>().unwrap(), "{text}");
        }
        for (n, d) in
            [(1, 5), (-25_360, 2187), (-12_715_105_075, 11_282_082_432), (701_980_252_875, 199_316_789_632)]
        {
            assert_eq!(ratio(n, d).value::<f64>(), n as f64 / d as f64);
        }
    }

    #[test]
    fn thirty_digits_are_kept() {
        let third: DoubleDouble = ratio(1, 3).value();
        assert!((third * 3.0 - 1.0).abs().to_f64() < 1e-31);
        let same: DoubleDouble = decimal("0.333333333333333333333333333333333333").value();
        assert!((third - same).abs().to_f64() < 1e-31);
    }
}
