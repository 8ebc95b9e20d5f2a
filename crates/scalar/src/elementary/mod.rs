//! Elementary functions that give the same bits on every machine.
//!
//! Nothing but `+ - * /`, square roots, comparisons and operations on the bits of a number enters them, each
//! rounded once by IEEE 754; no fused multiply-add, no mathematics of the platform. They have no branches
//! (but for [`sin_cos`] and [`tan`] beyond `2^18`), so that all lanes of a register go through them together.
//!
//! Errors are in units of the last place of the exact result. "Found" is the worst of some millions of
//! arguments of all exponents, dense where a function is hard; tests hold every function to its bound.
//!
//! | function    | bound | found | at infinity            | elsewhere                                  |
//! |-------------|-------|-------|------------------------|--------------------------------------------|
//! | [`sin_cos`] | 1     | 0.85  | NaN                    | `sin(-0) = -0`; any size of angle          |
//! | [`tan`]     | 2     | 1.22  | NaN                    | `tan(-0) = -0`; any size of angle          |
//! | [`exp`]     | 1     | 0.78  | inf, 0                 | gradual underflow                          |
//! | [`ln`]      | 1     | 0.89  | inf                    | `ln(+-0) = -inf`, NaN below zero           |
//! | [`atan2`]   | 2     | 0.68  | corners: odd pi/4      | by the signs of zeros: `atan2(-0, -1) = -pi` |
//! | [`asin`]    | 2     | 0.67  | NaN                    | NaN beyond 1                               |
//! | [`acos`]    | 2     | 0.68  | NaN                    | NaN beyond 1; `acos(1) = 0`                |
//! | [`sinh`]    | 2     | 0.63  | +-inf                  | `sinh(-0) = -0`                            |
//! | [`cosh`]    | 2     | 0.63  | inf                    |                                            |
//! | [`tanh`]    | 2     | 0.62  | +-1                    | `tanh(-0) = -0`                            |
//! | [`cbrt`]    | 1     | 0.67  | +-inf                  | `cbrt(-0) = -0`                            |
//! | [`hypot`]   | 1     | 0.51  | inf, even beside NaN   |                                            |
//! | [`powf`]    | 2     | 0.63  | C99, F.9.4.4           | 1 for `x^0` and `1^y`, even at NaN         |
//! | [`powi`]    | n     |       | as products            | relative error at most `n 2^-53`           |
//!
//! Results at zeros, infinities and NaN are those of C99, Annex F. A NaN has no defined sign or payload.

mod exact;
mod exp;
mod huge;
mod hyperbolic;
mod inverse;
mod ln;
mod polynomial;
mod power;
mod roots;
mod trig;

pub use exp::exp;
pub use hyperbolic::{cosh, sinh, tanh};
pub use inverse::{acos, asin, atan2};
pub use ln::ln;
pub use power::{powf, powi};
pub use roots::{cbrt, hypot};
pub use trig::{sin_cos, tan};

pub(crate) use exact::{two_prod, two_sum};
pub(crate) use huge::turns;
pub(crate) use power::repeated_squaring;

/// The elementary functions as methods of [`Scalar`](crate::Scalar), for every number that is made of doubles.
macro_rules! methods {
    () => {
        elementary::methods! {
            tan(self), atan2(self, x: Self), asin(self), acos(self), exp(self), ln(self), sinh(self), cosh(self),
            tanh(self), powi(self, n: i32), powf(self, exponent: Self), cbrt(self), hypot(self, other: Self)
        }
        #[inline(always)]
        fn sin_cos(self) -> (Self, Self) {
            elementary::sin_cos(self)
        }
    };
    ($($name:ident($itself:ident $(, $other:ident: $type:ty)?)),*) => {$(
        #[inline(always)]
        fn $name($itself $(, $other: $type)?) -> Self {
            elementary::$name($itself $(, $other)?)
        }
    )*};
}
pub(crate) use methods;
