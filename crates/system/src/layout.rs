//! Which numbers make a state, in which order.

use crate::quantity::{Quantity, Range, dotted, quantity};
use crate::{Card, Event, Held, Observable};

/// How often a coordinate is differentiated in its equation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// The equation gives its rate.
    First,
    /// The equation gives its acceleration; its velocity is part of the state.
    Second,
}

/// One coordinate of a system.
#[derive(Clone, Debug, PartialEq)]
pub struct Coordinate {
    /// Name, unit, meaning.
    pub quantity: Quantity,
    /// First or second order.
    pub order: Order,
    /// Value at the start.
    pub start: f64,
    /// Velocity at the start (second order only).
    pub start_dot: f64,
    /// It and the next three are a unit quaternion that turns body axes into space.
    pub begins_attitude: bool,
}

/// A second-order coordinate that starts at rest at zero.
pub fn coordinate(name: &str, unit: &str, en: &str, fr: &str) -> Coordinate {
    Coordinate {
        quantity: quantity(name, unit, en, fr),
        order: Order::Second,
        start: 0.0,
        start_dot: 0.0,
        begins_attitude: false,
    }
}

impl Coordinate {
    /// The equation gives the rate, not the acceleration.
    #[must_use]
    pub fn first_order(mut self) -> Self {
        self.order = Order::First;
        self
    }
    /// Where it starts.
    #[must_use]
    pub fn start(mut self, value: f64) -> Self {
        self.start = value;
        self
    }
    /// How fast it starts.
    #[must_use]
    pub fn start_dot(mut self, value: f64) -> Self {
        self.start_dot = value;
        self
    }
    /// It and the next three are a unit quaternion that turns body axes into space.
    #[must_use]
    pub fn begins_attitude(mut self) -> Self {
        self.begins_attitude = true;
        self
    }
    /// Only values of zero and above make sense (a mass of water).
    #[must_use]
    pub fn not_negative(mut self) -> Self {
        self.quantity.range = Range { low: 0.0, high: f64::INFINITY, open: false };
        self
    }
    /// A LaTeX symbol other than the one the name suggests.
    #[must_use]
    pub fn symbol(mut self, symbol: &str) -> Self {
        self.quantity.symbol = symbol.into();
        self
    }
    /// Its velocity as a quantity: `theta_dot`, `rad/s`.
    pub fn velocity(&self) -> Quantity {
        let unit = match self.quantity.unit.as_str() {
            "" => String::new(),
            unit => format!("{unit}/s"),
        };
        let mut velocity = quantity(
            &format!("{}_dot", self.quantity.name),
            &unit,
            &format!("rate of: {}", self.quantity.text.en),
            &format!("vitesse de : {}", self.quantity.text.fr),
        );
        velocity.symbol = dotted(&self.quantity.symbol, 1);
        velocity
    }
    /// The left-hand side of its equation, in LaTeX.
    pub fn highest_symbol(&self) -> String {
        dotted(&self.quantity.symbol, if self.order == Order::Second { 2 } else { 1 })
    }
}

/// Sizes of a state: what a method needs to know of a system.
///
/// A state is the coordinates, then the velocities of the second-order ones, then the modes (the discrete part of a hybrid
/// system, which rests between events; and what a system integrates behind the scenes). Several states that are stepped together are rows: first the coordinates of
/// all rows, then all velocities, then all modes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Shape {
    /// Number of coordinates of a row.
    pub coordinates: usize,
    /// For each velocity of a row, the coordinate it belongs to.
    pub second: Vec<usize>,
    /// The coordinates of a row at which a unit quaternion begins (four numbers that turn body axes into space).
    pub attitudes: Vec<usize>,
    /// Number of modes of a row.
    pub modes: usize,
    /// Number of observables.
    pub observables: usize,
    /// Number of event functions.
    pub events: usize,
    /// Number of rows.
    pub rows: usize,
}

