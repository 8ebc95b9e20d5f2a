//! What runs at either pace have in common: the end of a step, with its samples and events.

use crate::event::Scanner;
use crate::{
    Dense, Drive, Failure, Kind, NoConvergence, Occurred, Pace, Report, Source, Step, Stepper, Steps,
};
use std::ops::ControlFlow;

/// What ends a run before its time.
pub(crate) enum End {
    Stop(usize),
    Failure(Failure),
}

pub(crate) type Flow = ControlFlow<End>;

pub(crate) fn fail(failure: Failure) -> Flow {
    ControlFlow::Break(End::Failure(failure))
}

pub(crate) struct Engine<'a> {
    pub run: &'a Drive<'a>,
    pub stepper: Box<dyn Stepper<f64>>,
    pub scanner: Scanner<'a>,
    pub t: f64,
    pub y: Vec<f64>,
    pub next: Vec<f64>,
    sample: Vec<f64>,
    /// Index of the next sample.
    pub due: u64,
    /// Times of the last jumps of one event, the latest last.
    jumps: Vec<(usize, f64)>,
    /// Jumps since the last step that none has cut.
    restarts: u32,
    /// The next step is at most this long: a flight between two jumps may be shorter than the one before.
    pub limit: f64,
    /// The time at the last look at the pace.
    pub paced: f64,
    /// Evaluations of the field outside the stepper.
    pub evaluations: u64,
    pub report: Report,
    record: &'a mut dyn FnMut(f64, &[f64]),
    progress: &'a mut dyn FnMut(f64) -> ControlFlow<()>,
}

/// Steps between two looks at the clock.
const BETWEEN_LOOKS: u64 = 256;
/// Jumps without a whole step between that no motion has.
const MOST_RESTARTS: u32 = 10_000;
/// After a jump, the longest step in flights of the length of the last one.
const REACH: f64 = 64.0;
/// One event so many times ...
const CROWD: usize = 4;
/// ... within this share of the time reached: the flights shrink to nothing (Zeno's ball).
const CROWDED: f64 = 1e-9;

impl<'a> Engine<'a> {
    pub fn new(
        run: &'a Drive<'a>,
        record: &'a mut dyn FnMut(f64, &[f64]),
        progress: &'a mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> Self {
        Self {
            run,
            stepper: Steps::<f64>::stepper(run.method, run.field.shape(), &run.options),
            scanner: Scanner::new(run.field, run.directions, run.watches),
            t: run.samples.time(run.samples.first()),
            y: run.start.to_vec(),
            next: run.start.to_vec(),
            sample: vec![0.0; run.start.len()],
            due: run.samples.first() + 1,
            jumps: vec![],
            restarts: 0,
            limit: f64::INFINITY,
            paced: 0.0,
            evaluations: 0,
            report: Report::default(),
            record,
            progress,
        }
    }

    pub fn run(mut self) -> Report {
        let outcome = self.go();
        let mut report = self.report;
        report.evaluations = self.stepper.evaluations() + self.evaluations;
        report.end = self.t;
        report.state = self.y;
        match outcome {
            ControlFlow::Break(End::Stop(watch)) => report.stopped_by = Some(watch),
            ControlFlow::Break(End::Failure(failure)) => report.failure = Some(failure),
            ControlFlow::Continue(()) => {}
        }
        report
    }

    fn go(&mut self) -> Flow {
        (self.record)(self.t, &self.y);
        if !self.y.iter().all(|x| x.is_finite()) {
            return fail(Failure::Diverged { t: self.t });
        }
        if self.run.samples.last() == self.run.samples.first() {
            return ControlFlow::Continue(());
        }
        self.scanner.begin(self.t, &self.y);
        let run = self.run;
        match &run.pace {
            Pace::Fixed(dt) => self.fixed(*dt),
            Pace::Adaptive(tolerance) => self.adaptive(tolerance),
        }
    }

    /// Looks at the clock now and then.
    pub fn look(&mut self) -> Flow {
        let tried = self.report.steps + self.report.rejections;
        if tried.is_multiple_of(BETWEEN_LOOKS) && (self.progress)(self.t).is_break() {
            return fail(Failure::Interrupted { t: self.t });
        }
        ControlFlow::Continue(())
    }

    pub fn attempt(&mut self, h: f64) -> Flow {
        let step = &mut Step { field: self.run.field, t: self.t, y: &self.y, h, out: &mut self.next };
        match self.stepper.step(step) {
            Ok(()) => ControlFlow::Continue(()),
            Err(NoConvergence { iterations }) => {
                let residual = self.stepper.residual();
                fail(Failure::NoConvergence { t: self.t, h, iterations, residual })
            }
        }
    }

