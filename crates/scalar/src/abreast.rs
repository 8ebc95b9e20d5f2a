//! Several numbers in one: a single trajectory fills lanes too, where it has one thing to do many times over.

use crate::{Batch, Scalar, register::Register};

/// Numbers `S` abreast. Each has the bits that it has alone.
pub trait Abreast<S: Scalar>: Scalar {
    /// How many.
    const COUNT: usize;
    /// The same number everywhere.
    fn spread(x: S) -> Self;
    /// The same truth everywhere.
    fn spread_mask(mask: S::Mask) -> Self::Mask;
    /// The numbers, to read.
    fn parts(&self) -> &[S];
    /// The numbers, to write.
    fn parts_mut(&mut self) -> &mut [S];
}

/// A number stands for itself.
impl<S: Scalar> Abreast<S> for S {
    const COUNT: usize = 1;

    #[inline(always)]
    fn spread(x: S) -> S {
        x
    }
    #[inline(always)]
    fn spread_mask(mask: S::Mask) -> S::Mask {
        mask
    }
    #[inline(always)]
    fn parts(&self) -> &[S] {
        std::slice::from_ref(self)
    }
    #[inline(always)]
    fn parts_mut(&mut self) -> &mut [S] {
        std::slice::from_mut(self)
    }
}

impl<V: Register> Abreast<f64> for Batch<V> {
    const COUNT: usize = V::LANES;

    #[inline(always)]
    fn spread(x: f64) -> Self {
        Self::from(x)
    }
    #[inline(always)]
    fn spread_mask(mask: bool) -> Self::Mask {
        Self::from(0.0).lt(Self::from(f64::from(u8::from(mask))))
    }
    #[inline(always)]
    fn parts(&self) -> &[f64] {
        crate::Lanes::lanes(self)
    }
    #[inline(always)]
    fn parts_mut(&mut self) -> &mut [f64] {
        crate::Lanes::lanes_mut(self)
    }
}
