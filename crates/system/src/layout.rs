//! Which numbers make a state, in which order.

use crate::{Card, Coordinates, Event, Held, Observable, Quantity, Shape};

/// The quantities of a system once the lengths of its lists are known.
#[derive(Clone, Debug, PartialEq)]
pub struct Layout {
    /// Coordinates in order.
    pub coordinates: Coordinates,
    /// Observables in order.
    pub observables: Vec<Observable>,
    /// Events in order.
    pub events: Vec<Event>,
    /// Number of modes.
    pub modes: usize,
    /// What the first modes hold, see [`Card::held`].
    pub held: Vec<Held>,
}

impl Layout {
    /// The layout of a system whose card says everything.
    pub fn of(card: &Card) -> Self {
        Self {
            coordinates: card.coordinates.clone().into(),
            observables: card.observables.clone(),
            events: card.events.clone(),
            modes: card.modes,
            held: card.held.clone(),
        }
    }
    /// The sizes alone.
    pub fn shape(&self) -> Shape {
        Shape {
            coordinates: self.coordinates.len(),
            second: self.coordinates.second().clone(),
            attitudes: self.coordinates.attitudes().to_vec(),
            modes: self.modes,
            observables: self.observables.len(),
            events: self.events.len(),
            rows: 1,
        }
    }
    /// Numbers of the state: coordinates and velocities.
    pub fn state_size(&self) -> usize {
        let coordinates = self.coordinates.len();
        coordinates + self.coordinates.second().count(coordinates)
    }
    /// The quantity that stands at number `j` of the state.
    pub fn quantity(&self, j: usize) -> Quantity {
        match j.checked_sub(self.coordinates.len()) {
            None => self.coordinates.quantity(j),
            Some(k) => self.coordinates.velocity(k),
        }
    }
    /// The quantities of the state in order, one after another: coordinates, then velocities.
    pub fn quantities(&self) -> impl Iterator<Item = Quantity> + '_ {
        (0..self.state_size()).map(|j| self.quantity(j))
    }
    /// All of them at once.
    pub fn state(&self) -> Vec<Quantity> {
        self.quantities().collect()
    }
    /// All that a start may be given by: the state, and what the modes hold.
    pub fn starts(&self) -> impl Iterator<Item = Quantity> + '_ {
        self.quantities().chain(self.held.iter().map(|held| held.quantity.clone()))
    }
    /// The state at the start, as the card has it (modes that hold no start are zero until the system sets them).
    pub fn start(&self) -> Vec<f64> {
        let held = self.held.iter().map(|held| held.start);
        let modes = held.chain(std::iter::repeat(0.0)).take(self.modes);
        let mut start = Vec::with_capacity(self.shape().full());
        start.extend(self.coordinates.starts().chain(self.coordinates.start_velocities()).chain(modes));
        start
    }
}
