//! Elementary functions that give the same bits on every machine.

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
pub(crate) use trig::{is_huge, ordinary_sin_cos, ordinary_tan};
