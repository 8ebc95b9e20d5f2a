//! The drive: a stepper taken from the start to the end of a run, with samples and events on the way.

use crate::controller::norm;
use crate::event::Scanner;
use crate::{
    AnyMethod, Controller, Dense, Failure, Occurred, Options, Samples, Source, Stepper, Steps, Tolerance,
    Watched,
};
use precess_scalar::Scalar;
use precess_system::{Direction, Field};
use std::ops::ControlFlow;

/// How long the steps are.
#[derive(Clone, Debug, PartialEq)]
pub enum Pace {
    /// Of this length; the last one before a sample is shortened.
    Fixed(f64),
    /// As long as the estimated error stays within the tolerance; samples come from dense output.
    Adaptive(Tolerance),
}

/// A run to be made.
pub struct Drive<'a> {
    /// The system with its parameters.
    pub field: &'a dyn Field<f64>,
    /// The method.
    pub method: &'a dyn AnyMethod,
    /// Its options.
    pub options: Options,
    /// The full state at t = 0.
    pub start: &'a [f64],
    /// The times of the samples; the last one is the end.
    pub samples: Samples,
    /// The steps.
    pub pace: Pace,
    /// Directions of the system's own events.
    pub directions: &'a [Direction],
    /// Functions that the user watches.
    pub watches: &'a [Watched<'a>],
}

/// What a run has cost and met.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Report {
    /// Accepted steps.
    pub steps: u64,
    /// Rejected steps.
    pub rejections: u64,
    /// Evaluations of the field.
    pub evaluations: u64,
    /// Events in the order of the integration.
    pub events: Vec<Occurred>,
    /// The time reached.
    pub end: f64,
    /// The watch that ended the run.
    pub stopped_by: Option<usize>,
    /// Why the run ended before its time.
    pub failure: Option<Failure>,
}

/// Makes a run. `record` gets every sample (time and full state), `progress` the time now and then; the report
/// says what ended it. Whatever happens, the samples recorded so far are right.
pub fn drive(
    run: &Drive,
    record: &mut dyn FnMut(f64, &[f64]),
    progress: &mut dyn FnMut(f64) -> ControlFlow<()>,
) -> Report {
    let mut engine = Engine {
        run,
        stepper: Steps::<f64>::stepper(run.method, run.field.shape(), &run.options),
        scanner: Scanner::new(run.field, run.directions, run.watches),
        t: 0.0,
        y: run.start.to_vec(),
        next: run.start.to_vec(),
        sample: vec![0.0; run.start.len()],
        due: 1,
        restarts: 0,
        fired: vec![f64::NEG_INFINITY; run.directions.len()],
        report: Report::default(),
        record,
        progress,
    };
    let outcome = engine.go();
    let mut report = engine.report;
    report.evaluations = engine.stepper.evaluations();
    report.end = engine.t;
    if let ControlFlow::Break(end) = outcome {
        match end {
            End::Stop(watch) => report.stopped_by = Some(watch),
            End::Failure(failure) => report.failure = Some(failure),
        }
    }
    report
}

enum End {
    Stop(usize),
    Failure(Failure),
}

type Flow = ControlFlow<End>;

fn fail(failure: Failure) -> Flow {
    ControlFlow::Break(End::Failure(failure))
}

struct Engine<'a> {
    run: &'a Drive<'a>,
    stepper: Box<dyn Stepper<f64>>,
    scanner: Scanner<'a>,
    t: f64,
    y: Vec<f64>,
    next: Vec<f64>,
    sample: Vec<f64>,
    /// Index of the next sample.
    due: u64,
    /// Events since the last step that none has cut.
    restarts: u32,
    /// When each of the system's events happened last.
    fired: Vec<f64>,
    report: Report,
    record: &'a mut dyn FnMut(f64, &[f64]),
    progress: &'a mut dyn FnMut(f64) -> ControlFlow<()>,
}

/// Steps between two looks at the clock.
const BETWEEN_LOOKS: u64 = 256;
/// Events in a row, without a whole step between, that no motion has.
const MOST_RESTARTS: u32 = 1000;
/// An event that comes again sooner than this (in units of the run) comes again and again: a ball at rest.
const SHORTEST_PAUSE: f64 = 1e-9;
/// A remainder of a step below this share of it is merged into the last step before a sample.
const MERGED: f64 = 1e-9;
/// Pieces of an adaptive step that are searched for events one by one.
const PIECES: u32 = 4;

