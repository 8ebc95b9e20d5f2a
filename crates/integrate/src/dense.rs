//! Dense output: the state anywhere inside a step.
//!
//! With s in [0, 1] over the step, y0 + s (F0 + (1-s) (F1 + s (F2 + (1-s) (F3 + ...)))). F0 to F2 make the
//! cubic through both ends with both slopes, which any method has; further terms raise the order (Hairer,
//! Norsett, Wanner, *Solving ODEs I*, II.6).

use precess_scalar::Scalar;

/// The polynomial over one step.
#[derive(Clone, Debug)]
pub struct Dense<S> {
    t: S,
    /// The length in which the polynomial's argument is measured.
    span: S,
    start: Vec<S>,
    end: Vec<S>,
    terms: Vec<Vec<S>>,
    /// Powers of s alone, without (1-s).
    series: bool,
}

impl<S: Scalar> Dense<S> {
    /// The cubic through both ends with both slopes; its error falls with the fourth power of the step.
    #[inline(always)]
    pub fn hermite(t: S, h: S, start: &[S], end: &[S], rate_start: &[S], rate_end: &[S]) -> Self {
        let n = start.len();
        let difference: Vec<S> = (0..n).map(|i| end[i] - start[i]).collect();
        let first = (0..n).map(|i| h * rate_start[i] - difference[i]).collect();
        let second = (0..n).map(|i| difference[i] * 2.0 - h * (rate_end[i] + rate_start[i])).collect();
        Self {
            t,
            span: h,
            start: start.to_vec(),
            end: end.to_vec(),
            terms: vec![difference, first, second],
            series: false,
        }
    }

    /// A power series: `start + s (F0 + s (F1 + ...))`.
    #[inline(always)]
    pub fn series(t: S, h: S, start: &[S], end: &[S], terms: Vec<Vec<S>>) -> Self {
        Self { t, span: h, start: start.to_vec(), end: end.to_vec(), terms, series: true }
    }

    /// The step ends at this time, which `t + h` gives up to rounding alone: from now on exactly.
    #[must_use]
    #[inline(always)]
    pub fn ending(mut self, end: S) -> Self {
        self.span = end - self.t;
        self
    }

    /// Adds the next term.
    #[inline(always)]
    pub fn push(&mut self, term: Vec<S>) {
        self.terms.push(term);
    }

    /// The state at a time inside the step; exactly the ends at the ends.
    #[inline(always)]
    pub fn at(&self, t: S, y: &mut [S]) {
        let s = (t - self.t) / self.span;
        let rest = S::from(1.0) - s;
        let before_end = s.lt(S::from(1.0));
        for (i, y) in y.iter_mut().enumerate() {
            let mut sum = S::from(0.0);
            for (k, term) in self.terms.iter().enumerate().rev() {
                sum = (sum + term[i]) * if self.series || k % 2 == 0 { s } else { rest };
            }
            *y = S::select(before_end, self.start[i] + sum, self.end[i]);
        }
    }
}
