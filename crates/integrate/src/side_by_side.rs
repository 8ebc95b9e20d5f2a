//! Adaptive steps for several trajectories at once: each lane has its own time, its own step and its own samples.
//!
//! A lane whose step is too long tries again while the others go on, and one that has reached the end idles with steps
//! of no length. No lane sees another: a trajectory has the bits that it has alone.

use crate::pacer::{Pacer, first_step};
use crate::{NoConvergence, Samples, Step, Stepper, Tolerance};
use precess_scalar::{Kernel, Lanes};
use precess_system::Field;

/// More attempts than this for one block are left to runs of their own, which know when to give up.
const MOST_ATTEMPTS: u64 = 1 << 24;

/// A register of trajectories on their way. Those that do not arrive record no last sample.
pub(crate) struct SideBySide<'a, 'r, S: Lanes> {
    pub field: &'a dyn Field<S>,
    pub stepper: &'a mut dyn Stepper<S>,
    pub tolerance: &'a Tolerance,
    pub samples: Samples,
    pub order: u32,
    pub y: Vec<S>,
    /// The lanes that hold a trajectory.
    pub count: usize,
    /// Told the number of a sample, the lane, and the state.
    pub record: &'r mut dyn FnMut(u64, usize, &[f64]),
}

impl<S: Lanes> Kernel for SideBySide<'_, '_, S> {
    type Output = Result<(), NoConvergence>;

    #[inline(always)]
    fn run(mut self) -> Self::Output {
        let last = self.samples.last();
        let until = self.samples.time(last);
        let end_of_run = S::from(until);
        let mut due = vec![1; self.count];
        let (mut next, mut weights) = (self.y.clone(), self.y.clone());
        let mut t = S::from(0.0);
        let first = first_step(self.field, self.tolerance, self.order, &self.y, until);
        let mut pacer = Pacer::new(self.order, first);
        for _ in 0..MOST_ATTEMPTS {
            let (h, end) = pacer.next(t, end_of_run);
            // Who has not arrived and can still move.
            let on_the_way = S::truth(!t.equals(end_of_run) & !end.equals(t));
            if on_the_way & ((1 << self.count) - 1) == 0 {
                break;
            }
            let Self { field, ref y, .. } = self;
            self.stepper.step(&mut Step { field, t, y, h, out: &mut next })?;
            self.tolerance.weights(y, &next, &mut weights);
            let error = S::select(finite(&next), self.stepper.error(h, &weights), S::from(f64::NAN));
            let accepted = pacer.judge(h, error);
            self.sample(&mut due, accepted, (t, h, end), &next);
            self.stepper.accept(accepted);
            for (y, next) in self.y.iter_mut().zip(&next) {
                *y = S::select(accepted, *next, *y);
            }
            t = S::select(accepted, end, t);
        }
        Ok(())
    }
}

/// Where every number is finite.
#[inline(always)]
fn finite<S: Lanes>(y: &[S]) -> S::Mask {
    y.iter().fold(S::always(), |all, x| all & x.abs().below(f64::INFINITY))
}

impl<S: Lanes> SideBySide<'_, '_, S> {
    /// Records the samples that the accepted steps have passed, each lane its own.
    #[inline(always)]
    fn sample(&mut self, due: &mut [u64], accepted: S::Mask, (t, h, end): (S, S, S), next: &[S]) {
        let samples = self.samples;
        let backwards = samples.time(samples.last()) < 0.0;
        let accepted = S::truth(accepted);
        let is_due = |due: &[u64], lane: usize| {
            let (time, end) = (samples.time(due[lane]), end.lanes()[lane]);
            accepted >> lane & 1 == 1
                && due[lane] <= samples.last()
                && if backwards { time >= end } else { time <= end }
        };
        if !(0..due.len()).any(|lane| is_due(due, lane)) {
            return;
        }
        let dense = self.stepper.dense(self.field, t, &self.y, h, next).ending(end);
        let (mut states, mut state) = (vec![S::from(0.0); next.len()], vec![0.0; next.len()]);
        while (0..due.len()).any(|lane| is_due(due, lane)) {
            let time = |lane: usize| samples.time(if lane < due.len() { due[lane] } else { 0 });
            dense.at(S::from_lanes(time), &mut states);
            for lane in 0..due.len() {
                if is_due(due, lane) {
                    for (x, lanes) in state.iter_mut().zip(&states) {
                        *x = lanes.lanes()[lane];
                    }
                    (self.record)(due[lane], lane, &state);
                    due[lane] += 1;
                }
            }
        }
    }
}
