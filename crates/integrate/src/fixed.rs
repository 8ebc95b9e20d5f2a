//! Steps of one length: times are computed from the last sample or jump, never accumulated.

use crate::Failure;
use crate::engine::{Engine, Flow, fail};
use crate::stretch::Stretch;
use std::ops::ControlFlow;

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
        for (h, end) in Stretch::new(self.t, to, dt) {
            if self.step(h, end)? {
                return ControlFlow::Continue(true);
            }
        }
        ControlFlow::Continue(false)
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
