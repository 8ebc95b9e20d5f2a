//! Adaptive steps for several trajectories at once: each lane has its own time, its own step and its own samples.
//!
//! A lane whose step is too long tries again while the others go on, and one whose trajectory is over takes the next
//! start of the roster; where there is none, it idles with steps of no length. No lane sees another: a trajectory has
//! the bits that it has alone.

use crate::pacer::{Pacer, first_step};
use crate::roster::{Roster, Stepped};
use crate::{NoConvergence, Samples, Step, Stepper, Tolerance};
use precess_scalar::{Kernel, Lanes};
use precess_system::{Field, Shape};

/// A trajectory of more attempts than this is left to a run of its own, which knows when to give up.
const MOST_ATTEMPTS: u64 = 1 << 24;
/// Attempts between two looks at who has made too many.
const BETWEEN_LOOKS: u64 = 1 << 16;

/// A register of trajectories on their way. Those that do not arrive record no last sample.
pub(crate) struct SideBySide<'a, 'r, S: Lanes> {
    pub field: &'a dyn Field<S>,
    pub stepper: &'a mut dyn Stepper<S>,
    pub tolerance: &'a Tolerance,
    pub samples: Samples,
    pub order: u32,
    pub roster: &'r mut dyn Roster<S>,
}

/// Where the lanes are.
struct Places<S: Lanes> {
    /// The member in each lane.
    members: Vec<Option<usize>>,
    /// Bit i tells whether there is one.
    busy: u32,
    /// The next sample of each.
    due: Vec<u64>,
    /// The number of its first attempt.
    begun: Vec<u64>,
    t: S,
    y: Vec<S>,
    pacer: Pacer<S>,
    /// A state of one lane.
    single: Vec<f64>,
}

impl<S: Lanes> Kernel for SideBySide<'_, '_, S> {
    type Output = Result<(), NoConvergence>;

    #[inline(always)]
    fn run(mut self) -> Self::Output {
        let until = self.samples.time(self.samples.last());
        let end_of_run = S::from(until);
        let mut at = Places::new(self.field.shape(), self.order, end_of_run);
        let (mut next, mut weights) = (at.y.clone(), at.y.clone());
        // The lanes whose trajectories are over: at first all, so that each takes a start.
        let mut over = u32::MAX;
        let mut attempts = 0;
        loop {
            if over != 0 {
                self.refill(&mut at, over, attempts, until);
                if at.busy == 0 {
                    return Ok(());
                }
            }
            let (h, end) = at.pacer.next(at.t, end_of_run);
            // Arrived, or unable to move.
            over = S::truth(at.t.equals(end_of_run) | end.equals(at.t)) & at.busy;
            if over != 0 {
                continue;
            }
            self.stepper.step(&mut Step { field: self.field, t: at.t, y: &at.y, h, out: &mut next })?;
            self.tolerance.weights(&at.y, &next, &mut weights);
            let error = S::select(finite(&next), self.stepper.error(h, &weights), S::from(f64::NAN));
            let accepted = at.pacer.judge(h, error);
            let bits = S::truth(accepted) & at.busy;
            over = self.sample(&mut at, bits, (h, end), &next);
            self.stepper.accept(accepted);
            for (y, next) in at.y.iter_mut().zip(&next) {
                *y = S::select(accepted, *next, *y);
            }
            at.t = S::select(accepted, end, at.t);
            over |= self.roster.watch(&Stepped { members: &at.members, accepted: bits, t: &at.t, y: &at.y });
            attempts += 1;
            if attempts % BETWEEN_LOOKS == 0 {
                over |= at.lanes(|lane| attempts - at.begun[lane] > MOST_ATTEMPTS);
            }
            over &= at.busy;
        }
    }
}

/// Where every number is finite.
#[inline(always)]
fn finite<S: Lanes>(y: &[S]) -> S::Mask {
    y.iter().fold(S::always(), |all, x| all & x.abs().below(f64::INFINITY))
}

