//! The plain number.

use crate::{Scalar, elementary};

impl Scalar for f64 {
    type Mask = bool;

    fn all(mask: bool) -> bool {
        mask
    }

    #[inline(always)]
    fn lt(self, other: Self) -> bool {
        self < other
    }
    #[inline(always)]
    fn le(self, other: Self) -> bool {
        self <= other
    }
    #[inline(always)]
    fn select(mask: bool, a: Self, b: Self) -> Self {
        if mask { a } else { b }
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        elementary::sin_cos(self)
    }
    #[inline(always)]
    fn tan(self) -> Self {
        elementary::tan(self)
    }
    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        elementary::atan2(self, x)
    }
    #[inline(always)]
    fn asin(self) -> Self {
        elementary::asin(self)
    }
    #[inline(always)]
    fn acos(self) -> Self {
        elementary::acos(self)
    }
    #[inline(always)]
    fn exp(self) -> Self {
        elementary::exp(self)
    }
    #[inline(always)]
    fn ln(self) -> Self {
        elementary::ln(self)
    }
    #[inline(always)]
    fn sinh(self) -> Self {
        elementary::sinh(self)
    }
    #[inline(always)]
    fn cosh(self) -> Self {
        elementary::cosh(self)
    }
    #[inline(always)]
    fn tanh(self) -> Self {
        elementary::tanh(self)
    }
    #[inline(always)]
    fn powi(self, n: i32) -> Self {
        elementary::powi(self, n)
    }
    #[inline(always)]
    fn powf(self, exponent: Self) -> Self {
        elementary::powf(self, exponent)
    }
    #[inline(always)]
    fn cbrt(self) -> Self {
        elementary::cbrt(self)
    }
    #[inline(always)]
    fn hypot(self, other: Self) -> Self {
        elementary::hypot(self, other)
    }
    #[inline(always)]
    fn abs(self) -> Self {
        f64::abs(self)
    }
}
