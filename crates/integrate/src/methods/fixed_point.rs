//! What the methods that solve a step by a loop have in common.

use crate::OptionCard;
use precess_scalar::Scalar;
use precess_system::Shape;

/// A fixed point that converges at all is there long before.
pub(super) const MOST_ITERATIONS: u32 = 200;

/// This far below the tolerance a change is no longer looked at.
pub(super) const FAR_BELOW: f64 = 1e-4;

/// The option that ends the loop.
pub(super) const EPSILON: OptionCard = OptionCard {
    name: "epsilon",
    default: 1e-12,
    low: 1e-15,
    high: 1.0,
    text: ("where the loop ends, relative to the state", "fin de la boucle, relative à l'état"),
};

/// The same option where the loop goes on below its end, as long as it comes closer.
pub(super) const EPSILON_AT_LEAST: OptionCard = OptionCard {
    text: ("where the loop may end, relative to the state", "fin possible de la boucle, relative à l'état"),
    ..EPSILON
};

/// A change relative to the state, from the squares of both, a pair a row.
pub(super) fn relative<S: Scalar>(change: &[S], size: &[S]) -> S {
    let sum = |squares: &[S]| squares.iter().fold(S::from(0.0), |sum, square| sum + *square);
    (sum(change) / sum(size)).sqrt()
}

/// Watches a loop come to rest, row by row: below the tolerance, and no closer than it was `BACK` times ago.
pub(super) struct Settling<S: Scalar, const BACK: usize> {
    /// A lane that rests is frozen, so that its bits do not depend on its neighbours; a mask a row.
    moving: Vec<S::Mask>,
    /// The square of the last change, the changes before, the latest first, and the square of the state; each a row.
    change: Vec<S>,
    before: [Vec<S>; BACK],
    size: Vec<S>,
    row: Vec<usize>,
    epsilon: f64,
    far_below: f64,
}

impl<S: Scalar, const BACK: usize> Settling<S, BACK> {
    pub fn new(shape: &Shape, epsilon: f64) -> Self {
        let zeros = vec![S::from(0.0); shape.rows];
        Self {
            moving: vec![S::always(); shape.rows],
            change: zeros.clone(),
            before: [(); BACK].map(|()| zeros.clone()),
            size: zeros,
            row: shape.row_of_each(),
            epsilon,
            far_below: FAR_BELOW,
        }
    }

    /// The loop goes on as long as it comes closer, however close: what is left out of every step alike adds up.
    pub fn exhaustive(self) -> Self {
        Self { far_below: 0.0, ..self }
    }

    /// A step begins at a state.
    #[inline(always)]
    pub fn begin(&mut self, y: &[S]) {
        self.moving.fill(S::always());
        for before in &mut self.before {
            before.fill(S::from(f64::INFINITY));
        }
        self.size.fill(S::from(1.0));
        for (x, &row) in y.iter().zip(&self.row) {
            self.size[row] = self.size[row] + x.squared();
        }
    }

    /// An iteration begins.
    #[inline(always)]
    pub fn iterate(&mut self) {
        self.change.fill(S::from(0.0));
    }

    /// The row of the number at place `i`.
    #[inline(always)]
    pub fn row(&self, i: usize) -> usize {
        self.row[i]
    }

    /// Which rows still move.
    #[inline(always)]
    pub fn moving(&self) -> &[S::Mask] {
        &self.moving
    }

    /// A row has changed by what has this square.
    #[inline(always)]
    pub fn add(&mut self, row: usize, square: S) {
        self.change[row] = self.change[row] + square;
    }

    /// The last change of all rows together, relative to their sizes.
    pub fn residual(&self) -> S {
        relative(&self.before[0].iter().map(|change| change.squared()).collect::<Vec<_>>(), &self.size)
    }

    /// The iteration ends; whether everything rests.
    #[inline(always)]
    pub fn rests(&mut self) -> bool {
        let mut rest = true;
        for row in 0..self.moving.len() {
            let (change, size) = (self.change[row].sqrt(), self.size[row].sqrt() * self.epsilon);
            let stays = self.before[BACK - 1][row].le(change) & change.le(size);
            self.moving[row] = self.moving[row] & !(stays | change.le(size * self.far_below));
            rest &= S::all(!self.moving[row]);
            let mut newest = change;
            for before in &mut self.before {
                newest = std::mem::replace(&mut before[row], newest);
            }
        }
        rest
    }
}
