//! What an equation of mechanics may do with a number.

use crate::Abreast;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// Work to be done inside [`Scalar::enter`].
///
/// A closure would do but for one thing: nothing can force it to be inlined, and what is not inlined there is
/// compiled without the instructions. Implementations of `run`, and all that they call in a loop, are
/// `#[inline(always)]`.
pub trait Kernel {
    /// What comes out.
    type Output;
    /// Does the work.
    fn run(self) -> Self::Output;
}

/// A number that an equation computes with.
///
/// There is no `PartialOrd` and no conversion to `f64`: a block of lanes and a trace cannot branch.
/// Comparisons give a mask, and [`select`](Scalar::select) chooses between two values that have both
/// been computed. Literals enter by `S::from(0.5)` or as the right-hand side of an operator (`x * 0.5`).
///
/// Every function gives the same bits for every number built on `f64`; see
/// [`elementary`](crate::elementary) for their error bounds and their values at infinities and NaN.
pub trait Scalar:
    Copy
    + From<f64>
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
    + Mul<f64, Output = Self>
    + Div<f64, Output = Self>
    + Send
    + Sync
    + 'static
{
    /// The outcome of a comparison: one truth value per lane.
    type Mask: Copy
        + Send
        + BitAnd<Output = Self::Mask>
        + BitOr<Output = Self::Mask>
        + Not<Output = Self::Mask>;
    /// Several of these in one, where there are such lanes (see [`is_abreast`](Scalar::is_abreast)); itself elsewhere.
    type Abreast: Abreast<Self>;

    /// Whether this machine computes with several of these in one.
    fn is_abreast() -> bool {
        false
    }

    /// `self < other`; false where either is NaN.
    fn lt(self, other: Self) -> Self::Mask;
    /// `self <= other`; false where either is NaN.
    fn le(self, other: Self) -> Self::Mask;
    /// `a` where the mask holds, `b` elsewhere.
    fn select(mask: Self::Mask, a: Self, b: Self) -> Self;

    /// Runs a kernel with the machine's instructions for this number switched on.
    #[inline(always)]
    fn enter<K: Kernel>(kernel: K) -> K::Output {
        kernel.run()
    }

    /// The mask that holds everywhere.
    #[inline(always)]
    fn always() -> Self::Mask {
        Self::from(0.0).le(Self::from(0.0))
    }

    /// Whether the mask holds in every lane: the end of an iteration. A number that cannot branch says no.
    fn all(_mask: Self::Mask) -> bool {
        false
    }

    /// Correctly rounded square root.
    fn sqrt(self) -> Self;
    /// Sine and cosine together (they share the argument reduction).
    fn sin_cos(self) -> (Self, Self);
    /// Tangent.
    fn tan(self) -> Self;
    /// Angle of the point (`x`, `self`), in (-pi, pi].
    fn atan2(self, x: Self) -> Self;
    /// Arc sine.
    fn asin(self) -> Self;
    /// Arc cosine.
    fn acos(self) -> Self;
    /// Exponential.
    fn exp(self) -> Self;
    /// Natural logarithm.
    fn ln(self) -> Self;
    /// Hyperbolic sine.
    fn sinh(self) -> Self;
    /// Hyperbolic cosine.
    fn cosh(self) -> Self;
    /// Hyperbolic tangent.
    fn tanh(self) -> Self;
    /// Integer power, by repeated squaring (a reciprocal at the end where `n` is negative).
    fn powi(self, n: i32) -> Self;
    /// Real power; NaN for a negative base and a broken exponent.
    fn powf(self, exponent: Self) -> Self;
    /// Real cube root.
    fn cbrt(self) -> Self;
    /// `sqrt(self^2 + other^2)` without overflow on the way.
    fn hypot(self, other: Self) -> Self;
    /// Absolute value.
    fn abs(self) -> Self;

    /// Sine.
    #[inline(always)]
    fn sin(self) -> Self {
        self.sin_cos().0
    }
    /// Cosine.
    #[inline(always)]
    fn cos(self) -> Self {
        self.sin_cos().1
    }
    /// `self > other`; false where either is NaN.
    #[inline(always)]
    fn gt(self, other: Self) -> Self::Mask {
        other.lt(self)
    }
    /// -1, 0 or 1; zero (not plus or minus one) at both zeros, NaN at NaN.
    #[inline(always)]
    fn sign(self) -> Self {
        let zero = Self::from(0.0);
        let negative = Self::select(self.lt(zero), Self::from(-1.0), self);
        Self::select(zero.lt(self), Self::from(1.0), negative)
    }
    /// The larger of two; `other` where they do not compare.
    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        Self::select(other.lt(self), self, other)
    }
    /// The smaller of two; `other` where they do not compare.
    #[inline(always)]
    fn smaller(self, other: Self) -> Self {
        Self::select(self.lt(other), self, other)
    }
    /// `self * self`.
    #[inline(always)]
    fn squared(self) -> Self {
        self * self
    }
}
