//! All starts followed in lanes until each has a verdict, or its time is over; then those with one again, with companions.

use super::companions::{Care, agree, companions, draft};
use super::gate::Gate;
use super::judge::{Judge, Verdict};
use crate::plan::Plan;
use crate::run::{Runner, pace};
use crate::workers::{Workers, chunk, spread};
use precess_integrate::{AnyMethod, Block, Failure, Pace, Roster, Samples, Stepped, Steps};
use precess_scalar::{Lanes, with_lanes};
use precess_system::{AnySystem, Bind, Field};
use std::ops::{ControlFlow, Range};

/// How a motion ended.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Fate {
    /// With a verdict, when, and where it was.
    Judged(Verdict, f64, Vec<f64>),
    /// With one that no companion confirmed.
    Doubtful,
    /// Without: where it was at the end.
    Open(Vec<f64>),
    /// Not in numbers, and when.
    Diverged(f64),
    /// Nobody followed it.
    Interrupted,
}

/// Follows all starts.
pub(super) fn chase(
    judge: &Judge,
    starts: &[f64],
    care: Care,
    workers: Workers,
    progress: &mut dyn FnMut(usize) -> ControlFlow<()>,
) -> Vec<Fate> {
    with_lanes!(workers.isa, S => Chase::<S>::new(judge, starts, care).all(workers.threads, progress))
}

struct Chase<'a, S> {
    judge: &'a Judge,
    plan: &'a Plan,
    starts: &'a [f64],
    samples: Samples,
    pace: Pace,
    companions: Vec<Pace>,
    field: Box<dyn Field<S>>,
    runner: Runner<'a>,
}

impl<'a, S: Lanes> Chase<'a, S>
where
    dyn AnySystem: Bind<S>,
    dyn AnyMethod: Steps<S>,
{
    fn new(judge: &'a Judge, starts: &'a [f64], care: Care) -> Self {
        let plan = &judge.ground.plan;
        let pace = if care == Care::Draft { draft(&pace(plan)) } else { pace(plan) };
        Self {
            judge,
            plan,
            starts,
            samples: Samples::new(plan.until, plan.every),
            companions: if care == Care::Confirmed { companions(&pace) } else { vec![] },
            pace,
            field: Bind::<S>::bind(plan.system, plan.values.map(|x| S::from(*x)), &plan.layout),
            runner: Runner::new(plan),
        }
    }

    fn start(&self, member: usize) -> &[f64] {
        let full = self.plan.start.len();
        &self.starts[member * full..][..full]
    }

    fn all(&self, threads: usize, progress: &mut dyn FnMut(usize) -> ControlFlow<()>) -> Vec<Fate> {
        let members = self.starts.len() / self.plan.start.len();
        let chunk = match self.pace {
            Pace::Fixed(_) => Block::<S>::capacity(&self.pace, self.field.shape()),
            Pace::Adaptive(_) => chunk(members, S::LANES, threads),
        };
        let range = |k: usize| k * chunk..if (k + 1) * chunk < members { (k + 1) * chunk } else { members };
        let mut fates = vec![Fate::Interrupted; members];
        let mut done = 0;
        spread(threads, members.div_ceil(chunk), &|k| self.chunk(range(k)), &mut |k, part: Vec<Fate>| {
            done += part.len();
            fates[k * chunk..][..part.len()].clone_from_slice(&part);
            progress(done)
        });
        fates
    }

    fn chunk(&self, members: Range<usize>) -> Vec<Fate> {
        let first = members.start;
        let every: Vec<usize> = members.clone().collect();
        let followed = self.pursue(&self.pace, &every, &members);
        let mut fates: Vec<Fate> = followed
            .into_iter()
            .zip(members.clone())
            .map(|(fate, k)| fate.unwrap_or_else(|| self.alone(k)))
            .collect();
        if self.companions.is_empty() {
            return fates;
        }
        let mut doubtful = every;
        doubtful.retain(|k| matches!(fates[k - first], Fate::Judged(..)));
        for pace in &self.companions {
            let others = self.pursue(pace, &doubtful, &members);
            let confirmed = |k: &usize| {
                others[k - first].as_ref().is_some_and(|other| agree(self.judge, &fates[k - first], other))
            };
            doubtful.retain(|k| !confirmed(k));
        }
        for k in doubtful {
            fates[k - first] = Fate::Doubtful;
        }
        fates
    }

    /// The fates of some members of a chunk, by place in it, at a pace; none for who did not come through in a lane.
    fn pursue(&self, pace: &Pace, members: &[usize], chunk: &Range<usize>) -> Vec<Option<Fate>> {
        let (fates, gate, rest) = (vec![None; chunk.len()], Gate::new(self.judge), vec![[0, 1]; chunk.len()]);
        let mut pursuit =
            Pursuit { chase: self, members: members.iter(), first: chunk.start, fates, gate, rest };
        let (method, options, samples) = (self.plan.method, self.plan.options.clone(), self.samples);
        Block { field: &*self.field, method, options, samples, pace }.feed(&mut pursuit);
        pursuit.fates
    }

    /// A motion that did not come through in its lane.
    fn alone(&self, member: usize) -> Fate {
        let mut end = self.start(member).to_vec();
        let mut reached = 0.0;
        let mut record = |t: f64, y: &[f64]| {
            reached = t;
            end.copy_from_slice(y);
        };
        let report = self.runner.drive(self.start(member), &mut record, &mut |_| ControlFlow::Continue(()));
        match report.failure {
            Some(Failure::Interrupted { .. }) => Fate::Interrupted,
            Some(failure) => Fate::Diverged(failure.time()),
            None => match self.judge.look(&end) {
                Some(verdict) => Fate::Judged(verdict, reached, end),
                None => Fate::Open(end),
            },
        }
    }
}