impl Shape {
    /// Numbers that are reported as the state: coordinates and velocities.
    pub fn state(&self) -> usize {
        self.coordinates + self.second.len()
    }
    /// Numbers that are integrated: the state and the modes.
    pub fn full(&self) -> usize {
        self.state() + self.modes
    }
    /// Numbers of all rows.
    pub fn size(&self) -> usize {
        self.rows * self.full()
    }
    /// The same system with several states side by side.
    #[must_use]
    pub fn with_rows(&self, rows: usize) -> Self {
        Self { rows, ..self.clone() }
    }
    /// Where number `j` of a row's full state stands.
    pub fn place(&self, row: usize, j: usize) -> usize {
        let (coordinates, state) = (self.coordinates, self.state());
        match j {
            j if j < coordinates => row * coordinates + j,
            j if j < state => self.rows * coordinates + row * self.second.len() + (j - coordinates),
            j => self.rows * state + row * self.modes + (j - state),
        }
    }
    /// Where the numbers of each row's full state stand.
    pub fn places(&self) -> Vec<Vec<usize>> {
        (0..self.rows).map(|row| (0..self.full()).map(|j| self.place(row, j)).collect()).collect()
    }
    /// The row that each number belongs to.
    pub fn row_of_each(&self) -> Vec<usize> {
        let mut row_of_each = vec![0; self.size()];
        for (row, places) in self.places().into_iter().enumerate() {
            for place in places {
                row_of_each[place] = row;
            }
        }
        row_of_each
    }
    /// Pairs of all rows: where a second-order coordinate stands, and where its velocity.
    pub fn pairs(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        let firsts = (0..self.rows).map(|row| row * self.coordinates);
        let coordinates = firsts.flat_map(|first| self.second.iter().map(move |&i| first + i));
        coordinates.zip(self.rows * self.coordinates..)
    }
    /// What is in no pair: first-order coordinates, and modes.
    pub fn singles(&self) -> impl Iterator<Item = usize> + '_ {
        let first_order = (0..self.coordinates).filter(|i| self.second.binary_search(i).is_err());
        let of_row: Vec<usize> = first_order.chain(self.state()..self.full()).collect();
        (0..self.rows).flat_map(move |row| of_row.clone().into_iter().map(move |j| self.place(row, j)))
    }
    /// Whether every coordinate has a velocity.
    pub fn is_second_order(&self) -> bool {
        self.second.len() == self.coordinates
    }
}

/// The quantities of a system once the lengths of its lists are known.
#[derive(Clone, Debug, PartialEq)]
pub struct Layout {
    /// Coordinates in order.
    pub coordinates: Vec<Coordinate>,
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
            coordinates: card.coordinates.clone(),
            observables: card.observables.clone(),
            events: card.events.clone(),
            modes: card.modes,
            held: card.held.clone(),
        }
    }
    /// The sizes alone.
    pub fn shape(&self) -> Shape {
        let second = self.coordinates.iter().enumerate().filter(|(_, c)| c.order == Order::Second);
        Shape {
            coordinates: self.coordinates.len(),
            second: second.map(|(i, _)| i).collect(),
            attitudes: (0..self.coordinates.len()).filter(|&i| self.coordinates[i].begins_attitude).collect(),
            modes: self.modes,
            observables: self.observables.len(),
            events: self.events.len(),
            rows: 1,
        }
    }
    /// The quantities of the state in order: coordinates, then velocities.
    pub fn state(&self) -> Vec<Quantity> {
        let second = self.coordinates.iter().filter(|c| c.order == Order::Second);
        let velocities = second.map(Coordinate::velocity);
        self.coordinates.iter().map(|c| c.quantity.clone()).chain(velocities).collect()
    }
    /// All that a start may be given by: the state, and what the modes hold.
    pub fn starts(&self) -> Vec<Quantity> {
        self.state().into_iter().chain(self.held.iter().map(|held| held.quantity.clone())).collect()
    }
    /// The state at the start, as the card has it (modes that hold no start are zero until the system sets them).
    pub fn start(&self) -> Vec<f64> {
        let second = self.coordinates.iter().filter(|c| c.order == Order::Second);
        let velocities = second.map(|c| c.start_dot);
        let held = self.held.iter().map(|held| held.start);
        let modes = held.chain(std::iter::repeat(0.0)).take(self.modes);
        self.coordinates.iter().map(|c| c.start).chain(velocities).chain(modes).collect()
    }
}
