//! Twice the digits: an unevaluated sum of two `f64` (Dekker 1971; Hida, Li and Bailey, ARITH-15, 2001).
//!
//! Sums, products, quotients and square roots are right to `2^-102` of themselves while their size stays
//! between `2^-900` and `2^996`: below, the second half drowns in the subnormal numbers; above, the
//! splitting of a factor overflows and the result is NaN. A sum that vanishes is plus zero.

mod constants;
mod functions;

use crate::elementary::{two_prod, two_sum};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number of about 32 decimal digits: `hi + lo`, with `|lo|` at most half a unit in the last place of `hi`.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct DoubleDouble {
    hi: f64,
    lo: f64,
}

impl DoubleDouble {
    /// The sum of two doubles, exactly.
    #[inline(always)]
    pub fn new(hi: f64, lo: f64) -> Self {
        let (hi, lo) = two_sum(hi, lo);
        Self::checked(hi, lo)
    }
    /// The leading part: the nearest `f64`.
    #[inline(always)]
    pub fn hi(self) -> f64 {
        self.hi
    }
    /// What the leading part leaves out.
    #[inline(always)]
    pub fn lo(self) -> f64 {
        self.lo
    }
    /// The nearest `f64`.
    #[inline(always)]
    pub fn to_f64(self) -> f64 {
        self.hi
    }
    /// An infinite or missing number has no second half.
    #[inline(always)]
    fn checked(hi: f64, lo: f64) -> Self {
        Self { hi, lo: if hi.is_finite() { lo } else { 0.0 } }
    }
    /// `hi + lo` for `|hi| >= |lo|`.
    #[inline(always)]
    fn normal(hi: f64, lo: f64) -> Self {
        let sum = hi + lo;
        Self::checked(sum, (hi - sum) + lo)
    }
    /// The product with a power of two, or with a small integer if the low half can bear it.
    #[inline(always)]
    fn scaled(self, factor: f64) -> Self {
        Self::checked(self.hi * factor, self.lo * factor)
    }
    /// Square root, right to `2^-102`.
    #[inline(always)]
    fn root(self) -> Self {
        let root = self.hi.sqrt();
        if root == 0.0 || !root.is_finite() {
            return Self::from(root);
        }
        let (square, error) = two_prod(root, root);
        Self::normal(root, (((self.hi - square) - error) + self.lo) / (root + root))
    }
}

impl From<f64> for DoubleDouble {
    #[inline(always)]
    fn from(x: f64) -> Self {
        Self { hi: x, lo: 0.0 }
    }
}
impl Neg for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }
}
impl Add for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        let (high, error) = two_sum(self.hi, other.hi);
        if !high.is_finite() {
            return Self::from(high);
        }
        let (low, low_error) = two_sum(self.lo, other.lo);
        let first = Self::normal(high, error + low);
        Self::normal(first.hi, first.lo + low_error)
    }
}
impl Sub for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}
impl Mul for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        let (product, error) = two_prod(self.hi, other.hi);
        if product == 0.0 || !product.is_finite() {
            return Self::from(product);
        }
        Self::normal(product, error + (self.hi * other.lo + self.lo * other.hi))
    }
}
impl Div for DoubleDouble {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let first = self.hi / other.hi;
        if first == 0.0 || !first.is_finite() || !other.hi.is_finite() {
            return Self::from(first);
        }
        // Two more digits of the long division, each a double.
        let rest = self - other * first;
        let second = rest.hi / other.hi;
        let rest = rest - other * second;
        let third = rest.hi / other.hi;
        let sum = Self::normal(first, second);
        Self::normal(sum.hi, sum.lo + third)
    }
}
macro_rules! with_literal {
    ($($operation:ident $method:ident),*) => {$(
        impl $operation<f64> for DoubleDouble {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: f64) -> Self {
                $operation::$method(self, Self::from(other))
            }
        }
    )*};
}
with_literal!(Add add, Sub sub, Mul mul, Div div);
