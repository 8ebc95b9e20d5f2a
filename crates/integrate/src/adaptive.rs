//! Steps as long as the estimated error allows.

use crate::controller::norm;
use crate::engine::{Engine, Flow, fail};
use crate::{Controller, Failure, Tolerance};
use precess_scalar::Scalar;
use std::ops::ControlFlow;

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

/// Steps tried between two looks at the pace.
const BETWEEN_PACES: u64 = 1 << 18;
/// More steps than this take hours even where a step costs a microsecond.
const MOST_ATTEMPTS: f64 = 1e10;

impl Engine<'_> {
    /// A run within a tolerance.
    pub fn adaptive(&mut self, tolerance: &Tolerance) -> Flow {
        let order = self.run.method.card().order;
        let controller = controller(order);
        let until = self.run.samples.time(self.run.samples.last());
        let mut weights = vec![0.0; self.y.len()];
        let mut h = self.first_step(tolerance, order, until);
        let (mut previous, mut rejected) = (FORGET, false);
        while self.due <= self.run.samples.last() {
            self.look()?;
            self.keep_pace(until, h)?;
            h = if h.abs() <= self.limit { h } else { self.limit * h.signum() };
            let rest = until - self.t;
            let last = h.abs() * (1.0 + SLIVER) >= rest.abs();
            let (step, end) = if last { (rest, until) } else { (h, self.t + h) };
            if end == self.t {
                return self.no_step(h);
            }
            self.attempt(step)?;
            tolerance.weights(&self.y, &self.next, &mut weights);
            let error = if self.is_finite() { self.stepper.error(step, &weights) } else { f64::NAN };
            let factor = controller.factor(error, previous);
            if error <= 1.0 {
                // A step that was just found too long is not made longer at once.
                h = step * if rejected && factor > 1.0 { 1.0 } else { factor };
                previous = error.larger(FORGET);
                rejected = false;
                self.report.steps += 1;
                self.finish_step(step, end, true)?;
            } else {
                rejected = true;
                self.report.rejections += 1;
                h = step * if factor < 1.0 { factor } else { 0.5 };
            }
        }
        ControlFlow::Continue(())
    }

    /// Every now and then: whether at the pace since the last look the end is within reach.
    fn keep_pace(&mut self, until: f64, h: f64) -> Flow {
        let tried = self.report.steps + self.report.rejections;
        if tried == 0 || !tried.is_multiple_of(BETWEEN_PACES) {
            return ControlFlow::Continue(());
        }
        let needed = (until - self.t).abs() / (self.t - self.paced).abs() * BETWEEN_PACES as f64;
        self.paced = self.t;
        if needed > MOST_ATTEMPTS {
            fail(Failure::TooSlow { t: self.t, h })
        } else {
            ControlFlow::Continue(())
        }
    }

    /// The step has shrunk below the resolution of time.
    fn no_step(&self, h: f64) -> Flow {
        let t = self.t;
        fail(if self.is_finite() { Failure::StepTooSmall { t, h } } else { Failure::Diverged { t } })
    }

    /// A first step whose second-order term is a hundredth of what the tolerance allows (Hairer, Norsett,
    /// Wanner, *Solving ODEs I*, II.4).
    fn first_step(&mut self, tolerance: &Tolerance, order: u32, until: f64) -> f64 {
        let (n, field) = (self.y.len(), self.run.field);
        let sign = if until < 0.0 { -1.0 } else { 1.0 };
        let mut weights = vec![0.0; n];
        let (mut rate, mut later) = (vec![0.0; n], vec![0.0; n]);
        tolerance.weights(&self.y, &self.y, &mut weights);
        field.rate(self.t, &self.y, &mut rate);
        let (size, speed) = (norm(&self.y, &weights), norm(&rate, &weights));
        let guess = if size < 1e-5 || speed < 1e-5 { 1e-6 } else { 0.01 * size / speed };
        let guess = guess.smaller(until.abs());
        for ((next, y), rate) in self.next.iter_mut().zip(&self.y).zip(&rate) {
            *next = y + sign * guess * rate;
        }
        field.rate(self.t + sign * guess, &self.next, &mut later);
        self.evaluations += 2;
        for (later, rate) in later.iter_mut().zip(&rate) {
            *later -= rate;
        }
        let steepest = (norm(&later, &weights) / guess).larger(speed);
        let by_order = if steepest <= 1e-15 {
            (guess * 1e-3).larger(1e-6)
        } else {
            Scalar::powf(0.01 / steepest, 1.0 / f64::from(order))
        };
        let first = (100.0 * guess).smaller(by_order);
        sign * if first.is_finite() && first > 0.0 { first } else { 1e-6 }
    }
}
