//! Units of measure: an equation run on dimensions shows the term that does not add up.

use crate::Scalar;
use std::cell::Cell;
use std::fmt;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Powers of kilogram, metre and second, in halves (a square root halves them). Angles are numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Dimension {
    halves: [i16; 3],
}

impl Dimension {
    /// A pure number.
    pub const NONE: Self = Self { halves: [0; 3] };

    /// `kg^a m^b s^c`.
    pub const fn new(kilogram: i16, metre: i16, second: i16) -> Self {
        Self { halves: [2 * kilogram, 2 * metre, 2 * second] }
    }
    /// The dimension of a product.
    #[must_use]
    pub fn times(self, o: Self) -> Self {
        Self { halves: std::array::from_fn(|i| self.halves[i].saturating_add(o.halves[i])) }
    }
    /// The dimension of a quotient.
    #[must_use]
    pub fn over(self, o: Self) -> Self {
        Self { halves: std::array::from_fn(|i| self.halves[i].saturating_sub(o.halves[i])) }
    }
    /// The dimension of an integer power.
    #[must_use]
    pub fn power(self, n: i32) -> Self {
        let n = i16::try_from(n).unwrap_or(i16::MAX);
        Self { halves: self.halves.map(|h| h.saturating_mul(n)) }
    }
}

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut first = true;
        for (name, halves) in ["kg", "m", "s"].iter().zip(self.halves) {
            if halves == 0 {
                continue;
            }
            if !first {
                f.write_str(" ")?;
            }
            first = false;
            match halves {
                2 => f.write_str(name)?,
                h if h % 2 == 0 => write!(f, "{name}^{}", h / 2)?,
                h => write!(f, "{name}^({h}/2)")?,
            }
        }
        if first { f.write_str("1") } else { Ok(()) }
    }
}

thread_local! {
    static CLASH: Cell<Option<(Dimension, Dimension)>> = const { Cell::new(None) };
}

/// A number of which only the dimension is kept.
///
/// `None` is the dimension of a literal zero, which may be added to anything. The first sum (or comparison,
/// or argument of a sine) that does not add up is noted; ask [`Unit::clash`] for it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit(Option<Dimension>);

impl Unit {
    /// A quantity of this dimension.
    pub fn of(dimension: Dimension) -> Self {
        Self(Some(dimension))
    }
    /// Its dimension; `None` for a literal zero, which has any.
    pub fn dimension(self) -> Option<Dimension> {
        self.0
    }
    /// The first pair of dimensions that met and did not agree since the last call, on this thread.
    pub fn clash() -> Option<(Dimension, Dimension)> {
        CLASH.take()
    }
    /// Both must agree; gives what they agree on.
    fn agree(self, o: Self) -> Self {
        match (self.0, o.0) {
            (Some(a), Some(b)) if a != b => {
                CLASH.set(Some(CLASH.get().unwrap_or((a, b))));
                self
            }
            (Some(_), _) => self,
            _ => o,
        }
    }
    /// A function of a pure number.
    fn number(self) -> Self {
        self.agree(Self::of(Dimension::NONE));
        Self::of(Dimension::NONE)
    }
}

impl From<f64> for Unit {
    fn from(x: f64) -> Self {
        if x == 0.0 { Self(None) } else { Self::of(Dimension::NONE) }
    }
}
impl Neg for Unit {
    type Output = Self;
    fn neg(self) -> Self {
        self
    }
}
impl Add for Unit {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        self.agree(o)
    }
}
impl Sub for Unit {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        self.agree(o)
    }
}
impl Mul for Unit {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        Self(self.0.zip(o.0).map(|(a, b)| a.times(b)))
    }
}
impl Div for Unit {
    type Output = Self;
    fn div(self, o: Self) -> Self {
        Self(self.0.zip(o.0).map(|(a, b)| a.over(b)))
    }
}
macro_rules! with_literal {
    ($($operation:ident $method:ident),*) => {$(
        impl $operation<f64> for Unit {
            type Output = Self;
            fn $method(self, o: f64) -> Self {
                $operation::$method(self, Self::from(o))
            }
        }
    )*};
}
with_literal!(Add add, Sub sub, Mul mul, Div div);

impl Scalar for Unit {
    type Mask = bool;
    type Abreast = Self;

    fn all(_: bool) -> bool {
        true
    }

    fn lt(self, o: Self) -> bool {
        self.agree(o);
        true
    }
    fn le(self, o: Self) -> bool {
        self.lt(o)
    }
    fn select(_: bool, a: Self, b: Self) -> Self {
        a.agree(b)
    }
    fn sqrt(self) -> Self {
        Self(self.0.map(|d| Dimension { halves: d.halves.map(|h| h / 2) }))
    }
    fn sin_cos(self) -> (Self, Self) {
        (self.number(), self.number())
    }
    fn tan(self) -> Self {
        self.number()
    }
    fn atan2(self, x: Self) -> Self {
        self.agree(x);
        Self::of(Dimension::NONE)
    }
    fn asin(self) -> Self {
        self.number()
    }
    fn acos(self) -> Self {
        self.number()
    }
    fn exp(self) -> Self {
        self.number()
    }
    fn ln(self) -> Self {
        self.number()
    }
    fn sinh(self) -> Self {
        self.number()
    }
    fn cosh(self) -> Self {
        self.number()
    }
    fn tanh(self) -> Self {
        self.number()
    }
    fn powi(self, n: i32) -> Self {
        Self(self.0.map(|d| d.power(n)))
    }
    fn powf(self, exponent: Self) -> Self {
        exponent.number();
        self.number()
    }
    fn cbrt(self) -> Self {
        Self(self.0.map(|d| Dimension { halves: d.halves.map(|h| h / 3) }))
    }
    fn hypot(self, o: Self) -> Self {
        self.agree(o)
    }
    fn abs(self) -> Self {
        self
    }
    fn sign(self) -> Self {
        Self::of(Dimension::NONE)
    }
}
