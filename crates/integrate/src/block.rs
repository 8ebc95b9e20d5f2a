//! Several trajectories at once, side by side in the lanes of a few registers.
//!
//! With fixed steps all trajectories of a block share the times of their steps, and nothing else: a trajectory has the
//! bits that it has alone. The block then has several rows of registers, and the equations are evaluated for one row
//! after another: a processor begins the next row while the divisions and roots of the last are still under way.

use crate::side_by_side::SideBySide;
use crate::stretch::Stretch;
use crate::{AnyMethod, NoConvergence, Options, Pace, Samples, Step, Stepper, Steps};
use precess_scalar::{Kernel, Lanes};
use precess_system::{Field, Shape};

/// Rows of a block.
const ROWS: usize = 8;

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
    /// The most trajectories that a block holds.
    pub fn capacity(pace: &Pace) -> usize {
        match pace {
            Pace::Fixed(_) => ROWS * S::LANES,
            Pace::Adaptive(_) => S::LANES,
        }
    }

    /// Steps trajectories from their full states, one after another in `starts`, to the end. `record` is given
    /// the number of a sample, that of a trajectory, and its full state. A trajectory that does not arrive in numbers
    /// has a last sample that is not finite, or none.
    ///
    /// # Errors
    /// Where an implicit step does not converge in some lane; the other lanes are then unfinished, too.
    ///
    /// # Panics
    /// Where there are more than [`capacity`](Self::capacity) trajectories, or none.
    pub fn run(
        &self,
        starts: &[f64],
        record: &mut dyn FnMut(u64, usize, &[f64]),
    ) -> Result<(), NoConvergence> {
        let full = self.field.shape().full();
        let count = starts.len() / full;
        let most = Self::capacity(self.pace);
        assert!((1..=most).contains(&count), "{count} trajectories, not 1 to {most}");
        let shape = self.field.shape().with_rows(count.div_ceil(S::LANES));
        // Lanes that are left over repeat the last trajectory.
        let start = |row: usize, lane: usize, i: usize| {
            let trajectory = row * S::LANES + lane;
            starts[(if trajectory < count { trajectory } else { count - 1 }) * full + i]
        };
        let mut y = vec![S::from(0.0); shape.size()];
        for row in 0..shape.rows {
            for j in 0..full {
                y[shape.place(row, j)] = S::from_lanes(|lane| start(row, lane, j));
            }
        }
        let mut stepper = Steps::<S>::stepper(self.method, &shape, &self.options);
        let (field, stepper, samples) = (self.field, &mut *stepper, self.samples);
        match self.pace {
            Pace::Fixed(dt) => self.fixed(*dt, &shape, stepper, y, count, record),
            Pace::Adaptive(tolerance) => {
                for (trajectory, start) in starts.chunks(full).enumerate() {
                    record(0, trajectory, start);
                }
                let order = self.method.card().order;
                S::enter(SideBySide { field, stepper, tolerance, samples, order, y, count, record })
            }
        }
    }

    fn fixed(
        &self,
        dt: f64,
        shape: &Shape,
        stepper: &mut dyn Stepper<S>,
        mut y: Vec<S>,
        count: usize,
        record: &mut dyn FnMut(u64, usize, &[f64]),
    ) -> Result<(), NoConvergence> {
        let mut next = y.clone();
        let mut state = vec![0.0; shape.full()];
        let mut tell = |sample: u64, y: &[S]| {
            for trajectory in 0..count {
                for (j, x) in state.iter_mut().enumerate() {
                    *x = y[shape.place(trajectory / S::LANES, j)].lanes()[trajectory % S::LANES];
                }
                record(sample, trajectory, &state);
            }
        };
        tell(0, &y);
        for sample in 1..=self.samples.last() {
            let (from, to) = (self.samples.time(sample - 1), self.samples.time(sample));
            let steps = Stretch::new(from, to, if to < from { -dt } else { dt });
            let (field, stepper, y, next) = (self.field, &mut *stepper, &mut y, &mut next);
            S::enter(Advance { field, stepper, steps, from, y, next })?;
            tell(sample, y);
        }
        Ok(())
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
