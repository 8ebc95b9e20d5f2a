//! Sums of steps that carry what their rounding leaves out.

use precess_scalar::Scalar;

/// What rounding has left out of the state, at the start of a step and at its end.
pub(super) struct Carry<S> {
    start: Vec<S>,
    end: Vec<S>,
}

impl<S: Scalar> Carry<S> {
    pub fn new(size: usize) -> Self {
        let zeros = vec![S::from(0.0); size];
        Self { start: zeros.clone(), end: zeros }
    }

    /// What the sum of the steps so far has left out of a number.
    #[inline(always)]
    pub fn left_out(&self, i: usize) -> S {
        self.start[i]
    }

    /// `y` and what a step adds to it; what the rounding of the sum leaves out is kept, exactly (Knuth).
    #[inline(always)]
    pub fn add(&mut self, i: usize, y: S, step: S) -> S {
        let increment = step + self.start[i];
        let sum = y + increment;
        let part = sum - y;
        self.end[i] = (y - (sum - part)) + (increment - part);
        sum
    }

    /// Where the step is accepted, its end is the next start.
    #[inline(always)]
    pub fn accept(&mut self, accepted: S::Mask) {
        for (start, end) in self.start.iter_mut().zip(&self.end) {
            *start = S::select(accepted, *end, *start);
        }
    }

    /// Nothing is left out where a run begins.
    pub fn begin(&mut self, lanes: S::Mask) {
        for carry in self.start.iter_mut().chain(&mut self.end) {
            *carry = S::select(lanes, S::from(0.0), *carry);
        }
    }
}
