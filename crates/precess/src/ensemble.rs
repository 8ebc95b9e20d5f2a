//! One plan from many starts: blocks of lanes, threads over blocks.
//!
//! A member of an ensemble has the bits that it has when it runs alone, whatever the registers, the number of threads
//! and the neighbours. Systems with events, which differ from member to member, run one member after another.

use crate::error::{Error, input};
use crate::members::{Keep, Members};
use crate::plan::Plan;
use crate::run::{Runner, pace};
use crate::workers::{Workers, chunk, spread};
use precess_integrate::{AnyMethod, Block, Failure, Pace, Samples, Steps};
use precess_scalar::{Lanes, with_lanes};
use precess_system::{AnySystem, Bind, Field};
use std::ops::{ControlFlow, Range};

/// Runs a plan from many starts: full states, one after another (see [`grid`](crate::grid)). `progress` is told how
/// many members are done and may end the work; members that are not done then count as interrupted.
///
/// # Errors
/// Where the plan watches events: only a single run does.
pub fn ensemble(
    plan: &Plan,
    starts: &[f64],
    keep: Keep,
    workers: Workers,
    progress: &mut dyn FnMut(usize) -> ControlFlow<()>,
) -> Result<Members, Error> {
    ensemble_between(plan, starts, Samples::new(plan.until, plan.every), keep, workers, progress)
}

/// The same over some of the plan's samples: the starts are states at the first of them.
pub(crate) fn ensemble_between(
    plan: &Plan,
    starts: &[f64],
    samples: Samples,
    keep: Keep,
    workers: Workers,
    progress: &mut dyn FnMut(usize) -> ControlFlow<()>,
) -> Result<Members, Error> {
    if !plan.watches.is_empty() {
        return input("an ensemble watches no events: leave [[event]] out, or run its members one by one");
    }
    with_lanes!(workers.isa, S => Ok(Work::<S>::new(plan, starts, samples, keep).done_by(workers.threads, progress)))
}

/// The work that threads share.
struct Work<'a, S> {
    plan: &'a Plan,
    starts: &'a [f64],
    samples: Samples,
    keep: Keep,
    /// The steps.
    pace: Pace,
    /// The system in lanes, and alone.
    field: Box<dyn Field<S>>,
    runner: Runner<'a>,
}

/// The states of some members, and their failures.
type Part = (Vec<f64>, Vec<(usize, Failure)>);

impl<'a, S: Lanes> Work<'a, S>
where
    dyn AnySystem: Bind<S>,
    dyn AnyMethod: Steps<S>,
{
    fn new(plan: &'a Plan, starts: &'a [f64], samples: Samples, keep: Keep) -> Self {
        let field = Bind::<S>::bind(plan.system, plan.values.map(|x| S::from(*x)), &plan.layout);
        Self { plan, starts, samples, keep, pace: pace(plan), field, runner: Runner::new(plan).over(samples) }
    }

    fn full(&self) -> usize {
        self.plan.start.len()
    }
    fn members(&self) -> usize {
        self.starts.len() / self.full()
    }
    fn kept(&self) -> usize {
        if self.keep == Keep::Last { 1 } else { (self.samples.last() - self.samples.first()) as usize + 1 }
    }
    /// Numbers kept of a member.
    fn size(&self) -> usize {
        self.kept() * self.plan.layout.shape().state()
    }
    /// Events differ from member to member: a system with events runs one after another.
    fn goes_in_lanes(&self) -> bool {
        self.plan.layout.events.is_empty()
    }
    /// Members that are computed together.
    fn block(&self, threads: usize) -> usize {
        match self.pace {
            _ if !self.goes_in_lanes() => 1,
            Pace::Fixed(_) => Block::<S>::capacity(&self.pace, self.field.shape()),
            Pace::Adaptive(_) => chunk(self.members(), S::LANES, threads),
        }
    }

    fn done_by(&self, threads: usize, progress: &mut dyn FnMut(usize) -> ControlFlow<()>) -> Members {
        let block = self.block(threads);
        let range = |k: usize| {
            k * block..if (k + 1) * block < self.members() { (k + 1) * block } else { self.members() }
        };
        let blocks = self.members().div_ceil(block);
        let mut parts: Vec<Option<Part>> = vec![None; blocks];
        let mut done = 0;
        spread(threads, blocks, &|k| self.part(range(k)), &mut |index, part: Part| {
            parts[index] = Some(part);
            done += range(index).len();
            progress(done)
        });
        self.join(parts.into_iter().enumerate().map(|(k, part)| (range(k), part)))
    }

    /// The parts in order; what nobody has done was interrupted.
    fn join(&self, parts: impl Iterator<Item = (Range<usize>, Option<Part>)>) -> Members {
        let mut members = Members {
            state: self.plan.layout.shape().state(),
            times: match self.keep {
                Keep::Last => vec![self.samples.time(self.samples.last())],
                Keep::Samples => {
                    (self.samples.first()..=self.samples.last()).map(|k| self.samples.time(k)).collect()
                }
            },
            numbers: Vec::with_capacity(self.members() * self.size()),
            failures: vec![],
        };
        for (range, part) in parts {
            let (numbers, failures) = part.unwrap_or_else(|| {
                let failures = range.clone().map(|member| (member, Failure::Interrupted { t: 0.0 }));
                (vec![f64::NAN; range.len() * self.size()], failures.collect())
            });
            members.numbers.extend(numbers);
            members.failures.extend(failures);
        }
        members
    }

    fn part(&self, range: Range<usize>) -> Part {
        let mut numbers = vec![f64::NAN; range.len() * self.size()];
        let mut failures = vec![];
        if self.goes_in_lanes() {
            self.in_lanes(range.clone(), &mut numbers);
        }
        let size = self.size();
        for (member, numbers) in range.zip(numbers.chunks_mut(size)) {
            // A member that did not come through in its lane runs alone, which tells when and why.
            if !numbers[size - self.plan.layout.shape().state()..].iter().all(|x| x.is_finite()) {
                failures.extend(self.alone(member, numbers).map(|failure| (member, failure)));
            }
        }
        (numbers, failures)
    }

    /// Keeps the k-th sample of a member among its numbers, where it is wanted.
    fn keep(&self, sample: u64, y: &[f64], numbers: &mut [f64]) {
        let state = self.plan.layout.shape().state();
        let place = match self.keep {
            Keep::Samples => (sample - self.samples.first()) as usize,
            Keep::Last if sample == self.samples.last() => 0,
            Keep::Last => return,
        };
        numbers[place * state..][..state].copy_from_slice(&y[..state]);
    }

    fn in_lanes(&self, members: Range<usize>, numbers: &mut [f64]) {
        let plan = self.plan;
        let block = Block {
            field: &*self.field,
            method: plan.method,
            options: plan.options.clone(),
            samples: self.samples,
            pace: &self.pace,
        };
        let (full, size) = (self.full(), self.size());
        let starts = &self.starts[members.start * full..members.end * full];
        let mut record = |sample: u64, member: usize, y: &[f64]| {
            self.keep(sample, y, &mut numbers[member * size..][..size]);
        };
        block.run(starts, &mut record);
    }

    fn alone(&self, member: usize, numbers: &mut [f64]) -> Option<Failure> {
        numbers.fill(f64::NAN);
        let mut sample = self.samples.first();
        let report = self.runner.drive(
            &self.starts[member * self.full()..][..self.full()],
            &mut |_, y| {
                self.keep(sample, y, numbers);
                sample += 1;
            },
            &mut |_| ControlFlow::Continue(()),
        );
        report.failure
    }
}
