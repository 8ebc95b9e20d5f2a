//! What the tests of this crate share.
#![allow(dead_code)]

pub mod references;

use precess_scalar::DoubleDouble;

/// The generator splitmix64 (Steele, Lea and Flood, OOPSLA 2014).
pub struct Random(pub u64);

impl Random {
    /// Sixty-four random bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }
    /// Uniform in [0, 1).
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / 9007199254740992.0
    }
    /// Uniform in [low, high).
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }
    /// A finite double, all exponents alike.
    pub fn finite(&mut self) -> f64 {
        loop {
            let x = f64::from_bits(self.bits());
            if x.is_finite() {
                return x;
            }
        }
    }
}

/// The distance of neighbouring doubles at this size.
pub fn ulp(x: f64) -> f64 {
    let exponent = (x.to_bits() >> 52) & 0x7ff;
    if exponent > 52 {
        f64::from_bits((exponent - 52) << 52)
    } else {
        f64::from_bits(1 << (exponent.max(1) - 1))
    }
}

/// Distance of `computed` from `exact`, in units of the last place of the exact value.
pub fn error(computed: f64, exact: DoubleDouble) -> f64 {
    if computed == exact.hi() && exact.lo() == 0.0 || computed.is_nan() && exact.hi().is_nan() {
        return 0.0;
    }
    // Just below a power of two the unit is half as large.
    let below = exact.hi().to_bits() & ((1 << 52) - 1) == 0
        && (exact.lo() < 0.0) == (exact.hi() > 0.0)
        && exact.lo() != 0.0;
    let unit = ulp(exact.hi()) * if below && ulp(exact.hi()) > 1e-323 { 0.5 } else { 1.0 };
    (((computed - exact.hi()) - exact.lo()) / unit).abs()
}

/// How many doubles lie from one to the other; two NaN are the same.
pub fn steps(a: f64, b: f64) -> u64 {
    let ordinal = |x: f64| {
        let bits = x.to_bits().cast_signed();
        if bits < 0 { i64::MIN - bits } else { bits }
    };
    if a.is_nan() && b.is_nan() { 0 } else { ordinal(a).abs_diff(ordinal(b)) }
}

/// Arguments at which functions go wrong.
pub const SPECIAL: [f64; 26] = [
    0.0,
    -0.0,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
    1.0,
    -1.0,
    2.0,
    -2.0,
    3.0,
    -3.0,
    0.5,
    -0.5,
    2.5,
    f64::MIN_POSITIVE,
    5e-324,
    -5e-324,
    f64::MAX,
    f64::MIN,
    1e-310,
    9007199254740991.0,
    9007199254740993.0,
    1e22,
    710.0,
    -745.0,
    0.9999999999999999,
];
