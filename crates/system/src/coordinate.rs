//! One coordinate of a system.

use crate::quantity::{Quantity, Range, dotted, quantity};

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
        rate(&self.quantity)
    }
    /// The left-hand side of its equation, in LaTeX.
    pub fn highest_symbol(&self) -> String {
        dotted(&self.quantity.symbol, if self.order == Order::Second { 2 } else { 1 })
    }
}

/// The rate of a quantity.
pub(crate) fn rate(of: &Quantity) -> Quantity {
    let unit = match of.unit.as_str() {
        "" => String::new(),
        unit => format!("{unit}/s"),
    };
    let mut rate = quantity(
        &format!("{}_dot", of.name),
        &unit,
        &format!("rate of: {}", of.text.en),
        &format!("vitesse de : {}", of.text.fr),
    );
    rate.symbol = dotted(&of.symbol, 1);
    rate
}
