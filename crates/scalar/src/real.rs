//! The plain number.

use crate::{Isa, Scalar, Wide, elementary};

impl Scalar for f64 {
    type Mask = bool;
    type Abreast = Wide;

    fn is_abreast() -> bool {
        Isa::has_wide()
    }

    #[inline(always)]
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
    fn abs(self) -> Self {
        f64::abs(self)
    }
    elementary::methods!();
}
