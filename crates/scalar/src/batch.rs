//! A block of lanes: `W` numbers that go through the same operations.
//!
//! Every operation is a plain loop over the lanes, which the compiler turns into vector instructions of
//! whatever width it may use. A lane gives the bits that the plain `f64` gives.

use crate::{Scalar, elementary};
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// `W` numbers side by side.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(transparent)]
pub struct Batch<const W: usize>(pub [f64; W]);

/// One truth value per lane: all bits set, or none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LaneMask<const W: usize>([u64; W]);

impl<const W: usize> Batch<W> {
    /// The same number in every lane.
    #[inline(always)]
    pub fn splat(x: f64) -> Self {
        Self([x; W])
    }
    #[inline(always)]
    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        let mut lanes = self.0;
        for lane in &mut lanes {
            *lane = f(*lane);
        }
        Self(lanes)
    }
    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        let mut lanes = self.0;
        for (lane, other) in lanes.iter_mut().zip(other.0) {
            *lane = f(*lane, other);
        }
        Self(lanes)
    }
    #[inline(always)]
    fn compare(self, other: Self, f: impl Fn(f64, f64) -> bool) -> LaneMask<W> {
        let mut mask = [0; W];
        for ((lane, a), b) in mask.iter_mut().zip(self.0).zip(other.0) {
            *lane = if f(a, b) { u64::MAX } else { 0 };
        }
        LaneMask(mask)
    }
    /// Whether some lane needs the slow reduction.
    #[inline(always)]
    fn any_huge(self) -> bool {
        self.0.iter().fold(false, |any, x| any | elementary::is_huge(*x))
    }
}

impl<const W: usize> LaneMask<W> {
    /// Whether the mask holds in this lane.
    #[inline(always)]
    pub fn lane(self, i: usize) -> bool {
        self.0[i] != 0
    }
    /// Whether it holds in some lane.
    #[inline(always)]
    pub fn any(self) -> bool {
        self.0.iter().fold(0, |any, lane| any | lane) != 0
    }
    /// Whether it holds in every lane.
    #[inline(always)]
    pub fn all(self) -> bool {
        !(!self).any()
    }
    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(u64, u64) -> u64) -> Self {
        let mut lanes = self.0;
        for (lane, other) in lanes.iter_mut().zip(other.0) {
            *lane = f(*lane, other);
        }
        Self(lanes)
    }
}
impl<const W: usize> From<[bool; W]> for LaneMask<W> {
    #[inline(always)]
    fn from(lanes: [bool; W]) -> Self {
        Self(lanes.map(|lane| if lane { u64::MAX } else { 0 }))
    }
}
impl<const W: usize> BitAnd for LaneMask<W> {
    type Output = Self;
    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        self.zip(other, |a, b| a & b)
    }
}
impl<const W: usize> BitOr for LaneMask<W> {
    type Output = Self;
    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        self.zip(other, |a, b| a | b)
    }
}
impl<const W: usize> Not for LaneMask<W> {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        self.zip(self, |a, _| !a)
    }
}

impl<const W: usize> From<f64> for Batch<W> {
    #[inline(always)]
    fn from(x: f64) -> Self {
        Self::splat(x)
    }
}
impl<const W: usize> Neg for Batch<W> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(|x| -x)
    }
}
macro_rules! lanewise {
    ($($operation:ident $method:ident $symbol:tt),*) => {$(
        impl<const W: usize> $operation for Batch<W> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                self.zip(other, |a, b| a $symbol b)
            }
        }
        impl<const W: usize> $operation<f64> for Batch<W> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: f64) -> Self {
                self.map(|a| a $symbol other)
            }
        }
    )*};
}
lanewise!(Add add +, Sub sub -, Mul mul *, Div div /);

/// The same function on every lane. A closure of this size would stay a call, and the loop would not become
/// vector instructions.
macro_rules! each {
    ($x:expr, $function:path) => {{
        let mut lanes = $x.0;
        for lane in &mut lanes {
            *lane = $function(*lane);
        }
        Batch(lanes)
    }};
    ($x:expr, $y:expr, $function:path) => {{
        let mut lanes = $x.0;
        for (lane, other) in lanes.iter_mut().zip($y.0) {
            *lane = $function(*lane, other);
        }
        Batch(lanes)
    }};
}

impl<const W: usize> Scalar for Batch<W> {
    type Mask = LaneMask<W>;

    fn all(mask: LaneMask<W>) -> bool {
        mask.all()
    }

    #[inline(always)]
    fn lt(self, other: Self) -> LaneMask<W> {
        self.compare(other, |a, b| a < b)
    }
    #[inline(always)]
    fn le(self, other: Self) -> LaneMask<W> {
        self.compare(other, |a, b| a <= b)
    }
    #[inline(always)]
    fn select(mask: LaneMask<W>, a: Self, b: Self) -> Self {
        let mut lanes = b.0;
        for ((lane, a), mask) in lanes.iter_mut().zip(a.0).zip(mask.0) {
            *lane = f64::from_bits((a.to_bits() & mask) | (lane.to_bits() & !mask));
        }
        Self(lanes)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        each!(self, f64::sqrt)
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (mut sin, mut cos) = (self.0, self.0);
        for (sin, cos) in sin.iter_mut().zip(&mut cos) {
            (*sin, *cos) = elementary::ordinary_sin_cos(*sin);
        }
        if self.any_huge() {
            for ((sin, cos), x) in sin.iter_mut().zip(&mut cos).zip(self.0) {
                if elementary::is_huge(x) {
                    (*sin, *cos) = elementary::sin_cos(x);
                }
            }
        }
        (Self(sin), Self(cos))
    }
    #[inline(always)]
    fn tan(self) -> Self {
        let mut tan = each!(self, elementary::ordinary_tan);
        if self.any_huge() {
            for (tan, x) in tan.0.iter_mut().zip(self.0) {
                if elementary::is_huge(x) {
                    *tan = elementary::tan(x);
                }
            }
        }
        tan
    }
    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        each!(self, x, elementary::atan2)
    }
    #[inline(always)]
    fn asin(self) -> Self {
        each!(self, elementary::asin)
    }
    #[inline(always)]
    fn acos(self) -> Self {
        each!(self, elementary::acos)
    }
    #[inline(always)]
    fn exp(self) -> Self {
        each!(self, elementary::exp)
    }
    #[inline(always)]
    fn ln(self) -> Self {
        each!(self, elementary::ln)
    }
    #[inline(always)]
    fn sinh(self) -> Self {
        each!(self, elementary::sinh)
    }
    #[inline(always)]
    fn cosh(self) -> Self {
        each!(self, elementary::cosh)
    }
    #[inline(always)]
    fn tanh(self) -> Self {
        each!(self, elementary::tanh)
    }
    #[inline(always)]
    fn powi(self, n: i32) -> Self {
        elementary::repeated_squaring(self, n)
    }
    #[inline(always)]
    fn powf(self, exponent: Self) -> Self {
        each!(self, exponent, elementary::powf)
    }
    #[inline(always)]
    fn cbrt(self) -> Self {
        each!(self, elementary::cbrt)
    }
    #[inline(always)]
    fn hypot(self, other: Self) -> Self {
        each!(self, other, elementary::hypot)
    }
    #[inline(always)]
    fn abs(self) -> Self {
        each!(self, f64::abs)
    }
}
