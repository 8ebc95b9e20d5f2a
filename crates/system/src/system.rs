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

/// A mechanical system, written once for every number.
pub trait System: Clone + Send + Sync + 'static {
    /// Names, units, defaults, texts, source.
    fn card(&self) -> Card;

    /// The highest derivative of each coordinate, in order: the acceleration of a second-order coordinate,
    /// the rate of a first-order one.
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]);

    /// The observables, in the order of the card.
    fn observe<S: Scalar>(&self, _s: &State<S>, _out: &mut [S]) {}

    /// The Lagrangian, where there is one: the laws hold the equations against it (with the parameters that
    /// the energy's condition names set to zero).
    fn lagrangian<S: Scalar>(&self, _s: &State<S>) -> Option<S> {
        None
    }

    /// The event functions, in the order of the card.
    fn crossings<S: Scalar>(&self, _s: &State<S>, _out: &mut [S]) {}

    /// What event number `event` does to the state (coordinates, velocities, modes).
    fn jump<S: Scalar>(&self, _event: usize, _s: &State<S>, _y: &mut [S]) {}

    /// The modes at the start, from the rest of the state.
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
