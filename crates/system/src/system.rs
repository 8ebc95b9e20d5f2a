//! A mechanical system: its card and its equations.

use crate::{Card, Layout, State, Values};
use precess_scalar::Scalar;

/// The starts that a user has given, by name.
#[derive(Clone, Debug, Default)]
pub struct Given(pub Vec<(String, f64)>);

impl Given {
    /// The value given for a name.
    pub fn get(&self, name: &str) -> Option<f64> {
        self.0.iter().find(|(n, _)| n == name).map(|(_, x)| *x)
    }
}

/// Equal parts of a system that feel the rest, and move neither it nor one another.
#[derive(Clone, Debug, PartialEq)]
pub struct Satellites {
    /// The coordinates of the rest, which come first; all coordinates are of second order.
    pub rest: usize,
    /// The coordinates of a part.
    pub each: usize,
    /// The parameters of the rest with the parts that were asked for.
    pub values: Values<f64>,
}

/// A mechanical system, written once for every number.
pub trait System: Clone + Send + Sync + 'static {
    /// Names, units, defaults, texts, source.
    fn card(&self) -> Card;

    /// The highest derivative of each coordinate, in order: the acceleration of a second-order coordinate,
    /// the rate of a first-order one.
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]);

    /// The rates of the modes: all rest, where nothing else is said.
    #[inline(always)]
    fn mode_rates<S: Scalar>(&self, _s: &State<S>, rates: &mut [S]) {
        rates.fill(S::from(0.0));
    }

    /// The observables, in the order of the card.
    fn observe<S: Scalar>(&self, _s: &State<S>, _out: &mut [S]) {}

    /// The Lagrangian, where there is one: the laws hold the equations against it (with the parameters that
    /// the energy's condition names set to zero).
    fn lagrangian<S: Scalar>(&self, _s: &State<S>) -> Option<S> {
        None
    }

    /// Whether the motion from this start has a closed form: [`solution`](Self::solution).
    ///
    /// # Errors
    /// One sentence: why it has none.
    fn solvable(&self, _start: &State<f64>) -> Result<(), String> {
        Err("no closed form of its motion is known here".into())
    }

    /// The closed form: coordinates `q` and velocities `v` at time `t`, from the state `start` at the time `start.t`,
    /// which may be the later one. Asked of solvable systems only.
    fn solution<S: Scalar>(&self, _start: &State<S>, _t: S, _q: &mut [S], _v: &mut [S]) {}

    /// The accelerations that move the positions in a step of `euler_taylor`, where the program of a source takes others
    /// there than for the velocities; false where it does not.
    fn drift<S: Scalar>(&self, _s: &State<S>, _highest: &mut [S]) -> bool {
        false
    }

    /// Whether parts of the system move nothing else, so that it can be computed with `count` of them at a time.
    fn satellites(&self, _values: &Values<f64>, _count: usize) -> Option<Satellites> {
        None
    }

    /// What goes on at a state where a run could not go on, if the system knows (a collision): a clause.
    fn trouble(&self, _s: &State<f64>) -> Option<String> {
        None
    }

    /// The event functions, in the order of the card.
    fn crossings<S: Scalar>(&self, _s: &State<S>, _out: &mut [S]) {}

    /// What event number `event` does to the state (coordinates, velocities, modes).
    fn jump<S: Scalar>(&self, _event: usize, _s: &State<S>, _y: &mut [S]) {}

    /// The modes at the start, from the rest of the state; those that hold a start (see [`Card::held`]) are set already.
    fn start_modes(&self, _s: &State<f64>, _modes: &mut [f64]) {}

    /// The period of the equations in time, where time enters and they have one.
    fn period(&self, _values: &Values<f64>) -> Option<f64> {
        None
    }

    /// Coordinates and observables, where they depend on the parameters (the length of a list) or on the
    /// names that the user mentions.
    fn layout(&self, _values: &Values<f64>, _given: &Given) -> Layout {
        Layout::of(&self.card())
    }

    /// Sets the state (coordinates, velocities) from starts given under other names, those of
    /// [`Card::starts`]. The plain names have been set already.
    ///
    /// # Errors
    /// One sentence, where the given starts contradict one another.
    fn start(&self, _given: &Given, _values: &Values<f64>, _y: &mut [f64]) -> Result<(), String> {
        Ok(())
    }

    /// Whether parameters and start make sense together, beyond the range of each.
    ///
    /// # Errors
    /// One sentence: what does not.
    fn check(&self, _s: &State<f64>) -> Result<(), String> {
        Ok(())
    }
}
