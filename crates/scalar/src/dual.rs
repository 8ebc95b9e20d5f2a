//! Dual numbers: a value and its derivative in one direction, exact to rounding.
//!
//! `x + x' e` with `e^2 = 0` (Clifford 1873). Nest them (`Dual<Dual<f64>>`) for second derivatives.

use crate::Scalar;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A value with its derivative along one direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dual<S> {
    /// The value.
    pub value: S,
    /// Its derivative.
    pub slope: S,
}

impl<S: Scalar> Dual<S> {
    /// A value that moves with the given slope.
    pub fn new(value: S, slope: S) -> Self {
        Self { value, slope }
    }
    /// A value that does not move.
    pub fn constant(value: S) -> Self {
        Self::new(value, S::from(0.0))
    }
    /// The chain rule: `f(x)` with `f'(x)` known.
    fn chain(self, value: S, derivative: S) -> Self {
        Self::new(value, derivative * self.slope)
    }
}

impl<S: Scalar> From<f64> for Dual<S> {
    fn from(x: f64) -> Self {
        Self::constant(S::from(x))
    }
}
impl<S: Scalar> Neg for Dual<S> {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.value, -self.slope)
    }
}
impl<S: Scalar> Add for Dual<S> {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self::new(self.value + o.value, self.slope + o.slope)
    }
}
impl<S: Scalar> Sub for Dual<S> {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        Self::new(self.value - o.value, self.slope - o.slope)
    }
}
impl<S: Scalar> Mul for Dual<S> {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        Self::new(self.value * o.value, self.slope * o.value + self.value * o.slope)
    }
}
impl<S: Scalar> Div for Dual<S> {
    type Output = Self;
    fn div(self, o: Self) -> Self {
        let value = self.value / o.value;
        Self::new(value, (self.slope - value * o.slope) / o.value)
    }
}
impl<S: Scalar> Add<f64> for Dual<S> {
    type Output = Self;
    fn add(self, o: f64) -> Self {
        Self::new(self.value + o, self.slope)
    }
}
impl<S: Scalar> Sub<f64> for Dual<S> {
    type Output = Self;
    fn sub(self, o: f64) -> Self {
        Self::new(self.value - o, self.slope)
    }
}
impl<S: Scalar> Mul<f64> for Dual<S> {
    type Output = Self;
    fn mul(self, o: f64) -> Self {
        Self::new(self.value * o, self.slope * o)
    }
}
impl<S: Scalar> Div<f64> for Dual<S> {
    type Output = Self;
    fn div(self, o: f64) -> Self {
        Self::new(self.value / o, self.slope / o)
    }
}

impl<S: Scalar> Scalar for Dual<S> {
    type Mask = S::Mask;
    type Abreast = Self;

    fn lt(self, o: Self) -> S::Mask {
        self.value.lt(o.value)
    }
    fn le(self, o: Self) -> S::Mask {
        self.value.le(o.value)
    }
    fn select(mask: S::Mask, a: Self, b: Self) -> Self {
        Self::new(S::select(mask, a.value, b.value), S::select(mask, a.slope, b.slope))
    }
    fn all(mask: S::Mask) -> bool {
        S::all(mask)
    }
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        Self::new(root, self.slope / (root * 2.0))
    }
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        (self.chain(sin, cos), self.chain(cos, -sin))
    }
    fn tan(self) -> Self {
        let tan = self.value.tan();
        self.chain(tan, tan * tan + 1.0)
    }
    fn atan2(self, x: Self) -> Self {
        let square = x.value * x.value + self.value * self.value;
        let slope = (self.slope * x.value - self.value * x.slope) / square;
        Self::new(self.value.atan2(x.value), slope)
    }
    fn asin(self) -> Self {
        let derivative = S::from(1.0) / (S::from(1.0) - self.value * self.value).sqrt();
        self.chain(self.value.asin(), derivative)
    }
    fn acos(self) -> Self {
        let derivative = S::from(-1.0) / (S::from(1.0) - self.value * self.value).sqrt();
        self.chain(self.value.acos(), derivative)
    }
    fn exp(self) -> Self {
        let exp = self.value.exp();
        self.chain(exp, exp)
    }
    fn ln(self) -> Self {
        Self::new(self.value.ln(), self.slope / self.value)
    }
    fn sinh(self) -> Self {
        self.chain(self.value.sinh(), self.value.cosh())
    }
    fn cosh(self) -> Self {
        self.chain(self.value.cosh(), self.value.sinh())
    }
    fn tanh(self) -> Self {
        let tanh = self.value.tanh();
        self.chain(tanh, S::from(1.0) - tanh * tanh)
    }
    fn powi(self, n: i32) -> Self {
        if n == 0 {
            return Self::from(1.0);
        }
        self.chain(self.value.powi(n), self.value.powi(n - 1) * f64::from(n))
    }
    fn powf(self, exponent: Self) -> Self {
        let power = self.value.powf(exponent.value);
        let by_base = exponent.value * self.value.powf(exponent.value - 1.0) * self.slope;
        // ln(0) times a slope of zero is NaN; a constant exponent must not meet it.
        let still = exponent.slope.le(S::from(0.0)) & S::from(0.0).le(exponent.slope);
        let by_exponent = S::select(still, S::from(0.0), power * self.value.ln() * exponent.slope);
        Self::new(power, by_base + by_exponent)
    }
    fn cbrt(self) -> Self {
        let root = self.value.cbrt();
        Self::new(root, self.slope / (root * root * 3.0))
    }
    fn hypot(self, o: Self) -> Self {
        let length = self.value.hypot(o.value);
        Self::new(length, (self.value * self.slope + o.value * o.slope) / length)
    }
    fn abs(self) -> Self {
        // The slope at zero is taken as zero, which keeps |x| x differentiable there.
        Self::new(self.value.abs(), self.value.sign() * self.slope)
    }
}
