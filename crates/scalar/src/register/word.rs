//! The bits of a register's numbers, as integers modulo `2^64`.

use super::Register;
use std::ops::{Add, BitAnd, BitOr, BitXor, Sub};

/// The bits of the numbers of a register; sums and differences wrap.
#[derive(Clone, Copy)]
pub struct Word<V: Register>(pub(crate) V::Word);

impl<V: Register> Word<V> {
    /// The same bits in every lane.
    #[inline(always)]
    pub fn splat(bits: u64) -> Self {
        Self(V::word(bits))
    }
    /// Shifted towards the high bits.
    #[inline(always)]
    pub fn left(self, bits: u32) -> Self {
        Self(V::left(self.0, bits))
    }
    /// Shifted towards the low bits.
    #[inline(always)]
    pub fn right(self, bits: u32) -> Self {
        Self(V::right(self.0, bits))
    }
}

macro_rules! bitwise {
    ($($operation:ident $method:ident $instruction:ident),*) => {$(
        impl<V: Register> $operation for Word<V> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(V::$instruction(self.0, other.0))
            }
        }
        impl<V: Register> $operation<u64> for Word<V> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: u64) -> Self {
                Self(V::$instruction(self.0, V::word(other)))
            }
        }
    )*};
}
bitwise!(Add add plus, Sub sub minus, BitAnd bitand and, BitOr bitor or, BitXor bitxor xor);
