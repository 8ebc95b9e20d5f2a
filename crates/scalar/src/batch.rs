//! A block of lanes: the numbers of a register, which go through the same operations.
//!
//! A lane gives the bits that the plain `f64` gives, whatever its neighbours do.

use crate::lanes::SIGN;
use crate::register::{Register, Word};
use crate::{Kernel, Lanes, Scalar, elementary};
use std::fmt;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// Numbers side by side in a register.
#[derive(Clone, Copy)]
#[repr(transparent)]
pub struct Batch<V>(V);

/// One truth value per lane.
#[derive(Clone, Copy)]
pub struct LaneMask<V: Register>(V::Mask);

impl<V: Register> LaneMask<V> {
    /// Whether the mask holds in this lane.
    #[inline(always)]
    pub fn lane(self, i: usize) -> bool {
        V::truth(self.0) >> i & 1 == 1
    }
}
impl<V: Register> BitAnd for LaneMask<V> {
    type Output = Self;
    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Self(V::both(self.0, other.0))
    }
}
impl<V: Register> BitOr for LaneMask<V> {
    type Output = Self;
    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        Self(V::either(self.0, other.0))
    }
}
impl<V: Register> Not for LaneMask<V> {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        Self(V::not(self.0))
    }
}

impl<V: Register> fmt::Debug for Batch<V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.lanes()).finish()
    }
}
impl<V: Register> From<f64> for Batch<V> {
    #[inline(always)]
    fn from(x: f64) -> Self {
        Self(V::splat(x))
    }
}
impl<V: Register> Neg for Batch<V> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::of_bits(self.bits() ^ SIGN)
    }
}
macro_rules! lanewise {
    ($($operation:ident $method:ident),*) => {$(
        impl<V: Register> $operation for Batch<V> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(V::$method(self.0, other.0))
            }
        }
        impl<V: Register> $operation<f64> for Batch<V> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: f64) -> Self {
                Self(V::$method(self.0, V::splat(other)))
            }
        }
    )*};
}
lanewise!(Add add, Sub sub, Mul mul, Div div);

impl<V: Register> Lanes for Batch<V> {
    type Register = V;

    #[inline(always)]
    fn bits(self) -> Word<V> {
        Word(V::to_word(self.0))
    }
    #[inline(always)]
    fn of_bits(bits: Word<V>) -> Self {
        Self(V::from_word(bits.0))
    }
    #[inline(always)]
    fn odd(bits: Word<V>) -> LaneMask<V> {
        LaneMask(V::odd(bits.0))
    }
    #[inline(always)]
    fn equals(self, other: Self) -> LaneMask<V> {
        LaneMask(V::eq(self.0, other.0))
    }
    #[inline(always)]
    fn truth(mask: LaneMask<V>) -> u32 {
        V::truth(mask.0)
    }
    #[inline(always)]
    #[allow(unsafe_code)]
    fn lanes(&self) -> &[f64] {
        // A register is its doubles side by side, in the order of memory.
        unsafe { std::slice::from_raw_parts((&raw const self.0).cast(), V::LANES) }
    }
    #[inline(always)]
    #[allow(unsafe_code)]
    fn lanes_mut(&mut self) -> &mut [f64] {
        // As above.
        unsafe { std::slice::from_raw_parts_mut((&raw mut self.0).cast(), V::LANES) }
    }
}

impl<V: Register> Scalar for Batch<V> {
    type Mask = LaneMask<V>;
    type Abreast = Self;

    #[inline(always)]
    fn enter<K: Kernel>(kernel: K) -> K::Output {
        V::enter(kernel)
    }
    #[inline(always)]
    fn all(mask: LaneMask<V>) -> bool {
        !Self::any(!mask)
    }
    #[inline(always)]
    fn lt(self, other: Self) -> LaneMask<V> {
        LaneMask(V::lt(self.0, other.0))
    }
    #[inline(always)]
    fn le(self, other: Self) -> LaneMask<V> {
        LaneMask(V::le(self.0, other.0))
    }
    #[inline(always)]
    fn select(mask: LaneMask<V>, a: Self, b: Self) -> Self {
        Self(V::select(mask.0, a.0, b.0))
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(V::sqrt(self.0))
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self::of_bits(self.bits() & !SIGN)
    }
    elementary::methods!();
}
