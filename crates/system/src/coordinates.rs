//! The coordinates of a system in order.

use crate::coordinate::rate;
use crate::{Coordinate, Order, Quantity, Second};
use std::fmt::Debug;
use std::sync::Arc;

/// Coordinates of second order that are made when somebody asks for one: the names and texts of a million would take far more
/// memory than their motion.
pub trait Swarm: Debug + Send + Sync {
    /// How many.
    fn size(&self) -> usize;
    /// Name, unit, meaning of number `k`.
    fn quantity(&self, k: usize) -> Quantity;
    /// Where number `k` starts, and how fast.
    fn start(&self, k: usize) -> [f64; 2];
}

/// Those that are written out, then those of a swarm, if there is one.
#[derive(Clone, Debug)]
pub struct Coordinates {
    written: Vec<Coordinate>,
    swarm: Option<Arc<dyn Swarm>>,
    second: Second,
    attitudes: Vec<usize>,
}

impl From<Vec<Coordinate>> for Coordinates {
    fn from(written: Vec<Coordinate>) -> Self {
        let second = Second::of(written.iter().map(|c| c.order == Order::Second));
        let attitudes = (0..written.len()).filter(|&i| written[i].begins_attitude).collect();
        Self { written, swarm: None, second, attitudes }
    }
}

impl PartialEq for Coordinates {
    fn eq(&self, other: &Self) -> bool {
        self.iter().eq(other.iter())
    }
}

impl Coordinates {
    /// Coordinates of second order, followed by a swarm.
    ///
    /// # Panics
    /// Where one of them is of first order.
    pub fn with_swarm(written: Vec<Coordinate>, swarm: impl Swarm + 'static) -> Self {
        let written = Self::from(written);
        assert!(written.second == Second::All, "what a swarm follows is of second order");
        Self { swarm: Some(Arc::new(swarm)), ..written }
    }
    /// Adds one behind those that are written out.
    ///
    /// # Panics
    /// Where a swarm follows them.
    pub fn push(&mut self, coordinate: Coordinate) {
        assert!(self.swarm.is_none(), "nothing comes behind a swarm");
        self.written.push(coordinate);
        *self = std::mem::take(&mut self.written).into();
    }
    /// How many.
    pub fn len(&self) -> usize {
        self.written.len() + self.swarm.as_ref().map_or(0, |swarm| swarm.size())
    }
    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
    /// Which have a velocity.
    pub fn second(&self) -> &Second {
        &self.second
    }
    /// At which of them an attitude begins.
    pub fn attitudes(&self) -> &[usize] {
        &self.attitudes
    }
    /// All, one after another.
    pub fn iter(&self) -> impl Iterator<Item = Coordinate> + '_ {
        let swarm = self.swarm.iter().flat_map(|swarm| {
            (0..swarm.size()).map(|k| {
                let [start, start_dot] = swarm.start(k);
                Coordinate {
                    quantity: swarm.quantity(k),
                    order: Order::Second,
                    start,
                    start_dot,
                    begins_attitude: false,
                }
            })
        });
        self.written.iter().cloned().chain(swarm)
    }
    /// Name, unit, meaning of one.
    pub fn quantity(&self, i: usize) -> Quantity {
        match (i.checked_sub(self.written.len()), &self.swarm) {
            (Some(k), Some(swarm)) => swarm.quantity(k),
            _ => self.written[i].quantity.clone(),
        }
    }
    /// Velocity number `k` as a quantity.
    pub fn velocity(&self, k: usize) -> Quantity {
        rate(&self.quantity(self.second.coordinate(k)))
    }
    /// Where all start.
    pub fn starts(&self) -> impl Iterator<Item = f64> + '_ {
        let swarm = self.swarm.iter().flat_map(|swarm| (0..swarm.size()).map(|k| swarm.start(k)[0]));
        self.written.iter().map(|c| c.start).chain(swarm)
    }
    /// How fast those start that have a velocity.
    pub fn start_velocities(&self) -> impl Iterator<Item = f64> + '_ {
        let swarm = self.swarm.iter().flat_map(|swarm| (0..swarm.size()).map(|k| swarm.start(k)[1]));
        self.written.iter().filter(|c| c.order == Order::Second).map(|c| c.start_dot).chain(swarm)
    }
}
