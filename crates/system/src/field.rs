//! The seam where a system's type is forgotten and the number's is kept.

use crate::bound::Bound;
use crate::{Layout, Shape, System, Values};
use precess_scalar::Scalar;

/// A system with its parameters, as a first-order field over one kind of number. What is equations alone has a shape and
/// rates, and leaves the rest.
///
/// `y` is the full state of [`Shape`]: coordinates, velocities, modes.
pub trait Field<S: Scalar>: Send + Sync {
    /// The sizes of a state.
    fn shape(&self) -> &Shape;
    /// The rate of every number of the state. There may be several rows of states (see [`Shape`]).
    fn rate(&self, t: S, y: &[S], dy: &mut [S]);
    /// The observables.
    fn observe(&self, _t: S, _y: &[S], _out: &mut [S]) {}
    /// The Lagrangian, where there is one.
    fn lagrangian(&self, _t: S, _y: &[S]) -> Option<S> {
        None
    }
    /// The closed form: the full state at time `t` from the one at time `from`, where the system is solvable. There may
    /// be several rows.
    fn solution(&self, _from: S, _start: &[S], _t: S, _y: &mut [S]) {}
    /// The accelerations of [`System::drift`], in the places of the velocities, and whether there are any. There may be
    /// several rows.
    fn drift(&self, _t: S, _y: &[S], _dy: &mut [S]) -> bool {
        false
    }
    /// The event functions.
    fn crossings(&self, _t: S, _y: &[S], _out: &mut [S]) {}
    /// Applies an event to the state.
    fn jump(&self, _event: usize, _t: S, _y: &mut [S]) {}
    /// The same field over several of its numbers at once, where this machine has lanes for them.
    fn abreast(&self) -> Option<&dyn Field<S::Abreast>> {
        None
    }
}

/// Makes a field over one kind of number.
pub trait Bind<S: Scalar> {
    /// The system with these parameters; `layout` is the one that [`AnySystem::layout`](crate::AnySystem::layout) gave for them.
    fn bind(&self, values: Values<S>, layout: &Layout) -> Box<dyn Field<S>>;
}

impl<M: System, S: Scalar> Bind<S> for M {
    fn bind(&self, values: Values<S>, layout: &Layout) -> Box<dyn Field<S>> {
        Box::new(Bound::new(self.clone(), values, layout))
    }
}

/// Evaluates a system's equations once: all that is asked of numbers that look at equations (what they depend on, how
/// they are written) instead of computing with them. A whole [`Field`] of each would be compiled for nothing.
pub trait Rates<S: Scalar> {
    /// The rates of a full state, and the event functions there.
    fn rates(&self, values: Values<S>, layout: &Layout, t: S, y: &[S]) -> (Vec<S>, Vec<S>);
    /// The Lagrangian, where there is one.
    fn lagrangian(&self, values: Values<S>, layout: &Layout, t: S, y: &[S]) -> Option<S>;
}

impl<M: System, S: Scalar> Rates<S> for M {
    fn rates(&self, values: Values<S>, layout: &Layout, t: S, y: &[S]) -> (Vec<S>, Vec<S>) {
        let bound = Bound::new(self.clone(), values, layout);
        let mut rates = vec![S::from(0.0); y.len()];
        bound.rates(t, y, &mut rates);
        let mut crossings = vec![S::from(0.0); bound.shape.events];
        self.crossings(&bound.state(t, y), &mut crossings);
        (rates, crossings)
    }

    fn lagrangian(&self, values: Values<S>, layout: &Layout, t: S, y: &[S]) -> Option<S> {
        if cfg!(feature = "first") {
            return None;
        }
        let bound = Bound::new(self.clone(), values, layout);
        System::lagrangian(self, &bound.state(t, y))
    }
}

/// Observes a state once, on a number that no method integrates with.
#[cfg(feature = "tangents")]
pub trait Observes<S: Scalar> {
    /// The observables of a full state.
    fn observed(&self, values: Values<S>, layout: &Layout, t: S, y: &[S]) -> Vec<S>;
}

#[cfg(feature = "tangents")]
impl<M: System, S: Scalar> Observes<S> for M {
    fn observed(&self, values: Values<S>, layout: &Layout, t: S, y: &[S]) -> Vec<S> {
        let bound = Bound::new(self.clone(), values, layout);
        let mut out = vec![S::from(0.0); bound.shape.observables];
        self.observe(&bound.state(t, y), &mut out);
        out
    }
}