/// A chunk on its way.
struct Pursuit<'c, 'a, S> {
    chase: &'c Chase<'a, S>,
    /// Those that have not started yet.
    members: std::slice::Iter<'c, usize>,
    first: usize,
    fates: Vec<Option<Fate>>,
    gate: Gate<S>,
    /// For each member, the looks that are still left out, and how many the next fruitless one will cost: a motion that
    /// the gate lets through again and again is looked at more and more rarely. Not for each lane: when a member is
    /// decided must not depend on who had the lane before it.
    rest: Vec<[u32; 2]>,
}

/// The most looks in a row that are left out.
const MOST_REST: u32 = 64;

impl<S: Lanes> Roster<S> for Pursuit<'_, '_, S>
where
    dyn AnySystem: Bind<S>,
    dyn AnyMethod: Steps<S>,
{
    fn next(&mut self, start: &mut [f64]) -> Option<usize> {
        let member = *self.members.next()?;
        start.copy_from_slice(self.chase.start(member));
        Some(member)
    }

    fn sample(&mut self, sample: u64, member: usize, y: &[f64]) -> bool {
        let Chase { judge, samples, .. } = self.chase;
        if !y.iter().all(|x| x.is_finite()) {
            // It goes on alone, which tells when and why it ended.
            return false;
        }
        let mut fate = judge.look(y).map(|verdict| Fate::Judged(verdict, samples.time(sample), y.to_vec()));
        if fate.is_none() && sample == samples.last() {
            fate = Some(Fate::Open(y.to_vec()));
        }
        let open = fate.is_none();
        self.fates[member - self.first] = fate;
        open
    }

    fn watch(&mut self, stepped: &Stepped<S>) -> u32 {
        let lanes = self.gate.ask(&*self.chase.field, stepped);
        let mut over = 0;
        for lane in (0..S::LANES).filter(|lane| lanes >> lane & 1 == 1) {
            let Some(member) = stepped.members[lane] else { continue };
            let place = member - self.first;
            if self.rest[place][0] > 0 {
                self.rest[place][0] -= 1;
                continue;
            }
            let y: Vec<f64> = stepped.y.iter().map(|y| y.lanes()[lane]).collect();
            let judge = self.chase.judge;
            let verdict = if judge.strobes() {
                judge.has_escaped(&y).then_some(Verdict::Escaped)
            } else {
                judge.look(&y)
            };
            if let Some(verdict) = verdict {
                self.fates[place] = Some(Fate::Judged(verdict, stepped.t.lanes()[lane], y));
                over |= 1 << lane;
            } else {
                let longer = self.rest[place][1];
                self.rest[place] = [longer, if 2 * longer < MOST_REST { 2 * longer } else { MOST_REST }];
            }
        }
        over
    }
}
