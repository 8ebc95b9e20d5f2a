//! A stepper that works inside [`Scalar::enter`]: with the machine's instructions for its number.

use crate::{Dense, NoConvergence, Step, Stepper};
use precess_scalar::{Kernel, Scalar};
use precess_system::Field;

/// A stepper whose steps are compiled for the instructions of their number.
pub(crate) struct Entered<T>(pub T);

struct Taken<'a, 'b, T, S: Scalar> {
    stepper: &'a mut T,
    step: &'a mut Step<'b, S>,
}

impl<S: Scalar, T: Stepper<S>> Kernel for Taken<'_, '_, T, S> {
    type Output = Result<(), NoConvergence>;
    #[inline(always)]
    fn run(self) -> Self::Output {
        self.stepper.step(self.step)
    }
}

struct Estimate<'a, T, S> {
    stepper: &'a mut T,
    h: &'a S,
    weights: &'a [S],
}

impl<S: Scalar, T: Stepper<S>> Kernel for Estimate<'_, T, S> {
    type Output = S;
    #[inline(always)]
    fn run(self) -> S {
        self.stepper.error(*self.h, self.weights)
    }
}

struct Inside<'a, T, S> {
    stepper: &'a mut T,
    field: &'a dyn Field<S>,
    t: &'a S,
    y: &'a [S],
    h: &'a S,
    end: &'a [S],
}

impl<S: Scalar, T: Stepper<S>> Kernel for Inside<'_, T, S> {
    type Output = Dense<S>;
    #[inline(always)]
    fn run(self) -> Dense<S> {
        self.stepper.dense(self.field, *self.t, self.y, *self.h, self.end)
    }
}

struct Accepted<'a, T, S: Scalar> {
    stepper: &'a mut T,
    accepted: S::Mask,
}

impl<S: Scalar, T: Stepper<S>> Kernel for Accepted<'_, T, S> {
    type Output = ();
    #[inline(always)]
    fn run(self) {
        self.stepper.accept(self.accepted);
    }
}

impl<S: Scalar, T: Stepper<S>> Stepper<S> for Entered<T> {
    fn step(&mut self, step: &mut Step<S>) -> Result<(), NoConvergence> {
        S::enter(Taken { stepper: &mut self.0, step })
    }
    fn error(&mut self, h: S, weights: &[S]) -> S {
        S::enter(Estimate { stepper: &mut self.0, h: &h, weights })
    }
    fn dense(&mut self, field: &dyn Field<S>, t: S, y: &[S], h: S, end: &[S]) -> Dense<S> {
        S::enter(Inside { stepper: &mut self.0, field, t: &t, y, h: &h, end })
    }
    fn accept(&mut self, accepted: S::Mask) {
        S::enter(Accepted::<T, S> { stepper: &mut self.0, accepted });
    }
    fn residual(&self) -> S {
        self.0.residual()
    }
    fn restart(&mut self) {
        self.0.restart();
    }
    fn begin(&mut self, lanes: S::Mask) {
        self.0.begin(lanes);
    }
    fn evaluations(&self) -> u64 {
        self.0.evaluations()
    }
}
