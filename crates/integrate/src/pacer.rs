//! The lengths of adaptive steps: the first one, the next one, a step that is too long. Each lane has its own.

use crate::controller::norm;
use crate::{Controller, Tolerance};
use precess_scalar::Scalar;
use precess_system::Field;

/// A step at most this much longer than the controller's takes a sliver before the end along.
const SLIVER: f64 = 1e-6;
/// Errors below this share of the tolerance all count as this to the controller's memory.
const FORGET: f64 = 1e-4;

/// Hairer's choices: proportional-integral for the method of order 5, proportional for that of order 8.
fn controller(order: u32) -> Controller {
    let exponent = 1.0 / f64::from(order);
    if order < 8 {
        Controller { exponent, beta: 0.04, low: 0.2, high: 10.0 }
    } else {
        Controller { exponent, beta: 0.0, low: 0.2, high: 6.0 }
    }
}

/// What the length of the next step depends on.
#[derive(Clone, Copy)]
pub(crate) struct Pacer<S: Scalar> {
    controller: Controller,
    /// The next step.
    pub h: S,
    /// The error of the last accepted step.
    previous: S,
    /// Where the last step was too long.
    rejected: S::Mask,
}

impl<S: Scalar> Pacer<S> {
    /// For a method of this order, and a first step.
    #[inline(always)]
    pub fn new(order: u32, first: S) -> Self {
        Self { controller: controller(order), h: first, previous: S::from(FORGET), rejected: !S::always() }
    }

    /// Begins anew in some lanes, with their first steps.
    #[inline(always)]
    pub fn begin(&mut self, fresh: S::Mask, first: S) {
        self.h = S::select(fresh, first, self.h);
        self.previous = S::select(fresh, S::from(FORGET), self.previous);
        self.rejected = self.rejected & !fresh;
    }

    /// The next step from `t` towards the end: its length, and the time it ends.
    #[inline(always)]
    pub fn next(&self, t: S, until: S) -> (S, S) {
        let rest = until - t;
        let last = rest.abs().le(self.h.abs() * (1.0 + SLIVER));
        (S::select(last, rest, self.h), S::select(last, until, t + self.h))
    }

    /// Where a step with this error is accepted; an error that is NaN counts as too large.
    #[inline(always)]
    pub fn judge(&mut self, step: S, error: S) -> S::Mask {
        let one = S::from(1.0);
        let factor = self.controller.factor(error, self.previous);
        let accepted = error.le(one);
        // A step that was just found too long is not made longer at once.
        let kept = S::select(self.rejected & factor.gt(one), one, factor);
        let shorter = S::select(factor.lt(one), factor, S::from(0.5));
        self.h = step * S::select(accepted, kept, shorter);
        self.previous = S::select(accepted, error.larger(S::from(FORGET)), self.previous);
        self.rejected = !accepted;
        accepted
    }
}

/// A first step whose second-order term is a hundredth of what the tolerance allows (Hairer, Norsett, Wanner, *Solving
/// ODEs I*, II.4). It costs two evaluations.
#[inline(always)]
pub(crate) fn first_step<S: Scalar>(
    field: &dyn Field<S>,
    tolerance: &Tolerance,
    order: u32,
    y: &[S],
    until: f64,
) -> S {
    let sign = S::from(if until < 0.0 { -1.0 } else { 1.0 });
    let zeros = vec![S::from(0.0); y.len()];
    let (mut weights, mut rate, mut later, mut next) = (zeros.clone(), zeros.clone(), zeros.clone(), zeros);
    tolerance.weights(y, y, &mut weights);
    field.rate(S::from(0.0), y, &mut rate);
    let (size, speed) = (norm(y, &weights), norm(&rate, &weights));
    let tiny = size.lt(S::from(1e-5)) | speed.lt(S::from(1e-5));
    let guess = S::select(tiny, S::from(1e-6), size * 0.01 / speed).smaller(S::from(until.abs()));
    for ((next, y), rate) in next.iter_mut().zip(y).zip(&rate) {
        *next = *y + sign * guess * *rate;
    }
    field.rate(sign * guess, &next, &mut later);
    for (later, rate) in later.iter_mut().zip(&rate) {
        *later = *later - *rate;
    }
    let steepest = (norm(&later, &weights) / guess).larger(speed);
    let flat = steepest.le(S::from(1e-15));
    let by_order = (S::from(0.01) / steepest).powf(S::from(1.0 / f64::from(order)));
    let by_order = S::select(flat, (guess * 1e-3).larger(S::from(1e-6)), by_order);
    let first = (guess * 100.0).smaller(by_order);
    let sensible = first.gt(S::from(0.0)) & first.lt(S::from(f64::INFINITY));
    sign * S::select(sensible, first, S::from(1e-6))
}
