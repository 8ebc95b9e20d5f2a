//! What a method is: its card, and a stepper for every number.

use crate::Dense;
use crate::entered::Entered;
#[cfg(feature = "laws")]
use precess_scalar::{DoubleDouble, Dual};
use precess_scalar::{Narrow, Scalar, Tape, Wide, Widest};
use precess_system::{Field, Shape};
use std::fmt;
use std::sync::Arc;

/// How the length of a step is chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// By the user.
    Fixed,
    /// By the estimated error.
    Adaptive,
}

/// What a method needs of a system.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Needs {
    /// Nothing.
    Any,
    /// Accelerations that depend on positions (and time) alone.
    Separable,
    /// A closed form of the motion.
    ClosedForm,
    /// Its equations written down ([`Options::equations`]), without absolute values and choices between cases.
    Expression,
    /// Momenta and forces of its Lagrangian ([`Options::equations`]), and nothing beside them.
    Lagrangian,
}

/// A number that changes a method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OptionCard {
    /// Name.
    pub name: &'static str,
    /// Value where nobody sets it.
    pub default: f64,
    /// Smallest value.
    pub low: f64,
    /// Largest value.
    pub high: f64,
    /// Meaning, in English and French.
    pub text: (&'static str, &'static str),
}

/// All that is known of a method but its formula.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MethodCard {
    /// ASCII identifier, the same in every face.
    pub id: &'static str,
    /// Title, in English and French.
    pub title: (&'static str, &'static str),
    /// What it is good for, in English and French.
    pub about: (&'static str, &'static str),
    /// Order of convergence; 0 for the closed form, whose error does not come from the step.
    pub order: u32,
    /// Fixed or adaptive steps.
    pub kind: Kind,
    /// What it needs of a system.
    pub needs: Needs,
    /// Symplectic on separable Hamiltonian systems.
    pub symplectic: bool,
    /// A step back undoes a step.
    pub reversible: bool,
    /// Book or paper.
    pub source: &'static str,
    /// Its options.
    pub options: &'static [OptionCard],
}

/// The values of the options of all methods, and the equations for those that need them.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// Share of the acceleration in the position step of `euler_taylor`.
    pub alpha: f64,
    /// Where the loop of `newmark` ends.
    pub epsilon: f64,
    /// What a method [`Needs`] beside the field, from time and a full state: the rates of the state (`Expression`), or
    /// momenta, forces and mass matrix (`Lagrangian`).
    pub equations: Option<Arc<Tape>>,
}

impl Default for Options {
    fn default() -> Self {
        Self { alpha: 0.5, epsilon: 1e-12, equations: None }
    }
}

impl Options {
    /// Sets an option by name; an unknown name sets nothing.
    pub fn set(&mut self, name: &str, value: f64) {
        match name {
            "alpha" => self.alpha = value,
            "epsilon" => self.epsilon = value,
            _ => {}
        }
    }
    /// An option by name; NaN where there is none.
    pub fn get(&self, name: &str) -> f64 {
        match name {
            "alpha" => self.alpha,
            "epsilon" => self.epsilon,
            _ => f64::NAN,
        }
    }
}

/// A step that could not be taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoConvergence {
    /// Iterations after which the loop gave up.
    pub iterations: u32,
}

impl fmt::Display for NoConvergence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the loop of the implicit step did not converge in {} iterations", self.iterations)
    }
}
impl std::error::Error for NoConvergence {}

/// A step to be taken.
///
/// It travels by reference: a register that is copied piece by piece on the way cannot be loaded as a whole before
/// the pieces have reached the cache, and no step would begin before the one before has ended.
pub struct Step<'a, S: Scalar> {
    /// The system.
    pub field: &'a dyn Field<S>,
    /// Time at the start.
    pub t: S,
    /// State at the start; all states are full ones (see [`Shape`]).
    pub y: &'a [S],
    /// Length.
    pub h: S,
    /// State at the end.
    pub out: &'a mut [S],
}

/// Takes steps over one kind of number. A step may differ from lane to lane.
pub trait Stepper<S: Scalar>: Send {
    /// Takes a step.
    ///
    /// # Errors
    /// Where an implicit step does not converge.
    fn step(&mut self, step: &mut Step<S>) -> Result<(), NoConvergence>;

    /// The estimated error of the last step, as a root mean square over components weighted by `weights`
    /// (one over the tolerated error; zero for components left out). Zero for methods without an estimate.
    fn error(&mut self, _h: S, _weights: &[S]) -> S {
        S::from(0.0)
    }

    /// The state inside the last step, from (`t`, `y`) to `end`.
    #[inline(always)]
    fn dense(&mut self, field: &dyn Field<S>, t: S, y: &[S], h: S, end: &[S]) -> Dense<S> {
        let mut rates = [vec![S::from(0.0); y.len()], vec![S::from(0.0); y.len()]];
        field.rate(t, y, &mut rates[0]);
        field.rate(t + h, end, &mut rates[1]);
        Dense::hermite(t, h, y, end, &rates[0], &rates[1])
    }

    /// Where the last step is accepted, the next one starts where it ended; elsewhere it is tried again.
    #[inline(always)]
    fn accept(&mut self, _accepted: S::Mask) {}

    /// How much the last iteration of an implicit step changed the state, relative to its size.
    fn residual(&self) -> S {
        S::from(0.0)
    }

    /// The next step starts anywhere.
    fn restart(&mut self) {}

    /// The next step starts anywhere in these lanes, and changes no bit in the others. A stepper that remembers more
    /// than a rate which it can find again has to tell the lanes apart.
    fn begin(&mut self, _lanes: S::Mask) {
        self.restart();
    }

    /// Evaluations of the field so far.
    fn evaluations(&self) -> u64;
}

/// An integration method, written once for every number.
pub trait Method: Sync + 'static {
    /// Its stepper. `step` and `error` are `#[inline(always)]`, so that they are compiled for the instructions of
    /// their number (see [`Kernel`](precess_scalar::Kernel)).
    type Steps<S: Scalar>: Stepper<S> + 'static;

    /// What is known of it.
    fn card(&self) -> &'static MethodCard;
    /// A stepper for states of this shape.
    fn stepper<S: Scalar>(&self, shape: &Shape, options: &Options) -> Self::Steps<S>;
}

/// Makes steppers over one kind of number.
pub trait Steps<S: Scalar> {
    /// See [`Method::stepper`].
    fn stepper(&self, shape: &Shape, options: &Options) -> Box<dyn Stepper<S>>;
}

impl<M: Method, S: Scalar> Steps<S> for M {
    fn stepper(&self, shape: &Shape, options: &Options) -> Box<dyn Stepper<S>> {
        Box::new(Entered(Method::stepper(self, shape, options)))
    }
}

/// The numbers that only the tests of the methods compute with so far: see the feature `laws` of `precess-system`.
#[cfg(feature = "laws")]
pub trait LawNumbers: Steps<DoubleDouble> + Steps<Dual<f64>> {}
/// The numbers of the tests, without the feature `laws`: none.
#[cfg(not(feature = "laws"))]
pub trait LawNumbers {}
impl<M: Method> LawNumbers for M {}

/// A method whose type is forgotten.
pub trait AnyMethod: Sync + LawNumbers + Steps<f64> + Steps<Narrow> + Steps<Wide> + Steps<Widest> {
    /// See [`Method::card`].
    fn card(&self) -> &'static MethodCard;
}

impl<M: Method> AnyMethod for M {
    fn card(&self) -> &'static MethodCard {
        Method::card(self)
    }
}
