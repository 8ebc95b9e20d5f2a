//! Complex numbers, as far as linear oscillators need them.

use precess_scalar::Scalar;

/// A complex number.
#[derive(Clone, Copy)]
pub(crate) struct Complex<S> {
    pub re: S,
    pub im: S,
}

impl<S: Scalar> Complex<S> {
    #[inline(always)]
    pub fn new(re: S, im: S) -> Self {
        Self { re, im }
    }
    #[inline(always)]
    pub fn real(re: S) -> Self {
        Self { re, im: S::from(0.0) }
    }
    #[inline(always)]
    pub fn imaginary(im: S) -> Self {
        Self { re: S::from(0.0), im }
    }
    #[inline(always)]
    pub fn plus(self, o: Self) -> Self {
        Self { re: self.re + o.re, im: self.im + o.im }
    }
    #[inline(always)]
    pub fn minus(self, o: Self) -> Self {
        Self { re: self.re - o.re, im: self.im - o.im }
    }
    #[inline(always)]
    pub fn times(self, o: Self) -> Self {
        Self { re: self.re * o.re - self.im * o.im, im: self.re * o.im + self.im * o.re }
    }
    #[inline(always)]
    pub fn scaled(self, factor: S) -> Self {
        Self { re: self.re * factor, im: self.im * factor }
    }
    /// The square of its size.
    #[inline(always)]
    pub fn square(self) -> S {
        self.re * self.re + self.im * self.im
    }
    #[inline(always)]
    pub fn over(self, o: Self) -> Self {
        let square = o.square();
        let conjugate = Self { re: o.re, im: -o.im };
        let product = self.times(conjugate);
        Self { re: product.re / square, im: product.im / square }
    }
    #[inline(always)]
    pub fn exp(self) -> Self {
        let (sin, cos) = self.im.sin_cos();
        let size = self.re.exp();
        Self { re: size * cos, im: size * sin }
    }
    #[inline(always)]
    pub fn select(mask: S::Mask, a: Self, b: Self) -> Self {
        Self { re: S::select(mask, a.re, b.re), im: S::select(mask, a.im, b.im) }
    }
}