impl Engine<'_> {
    fn go(&mut self) -> Flow {
        (self.record)(0.0, &self.y);
        if !self.y.iter().all(|x| x.is_finite()) {
            return fail(Failure::Diverged { t: 0.0 });
        }
        if self.run.samples.last() == 0 {
            return ControlFlow::Continue(());
        }
        self.scanner.begin(self.t, &self.y);
        match &self.run.pace {
            Pace::Fixed(dt) => self.fixed(*dt),
            Pace::Adaptive(tolerance) => self.adaptive(tolerance),
        }
    }

    /// Looks at the clock now and then.
    fn look(&mut self) -> Flow {
        if (self.report.steps + self.report.rejections).is_multiple_of(BETWEEN_LOOKS)
            && (self.progress)(self.t).is_break()
        {
            return fail(Failure::Interrupted { t: self.t });
        }
        ControlFlow::Continue(())
    }

    fn attempt(&mut self, h: f64) -> Flow {
        match self.stepper.step(self.run.field, self.t, &self.y, h, &mut self.next) {
            Ok(()) => ControlFlow::Continue(()),
            Err(e) => fail(Failure::NoConvergence { t: self.t, h, iterations: e.iterations }),
        }
    }

    fn fixed(&mut self, dt: f64) -> Flow {
        while self.due <= self.run.samples.last() {
            let (from, to) = (self.t, self.run.samples.time(self.due));
            if from == to {
                (self.record)(self.t, &self.y);
                self.due += 1;
                continue;
            }
            let whole = ((to - from).abs() / dt - MERGED).ceil();
            let steps = if whole < 1.0 { 1 } else { whole as u64 };
            let signed = if to < from { -dt } else { dt };
            let mut cut = false;
            for n in 0..steps {
                // Times are computed from the last sample, not accumulated.
                let t = if n == 0 { from } else { from + n as f64 * signed };
                let last = n + 1 == steps;
                self.t = t;
                let h = if last { to - t } else { signed };
                self.look()?;
                self.attempt(h)?;
                if !self.next.iter().all(|x| x.is_finite()) {
                    return fail(Failure::Diverged { t });
                }
                self.report.steps += 1;
                let end = if last { to } else { from + (n + 1) as f64 * signed };
                cut = self.finish_step(t, end - t, end, 1)?;
                if cut {
                    break;
                }
            }
            if !cut {
                (self.record)(self.t, &self.y);
                self.due += 1;
            }
        }
        ControlFlow::Continue(())
    }

    fn adaptive(&mut self, tolerance: &Tolerance) -> Flow {
        let order = f64::from(self.run.method.card().order);
        // Hairer's choices: proportional-integral for the method of order 5, proportional for that of order 8.
        let beta = if order < 8.0 { 0.04 } else { 0.0 };
        let controller =
            Controller { exponent: 1.0 / order, beta, low: 0.2, high: if beta == 0.0 { 6.0 } else { 10.0 } };
        let until = self.run.samples.time(self.run.samples.last());
        let mut weights = vec![0.0; self.y.len()];
        let mut h = self.first_step(tolerance, order, until);
        let (mut previous, mut rejected) = (1e-4, false);
        while self.due <= self.run.samples.last() {
            self.look()?;
            let rest = until - self.t;
            // A last step that would leave a sliver takes it along.
            let last = h.abs() * (1.0 + 1e-6) >= rest.abs();
            let (step, end) = if last { (rest, until) } else { (h, self.t + h) };
            if end == self.t {
                let finite = self.next.iter().all(|x| x.is_finite());
                return fail(if finite {
                    Failure::StepTooSmall { t: self.t, h }
                } else {
                    Failure::Diverged { t: self.t }
                });
            }
            self.attempt(step)?;
            tolerance.weights(&self.y, &self.next, &mut weights);
            let finite = self.next.iter().all(|x| x.is_finite());
            let error = if finite { self.stepper.error(step, &weights) } else { f64::NAN };
            let mut factor = controller.factor(error, previous);
            if error <= 1.0 {
                if rejected && factor > 1.0 {
                    factor = 1.0;
                }
                previous = if error > 1e-4 { error } else { 1e-4 };
                rejected = false;
                self.report.steps += 1;
                self.finish_step(self.t, step, end, PIECES)?;
                // A step cut short by the end says nothing about the next one; there is none.
                h = step * factor;
            } else {
                rejected = true;
                self.report.rejections += 1;
                h = step * if factor < 1.0 { factor } else { 0.5 };
            }
        }
        ControlFlow::Continue(())
    }

    /// Samples and events of a step that is accepted; true where an event has cut it.
    fn finish_step(&mut self, t: f64, h: f64, end: f64, pieces: u32) -> ControlFlow<End, bool> {
        let adaptive = pieces > 1;
        let passed = !self.scanner.is_idle() && (self.scanner.ends_differ(end, &self.next) || adaptive);
        let sampled = adaptive && self.is_due(end);
        if passed || sampled {
            let dense = self.stepper.dense(self.run.field, t, &self.y, h, &self.next);
            let found = if passed { self.scanner.find(&dense, t, h, pieces) } else { vec![] };
            for &(when, source) in &found {
                self.record_until(&dense, when);
                let mut state = vec![0.0; self.y.len()];
                dense.at(when, &mut state);
                self.report.events.push(Occurred { source, t: when, state: state.clone() });
                match source {
                    Source::Watch(k) if self.run.watches[k].stop => {
                        self.t = when;
                        (self.record)(when, &state);
                        return ControlFlow::Break(End::Stop(k));
                    }
                    Source::Watch(_) => {}
                    Source::System(_) => {
                        self.jump(when, state, &found)?;
                        return ControlFlow::Continue(true);
                    }
                }
            }
            if adaptive {
                self.record_until(&dense, end);
            }
        }
        self.stepper.accept();
        std::mem::swap(&mut self.y, &mut self.next);
        self.t = end;
        self.restarts = 0;
        if !self.scanner.is_idle() {
            self.scanner.begin(self.t, &self.y);
        }
        ControlFlow::Continue(false)
    }

    /// Applies the system's events of this time, and begins anew there.
    fn jump(&mut self, when: f64, state: Vec<f64>, found: &[(f64, Source)]) -> Flow {
        self.y = state;
        let until = self.run.samples.time(self.run.samples.last());
        for (t, source) in found {
            if let (Source::System(k), true) = (source, *t == when) {
                self.run.field.jump(*k, when, &mut self.y);
                let pause = (when - self.fired[*k]).abs();
                self.fired[*k] = when;
                if pause < SHORTEST_PAUSE * until.abs() {
                    return fail(Failure::TooManyEvents { t: when });
                }
            }
        }
        self.t = when;
        self.stepper.restart();
        self.scanner.begin(when, &self.y);
        self.restarts += 1;
        if self.restarts > MOST_RESTARTS {
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

    /// A first step whose second-order term is a hundredth of what the tolerance allows (Hairer, Norsett,
    /// Wanner, *Solving ODEs I*, II.4).
    fn first_step(&mut self, tolerance: &Tolerance, order: f64, until: f64) -> f64 {
        let (n, field) = (self.y.len(), self.run.field);
        let sign = if until < 0.0 { -1.0 } else { 1.0 };
        let mut weights = vec![0.0; n];
        let (mut rate, mut later) = (vec![0.0; n], vec![0.0; n]);
        tolerance.weights(&self.y, &self.y, &mut weights);
        field.rate(self.t, &self.y, &mut rate);
        let (size, speed) = (norm(&self.y, &weights), norm(&rate, &weights));
        let guess = if size < 1e-5 || speed < 1e-5 { 1e-6 } else { 0.01 * size / speed };
        let guess = if guess < until.abs() { guess } else { until.abs() };
        for i in 0..n {
            self.next[i] = self.y[i] + sign * guess * rate[i];
        }
        field.rate(self.t + sign * guess, &self.next, &mut later);
        for i in 0..n {
            later[i] -= rate[i];
        }
        let bend = norm(&later, &weights) / guess;
        let steepest = if bend > speed { bend } else { speed };
        let by_order = if steepest <= 1e-15 {
            if guess * 1e-3 > 1e-6 { guess * 1e-3 } else { 1e-6 }
        } else {
            Scalar::powf(0.01 / steepest, 1.0 / order)
        };
        let first = if 100.0 * guess < by_order { 100.0 * guess } else { by_order };
        sign * if first.is_finite() && first > 0.0 { first } else { 1e-6 }
    }
}
