//! Which inputs an expression depends on: constants are folded, the rest carries a set of marks.
//!
//! Run an equation on it with the parameters as constants and it tells, in the time of one evaluation,
//! whether the velocity enters, whether time does, which coordinates are cyclic.

use crate::Scalar;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A known constant, or something that depends on the marked inputs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Dependence {
    /// The same number whatever the inputs are.
    Constant(f64),
    /// Depends on the inputs of these marks (one bit each).
    On(u64),
}

use Dependence::{Constant, On};

impl Dependence {
    /// The marks of the inputs that matter; none for a constant.
    pub fn marks(self) -> u64 {
        match self {
            Constant(_) => 0,
            On(marks) => marks,
        }
    }
    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        match self {
            Constant(x) => Constant(f(x)),
            on @ On(_) => on,
        }
    }
    fn join(self, o: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        match (self, o) {
            (Constant(a), Constant(b)) => Constant(f(a, b)),
            _ => On(self.marks() | o.marks()),
        }
    }
    fn is_zero(self) -> bool {
        self == Constant(0.0)
    }
}

impl From<f64> for Dependence {
    fn from(x: f64) -> Self {
        Constant(x)
    }
}
impl Neg for Dependence {
    type Output = Self;
    fn neg(self) -> Self {
        self.map(|x| -x)
    }
}
impl Add for Dependence {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        self.join(o, |a, b| a + b)
    }
}
impl Sub for Dependence {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        self.join(o, |a, b| a - b)
    }
}
impl Mul for Dependence {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        if self.is_zero() || o.is_zero() { Constant(0.0) } else { self.join(o, |a, b| a * b) }
    }
}
impl Div for Dependence {
    type Output = Self;
    fn div(self, o: Self) -> Self {
        if self.is_zero() && !o.is_zero() { Constant(0.0) } else { self.join(o, |a, b| a / b) }
    }
}
macro_rules! with_literal {
    ($($operation:ident $method:ident),*) => {$(
        impl $operation<f64> for Dependence {
            type Output = Self;
            fn $method(self, o: f64) -> Self {
                $operation::$method(self, Constant(o))
            }
        }
    )*};
}
with_literal!(Add add, Sub sub, Mul mul, Div div);

impl Scalar for Dependence {
    /// A truth value as a number: 1, 0, or dependent.
    type Mask = Truth;
    type Abreast = Self;

    fn lt(self, o: Self) -> Truth {
        Truth(self.join(o, |a, b| f64::from(a < b)))
    }
    fn le(self, o: Self) -> Truth {
        Truth(self.join(o, |a, b| f64::from(a <= b)))
    }
    fn select(mask: Truth, a: Self, b: Self) -> Self {
        match mask.0 {
            Constant(truth) => {
                if truth == 0.0 {
                    b
                } else {
                    a
                }
            }
            On(marks) => On(marks | a.marks() | b.marks()),
        }
    }
    fn sqrt(self) -> Self {
        self.map(f64::sqrt)
    }
    fn sin_cos(self) -> (Self, Self) {
        (self.map(Scalar::sin), self.map(Scalar::cos))
    }
    fn tan(self) -> Self {
        self.map(Scalar::tan)
    }
    fn atan2(self, x: Self) -> Self {
        self.join(x, Scalar::atan2)
    }
    fn asin(self) -> Self {
        self.map(Scalar::asin)
    }
    fn acos(self) -> Self {
        self.map(Scalar::acos)
    }
    fn exp(self) -> Self {
        self.map(Scalar::exp)
    }
    fn ln(self) -> Self {
        self.map(Scalar::ln)
    }
    fn sinh(self) -> Self {
        self.map(Scalar::sinh)
    }
    fn cosh(self) -> Self {
        self.map(Scalar::cosh)
    }
    fn tanh(self) -> Self {
        self.map(Scalar::tanh)
    }
    fn powi(self, n: i32) -> Self {
        if n == 0 { Constant(1.0) } else { self.map(|x| Scalar::powi(x, n)) }
    }
    fn powf(self, exponent: Self) -> Self {
        self.join(exponent, Scalar::powf)
    }
    fn cbrt(self) -> Self {
        self.map(Scalar::cbrt)
    }
    fn hypot(self, o: Self) -> Self {
        self.join(o, Scalar::hypot)
    }
    fn abs(self) -> Self {
        self.map(f64::abs)
    }
}

/// The outcome of comparing two [`Dependence`]s.
#[derive(Clone, Copy, Debug)]
pub struct Truth(Dependence);

impl std::ops::BitAnd for Truth {
    type Output = Self;
    #[allow(clippy::suspicious_arithmetic_impl)] // Truth values are 0 and 1: their product is "and".
    fn bitand(self, o: Self) -> Self {
        Self(self.0 * o.0)
    }
}
impl std::ops::BitOr for Truth {
    type Output = Self;
    fn bitor(self, o: Self) -> Self {
        !(!self & !o)
    }
}
impl std::ops::Not for Truth {
    type Output = Self;
    fn not(self) -> Self {
        Self(Constant(1.0) - self.0)
    }
}
