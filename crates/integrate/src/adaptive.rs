//! Steps as long as the estimated error allows.

use crate::engine::{Engine, Flow, fail};
use crate::pacer::{Pacer, first_step};
use crate::{Failure, Tolerance};
use std::ops::ControlFlow;

/// Steps tried between two looks at the pace.
const BETWEEN_PACES: u64 = 1 << 18;
/// More steps than this take hours even where a step costs a microsecond.
const MOST_ATTEMPTS: f64 = 1e10;

impl Engine<'_> {
    /// A run within a tolerance.
    pub fn adaptive(&mut self, tolerance: &Tolerance) -> Flow {
        let order = self.run.method.card().order;
        let until = self.run.samples.time(self.run.samples.last());
        let mut weights = vec![0.0; self.y.len()];
        let mut pacer = Pacer::new(order, first_step(self.run.field, tolerance, order, &self.y, until));
        self.evaluations += 2;
        while self.due <= self.run.samples.last() {
            self.look()?;
            self.keep_pace(until, pacer.h)?;
            pacer.h = if pacer.h.abs() <= self.limit { pacer.h } else { self.limit * pacer.h.signum() };
            let (step, end) = pacer.next(self.t, until);
            if end == self.t {
                return self.no_step(pacer.h);
            }
            self.attempt(step)?;
            tolerance.weights(&self.y, &self.next, &mut weights);
            let error = if self.is_finite() { self.stepper.error(step, &weights) } else { f64::NAN };
            if pacer.judge(step, error) {
                self.report.steps += 1;
                self.finish_step(step, end, true)?;
            } else {
                self.report.rejections += 1;
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
}