/// The mask of these bits.
#[inline(always)]
fn mask<S: Lanes>(bits: u32) -> S::Mask {
    S::from_lanes(|lane| f64::from(bits >> lane & 1)).above(0.5)
}

impl<S: Lanes> Places<S> {
    /// Nobody anywhere.
    #[inline(always)]
    fn new(shape: &Shape, order: u32, end_of_run: S) -> Self {
        let zeros = vec![S::from(0.0); shape.full()];
        Self {
            members: vec![None; S::LANES],
            busy: 0,
            due: vec![0; S::LANES],
            begun: vec![0; S::LANES],
            t: end_of_run,
            single: vec![0.0; zeros.len()],
            y: zeros,
            pacer: Pacer::new(order, S::from(0.0)),
        }
    }

    /// The lanes of which something holds.
    #[inline(always)]
    fn lanes(&self, holds: impl Fn(usize) -> bool) -> u32 {
        (0..self.members.len()).filter(|&lane| holds(lane)).fold(0, |bits, lane| bits | 1 << lane)
    }
}

impl<S: Lanes> SideBySide<'_, '_, S> {
    /// Gives the next starts to lanes whose trajectories are over.
    #[inline(always)]
    fn refill(&mut self, at: &mut Places<S>, over: u32, attempts: u64, until: f64) {
        let (mut fresh, first) = (0, self.samples.first());
        for lane in (0..S::LANES).filter(|lane| over >> lane & 1 == 1) {
            at.members[lane] = None;
            while let Some(member) = self.roster.next(&mut at.single) {
                if !self.roster.sample(first, member, &at.single) {
                    continue;
                }
                at.members[lane] = Some(member);
                (at.due[lane], at.begun[lane]) = (first + 1, attempts);
                for (y, x) in at.y.iter_mut().zip(&at.single) {
                    y.lanes_mut()[lane] = *x;
                }
                fresh |= 1 << lane;
                break;
            }
        }
        at.busy = at.lanes(|lane| at.members[lane].is_some());
        // Who idles has arrived.
        at.t = S::select(mask::<S>(at.busy), at.t, S::from(until));
        if fresh != 0 {
            let fresh = mask::<S>(fresh);
            at.t = S::select(fresh, S::from(self.samples.time(first)), at.t);
            let first = first_step(self.field, self.tolerance, self.order, &at.y, until);
            at.pacer.begin(fresh, first);
            self.stepper.begin(fresh);
        }
    }

    /// Records the samples that accepted steps have passed, each lane its own; gives the lanes that need go no further.
    #[inline(always)]
    fn sample(&mut self, at: &mut Places<S>, accepted: u32, (h, end): (S, S), next: &[S]) -> u32 {
        let samples = self.samples;
        let backwards = samples.time(samples.last()) < 0.0;
        let is_due = |due: &[u64], lane: usize| {
            let (time, end) = (samples.time(due[lane]), end.lanes()[lane]);
            accepted >> lane & 1 == 1
                && due[lane] <= samples.last()
                && if backwards { time >= end } else { time <= end }
        };
        if !(0..S::LANES).any(|lane| is_due(&at.due, lane)) {
            return 0;
        }
        let dense = self.stepper.dense(self.field, at.t, &at.y, h, next).ending(end);
        let mut states = next.to_vec();
        let mut over = 0;
        let waits = |due: &[u64], over: u32, lane: usize| over >> lane & 1 == 0 && is_due(due, lane);
        while (0..S::LANES).any(|lane| waits(&at.due, over, lane)) {
            dense.at(S::from_lanes(|lane| samples.time(at.due[lane])), &mut states);
            for lane in 0..S::LANES {
                let Some(member) = at.members[lane].filter(|_| waits(&at.due, over, lane)) else { continue };
                for (x, lanes) in at.single.iter_mut().zip(&states) {
                    *x = lanes.lanes()[lane];
                }
                if !self.roster.sample(at.due[lane], member, &at.single) {
                    over |= 1 << lane;
                }
                at.due[lane] += 1;
            }
        }
        over
    }
}
