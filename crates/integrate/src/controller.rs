//! The step-size controller: how long the next step is, from the error of the last.
//!
//! Errors are scaled per component, `atol + rtol max(|y0|, |y1|)`, so that a large component (a growing angle)
//! never hides the error of a small one. (Hairer, Norsett, Wanner, *Solving ODEs I*, II.4.)

use precess_scalar::Scalar;

/// Proportional-integral controller.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Controller {
    /// One over the order of the error estimate.
    pub exponent: f64,
    /// Weight of the error before the last: damps oscillations of the step.
    pub beta: f64,
    /// Smallest factor between steps.
    pub low: f64,
    /// Largest factor between steps.
    pub high: f64,
}

const SAFETY: f64 = 0.9;

impl Controller {
    /// The factor for the next step; an error above one means that the step is to be repeated. An error that is
    /// NaN gives the smallest factor.
    #[inline(always)]
    pub fn factor<S: Scalar>(&self, error: S, previous: S) -> S {
        let alpha = self.exponent - 0.75 * self.beta;
        let mut factor = error.powf(S::from(-alpha)) * SAFETY;
        if self.beta != 0.0 {
            factor = factor * previous.powf(S::from(self.beta));
        }
        let factor = S::select(factor.lt(S::from(self.high)), factor, S::from(self.high));
        let factor = S::select(factor.gt(S::from(self.low)), factor, S::from(self.low));
        S::select(error.le(S::from(f64::MAX)), factor, S::from(self.low))
    }
}

/// Tolerances, and the components that the norm leaves out.
#[derive(Clone, Debug, PartialEq)]
pub struct Tolerance {
    /// Relative.
    pub rtol: f64,
    /// Absolute.
    pub atol: f64,
    /// Components left out: cyclic angles, modes.
    pub skip: Vec<bool>,
}

impl Tolerance {
    /// One over the tolerated error of each component; zero for those left out.
    #[inline(always)]
    pub fn weights<S: Scalar>(&self, before: &[S], after: &[S], weights: &mut [S]) {
        for (i, weight) in weights.iter_mut().enumerate() {
            let size = before[i].abs().larger(after[i].abs());
            // Without the last term a component that is zero would divide by zero where atol is zero.
            let scale = size * self.rtol + self.atol + 1e-200;
            let skip = self.skip.get(i).copied().unwrap_or(false);
            *weight = if skip { S::from(0.0) } else { S::from(1.0) / scale };
        }
    }
}

/// Root mean square of weighted components, summed in the order of the components; those of weight zero do not
/// count, so that a resting mode does not make the others look better than they are.
#[inline(always)]
pub(crate) fn norm<S: Scalar>(components: &[S], weights: &[S]) -> S {
    let (zero, one) = (S::from(0.0), S::from(1.0));
    let (mut sum, mut count) = (zero, zero);
    for (x, w) in components.iter().zip(weights) {
        let scaled = *x * *w;
        sum = sum + scaled * scaled;
        count = count + S::select(zero.lt(*w), one, zero);
    }
    (sum / count.larger(one)).sqrt()
}
