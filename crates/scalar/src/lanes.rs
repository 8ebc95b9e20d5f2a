//! A number whose lanes are doubles: one, or a register of them. The elementary functions are written for it.

use crate::Scalar;
use crate::register::{Register, Word};

/// A double, or a register of doubles side by side.
pub trait Lanes: Scalar {
    /// The register.
    type Register: Register;
    /// How many doubles.
    const LANES: usize = Self::Register::LANES;

    /// The bits.
    fn bits(self) -> Word<Self::Register>;
    /// The number of these bits.
    fn of_bits(bits: Word<Self::Register>) -> Self;
    /// Where the lowest bit is set.
    fn odd(bits: Word<Self::Register>) -> Self::Mask;
    /// `self == other`; false where either is NaN.
    fn equals(self, other: Self) -> Self::Mask;
    /// Bit i tells whether the mask holds in lane i.
    fn truth(mask: Self::Mask) -> u32;

    /// The doubles, to read.
    fn lanes(&self) -> &[f64];
    /// The doubles, to write.
    fn lanes_mut(&mut self) -> &mut [f64];

    /// A number from its lanes.
    #[inline(always)]
    fn from_lanes(mut lane: impl FnMut(usize) -> f64) -> Self {
        let mut number = Self::from(0.0);
        for (i, place) in number.lanes_mut().iter_mut().enumerate() {
            *place = lane(i);
        }
        number
    }
    /// Whether the mask holds in some lane.
    #[inline(always)]
    fn any(mask: Self::Mask) -> bool {
        Self::truth(mask) != 0
    }
    /// `self < bound`.
    #[inline(always)]
    fn below(self, bound: f64) -> Self::Mask {
        self.lt(Self::from(bound))
    }
    /// `self > bound`.
    #[inline(always)]
    fn above(self, bound: f64) -> Self::Mask {
        Self::from(bound).lt(self)
    }
    /// `self == value`.
    #[inline(always)]
    fn is(self, value: f64) -> Self::Mask {
        self.equals(Self::from(value))
    }
    /// Where it is no number.
    #[inline(always)]
    fn is_nan(self) -> Self::Mask {
        !self.equals(self)
    }
    /// Where the sign bit is set, zeros and NaN included.
    #[inline(always)]
    fn is_negative(self) -> Self::Mask {
        Self::odd(self.bits().right(63))
    }
    /// Its size with the sign of another.
    #[inline(always)]
    fn with_sign(self, sign: Self) -> Self {
        Self::of_bits((self.bits() & !SIGN) | (sign.bits() & SIGN))
    }
    /// Chooses between two bit patterns.
    #[inline(always)]
    fn select_bits(
        mask: Self::Mask,
        a: Word<Self::Register>,
        b: Word<Self::Register>,
    ) -> Word<Self::Register> {
        Self::select(mask, Self::of_bits(a), Self::of_bits(b)).bits()
    }
}

/// The sign of a double.
pub(crate) const SIGN: u64 = 1 << 63;

impl Lanes for f64 {
    type Register = f64;

    #[inline(always)]
    fn bits(self) -> Word<f64> {
        Word(self.to_bits())
    }
    #[inline(always)]
    fn of_bits(bits: Word<f64>) -> Self {
        Self::from_bits(bits.0)
    }
    #[inline(always)]
    fn odd(bits: Word<f64>) -> bool {
        <f64 as Register>::odd(bits.0)
    }
    #[inline(always)]
    fn equals(self, other: Self) -> bool {
        self == other
    }
    #[inline(always)]
    fn truth(mask: bool) -> u32 {
        u32::from(mask)
    }
    #[inline(always)]
    fn lanes(&self) -> &[f64] {
        std::slice::from_ref(self)
    }
    #[inline(always)]
    fn lanes_mut(&mut self) -> &mut [f64] {
        std::slice::from_mut(self)
    }
}
