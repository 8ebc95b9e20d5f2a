//! Several trajectories at once, side by side in the lanes of a few registers.
//!
//! With fixed steps all trajectories of a block share the times of their steps, and nothing else: a trajectory has the
//! bits that it has alone. The block then has several rows of registers, and the equations are evaluated for one row
//! after another: a processor begins the next row while the divisions and roots of the last are still under way.

use crate::roster::{Listed, Roster};
use crate::side_by_side::SideBySide;
use crate::stretch::Stretch;
use crate::{AnyMethod, NoConvergence, Options, Pace, Samples, Step, Stepper, Steps};
use precess_scalar::{Kernel, Lanes};
use precess_system::{Field, Shape};

/// Rows of a block, where a state is small.
const ROWS: usize = 8;
/// Bytes that a block's states may take, so that they and what a step needs stay in the cache next to the processor.
const BYTES: usize = 6144;

/// What the trajectories of an ensemble have in common.
pub struct Block<'a, S: Lanes> {
    /// The system, which must have no events: those differ from lane to lane.
    pub field: &'a dyn Field<S>,
    /// The method.
    pub method: &'a (dyn AnyMethod + 'static),
    /// Its options.
    pub options: Options,
    /// When to record.
    pub samples: Samples,
    /// The steps.
    pub pace: &'a Pace,
}

impl<S: Lanes> Block<'_, S>
where
    dyn AnyMethod: Steps<S>,
{
    /// How many trajectories are on their way at a time.
    pub fn capacity(pace: &Pace, shape: &Shape) -> usize {
        match pace {
            Pace::Fixed(_) => (BYTES / (shape.full() * size_of::<S>())).clamp(1, ROWS) * S::LANES,
            Pace::Adaptive(_) => S::LANES,
        }
    }

    /// Steps trajectories from their full states, one after another in `starts`, to the end. `record` is given
    /// the number of a sample, that of a trajectory, and its full state. A trajectory that does not arrive in numbers,
    /// or that an implicit step leaves behind with its neighbours, has a last sample that is not finite, or none.
    pub fn run(&self, starts: &[f64], record: &mut dyn FnMut(u64, usize, &[f64])) {
        let starts = starts.chunks(self.field.shape().full()).enumerate();
        self.feed(&mut Listed { starts, record });
    }

    /// Runs all members of a roster. With adaptive steps a lane that is free takes the next start at once; with fixed
    /// ones the next block begins when the last has ended.
    pub fn feed(&self, roster: &mut dyn Roster<S>) {
        match self.pace {
            Pace::Fixed(dt) => while self.fixed(*dt, roster) {},
            Pace::Adaptive(tolerance) => loop {
                let mut stepper = Steps::<S>::stepper(self.method, self.field.shape(), &self.options);
                let (field, samples, order) = (self.field, self.samples, self.method.card().order);
                let stepper = &mut *stepper;
                if S::enter(SideBySide { field, stepper, tolerance, samples, order, roster }).is_ok() {
                    return;
                }
            },
        }
    }

    /// Runs the next block of fixed steps; false where there was nobody left.
    fn fixed(&self, dt: f64, roster: &mut dyn Roster<S>) -> bool {
        let full = self.field.shape().full();
        let capacity = Self::capacity(self.pace, self.field.shape());
        let (mut members, mut starts, mut start) = (vec![], vec![], vec![0.0; full]);
        while members.len() < capacity {
            let Some(member) = roster.next(&mut start) else { break };
            members.push(member);
            starts.extend_from_slice(&start);
        }
        let shape = self.field.shape().with_rows(members.len().div_ceil(S::LANES));
        let Some(last) = members.len().checked_sub(1) else { return false };
        let mut y = vec![S::from(0.0); shape.size()];
        for row in 0..shape.rows {
            for j in 0..full {
                // Lanes that are left over repeat the last trajectory.
                let trajectory =
                    |lane: usize| if row * S::LANES + lane < last { row * S::LANES + lane } else { last };
                y[shape.place(row, j)] = S::from_lanes(|lane| starts[trajectory(lane) * full + j]);
            }
        }
        let mut stepper = Steps::<S>::stepper(self.method, &shape, &self.options);
        let mut next = y.clone();
        let mut going = vec![true; members.len()];
        let mut tell = |sample: u64, y: &[S]| {
            for (place, going) in going.iter_mut().enumerate().filter(|(_, going)| **going) {
                for (j, x) in start.iter_mut().enumerate() {
                    *x = y[shape.place(place / S::LANES, j)].lanes()[place % S::LANES];
                }
                *going = roster.sample(sample, members[place], &start);
            }
            going.contains(&true)
        };
        let mut going = tell(self.samples.first(), &y);
        for sample in self.samples.first() + 1..=self.samples.last() {
            if !going {
                break;
            }
            let (from, to) = (self.samples.time(sample - 1), self.samples.time(sample));
            let steps = Stretch::new(from, to, if to < from { -dt } else { dt });
            let (field, stepper, y, next) = (self.field, &mut *stepper, &mut y, &mut next);
            if S::enter(Advance { field, stepper, steps, from, y, next }).is_err() {
                break;
            }
            going = tell(sample, y);
        }
        true
    }
}

/// The steps from one sample to the next. The loop is compiled for the registers, too: times and lengths are handed
/// on as whole registers.
struct Advance<'a, S: Lanes> {
    field: &'a dyn Field<S>,
    stepper: &'a mut dyn Stepper<S>,
    steps: Stretch,
    from: f64,
    y: &'a mut Vec<S>,
    next: &'a mut Vec<S>,
}

impl<S: Lanes> Kernel for Advance<'_, S> {
    type Output = Result<(), NoConvergence>;

    #[inline(always)]
    fn run(self) -> Self::Output {
        let Self { field, stepper, steps, from, y, next } = self;
        let mut t = from;
        for (h, end) in steps {
            stepper.step(&mut Step { field, t: S::from(t), y, h: S::from(h), out: next })?;
            stepper.accept(S::always());
            std::mem::swap(y, next);
            t = end;
        }
        Ok(())
    }
}