    /// Whether the step that was tried ends in numbers.
    pub fn is_finite(&self) -> bool {
        self.next.iter().all(|x| x.is_finite())
    }

    /// Samples and events of a step that is accepted; true where an event has cut it. `thorough` looks inside
    /// the step for samples and for passages there and back.
    pub fn finish_step(&mut self, h: f64, end: f64, thorough: bool) -> ControlFlow<End, bool> {
        let search = !self.scanner.is_idle() && self.scanner.is_needed(end, &self.next, thorough);
        if search || thorough && self.is_due(end) {
            let dense = self.stepper.dense(self.run.field, self.t, &self.y, h, &self.next).ending(end);
            if self.run.method.card().kind == Kind::Fixed {
                // The cubic of any method asks the field at both ends.
                self.evaluations += 2;
            }
            let found =
                if search { self.scanner.find(&dense, self.t, end, &self.next, thorough) } else { vec![] };
            for &(when, source) in &found {
                self.record_until(&dense, when);
                let mut state = vec![0.0; self.y.len()];
                dense.at(when, &mut state);
                match source {
                    Source::Watch(k) => self.watch(k, when, state)?,
                    Source::System(_) => {
                        self.y = state;
                        self.jump(when, &found)?;
                        return ControlFlow::Continue(true);
                    }
                }
            }
            if thorough {
                self.record_until(&dense, end);
            }
        }
        self.stepper.accept(true);
        std::mem::swap(&mut self.y, &mut self.next);
        self.t = end;
        (self.restarts, self.limit) = (0, f64::INFINITY);
        if !self.scanner.is_idle() {
            self.scanner.begin(self.t, &self.y);
            self.scanner.fresh = false;
        }
        ControlFlow::Continue(false)
    }

    /// A watched passage is noted, and may end the run.
    fn watch(&mut self, k: usize, when: f64, state: Vec<f64>) -> Flow {
        let stop = self.run.watches[k].stop;
        if stop && self.run.samples.time(self.due - 1) != when {
            (self.record)(when, &state);
        }
        self.report.events.push(Occurred { source: Source::Watch(k), t: when, state });
        if !stop {
            return ControlFlow::Continue(());
        }
        self.t = when;
        ControlFlow::Break(End::Stop(k))
    }

    /// Applies the system's events of this time to the state, and begins anew there. An event that the jump of
    /// another has called off does not happen.
    fn jump(&mut self, when: f64, found: &[(f64, Source)]) -> Flow {
        let mut first = true;
        for &(t, source) in found {
            let Source::System(k) = source else { continue };
            if t != when || !(first || self.scanner.still_beyond(k, when, &self.y)) {
                continue;
            }
            first = false;
            self.report.events.push(Occurred { source, t, state: self.y.clone() });
            self.run.field.jump(k, when, &mut self.y);
            self.count(k, when)?;
        }
        self.t = when;
        self.stepper.restart();
        self.scanner.begin(when, &self.y);
        self.scanner.fresh = true;
        ControlFlow::Continue(())
    }

    /// Keeps account of the jumps: a next flight may be much shorter than the last, and there must be one.
    fn count(&mut self, event: usize, when: f64) -> Flow {
        self.jumps.retain(|(k, _)| *k == event);
        if let Some((_, last)) = self.jumps.last() {
            self.limit = REACH * (when - last).abs();
        }
        self.jumps.push((event, when));
        if self.jumps.len() > CROWD {
            self.jumps.remove(0);
        }
        let crowded = self.jumps.len() == CROWD && (when - self.jumps[0].1).abs() <= CROWDED * when.abs();
        self.restarts += 1;
        if crowded || self.restarts > MOST_RESTARTS {
            self.t = when;
            return fail(Failure::TooManyEvents { t: when });
        }
        ControlFlow::Continue(())
    }

    /// Whether the next sample lies at or before this time, in the direction of the run.
    fn is_due(&self, t: f64) -> bool {
        let time = self.run.samples.time(self.due);
        let until = self.run.samples.time(self.run.samples.last());
        self.due <= self.run.samples.last() && if until < 0.0 { time >= t } else { time <= t }
    }

    /// Records the samples up to this time from dense output.
    fn record_until(&mut self, dense: &Dense<f64>, t: f64) {
        while self.is_due(t) {
            let time = self.run.samples.time(self.due);
            dense.at(time, &mut self.sample);
            (self.record)(time, &self.sample);
            self.due += 1;
        }
    }

    /// Records the present state as the next sample.
    pub fn record_here(&mut self) {
        (self.record)(self.t, &self.y);
        self.due += 1;
    }
}
