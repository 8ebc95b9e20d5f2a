//! Steps of one length: times are computed from the last sample or jump, never accumulated.

use crate::Failure;
use crate::engine::{Engine, Flow, fail};
use std::ops::ControlFlow;

/// A remainder below this share of a step is merged into the last step before a sample.
const MERGED: f64 = 1e-9;

impl Engine<'_> {
    /// A run with steps of length `dt`.
    pub fn fixed(&mut self, dt: f64) -> Flow {
        while self.due <= self.run.samples.last() {
            let (due, to) = (self.due, self.run.samples.time(self.due));
            let signed = if to < self.t { -dt } else { dt };
            if self.limit < dt && self.limit < (to - self.t).abs() {
                // Between jumps that follow one another within a step.
                let h = if signed < 0.0 { -self.limit } else { self.limit };
                self.step(h, self.t + h)?;
            } else if self.t == to || !self.stretch(signed, to)? && self.due == due {
                self.record_here();
            }
        }
        ControlFlow::Continue(())
    }

    /// Steps up to a time; true where an event has cut them short.
    fn stretch(&mut self, dt: f64, to: f64) -> ControlFlow<crate::engine::End, bool> {
        let from = self.t;
        let whole = ((to - from) / dt - MERGED).ceil();
        let steps = if whole < 1.0 { 1 } else { whole as u64 };
        for n in 1..steps {
            if self.step(dt, from + n as f64 * dt)? {
                return ControlFlow::Continue(true);
            }
        }
        // A last step that differs from dt by no more than the rounding of the times is dt.
        let rest = to - self.t;
        let rounding = 4.0 * f64::EPSILON * if from.abs() < to.abs() { to.abs() } else { from.abs() };
        self.step(if (rest - dt).abs() <= rounding { dt } else { rest }, to)
    }

    fn step(&mut self, h: f64, end: f64) -> ControlFlow<crate::engine::End, bool> {
        self.look()?;
        self.attempt(h)?;
        if !self.is_finite() {
            fail(Failure::Diverged { t: self.t })?;
        }
        self.report.steps += 1;
        self.finish_step(h, end, false)
    }
}
