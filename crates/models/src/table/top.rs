//! What all bodies on a table share: a point of the motion, taken apart.
//!
//! A named top fills [`Top`] with its parameters and texts. R is the attitude (body to space); vectors are in body axes
//! unless they say otherwise.

use super::body::{Body, Touch, plus, scaled};
use super::form::Form;
use super::ground::Ground;
use crate::attitude;
use crate::rotation::{Quaternion, Vector, dot};
use precess_scalar::Scalar;
use precess_system::{Card, Parameter, State};

/// What a named top differs in from the others.
pub struct Top {
    /// How its parameters make a body.
    pub(super) form: Form,
    /// Id, texts, source.
    pub(super) card: fn() -> Card,
    /// The parameters of its form.
    pub(super) parameters: fn() -> Vec<Parameter>,
    /// Euler angles at the start.
    pub(super) angles: [f64; 3],
    /// Angular velocity at the start, in body axes.
    pub(super) omega: [f64; 3],
    /// Velocity of G along x at the start (sliding only).
    pub(super) speed: f64,
    /// Views and defaults of a run.
    pub(super) run: fn(Card) -> Card,
}

/// A point of the motion.
pub(super) struct Seen<S> {
    pub body: Body<S>,
    pub ground: Ground<S>,
    pub attitude: Quaternion<S>,
    pub omega: Vector<S>,
    /// The table's axes in body axes; the last one is the vertical gamma.
    pub rows: [Vector<S>; 3],
    pub touch: Touch<S>,
    /// The resisting torque.
    pub torque: Vector<S>,
    /// Gravity along x and along the normal.
    pub felt: [S; 2],
}

/// Space's axes in body axes, from a quaternion of any length.
#[inline(always)]
fn axes<S: Scalar>([w, x, y, z]: Quaternion<S>) -> [Vector<S>; 3] {
    let part = S::from(1.0) / (w * w + x * x + y * y + z * z);
    let rows = [
        [w * w + x * x - y * y - z * z, (x * y - w * z) * 2.0, (x * z + w * y) * 2.0],
        [(x * y + w * z) * 2.0, w * w - x * x + y * y - z * z, (y * z - w * x) * 2.0],
        [(x * z - w * y) * 2.0, (y * z + w * x) * 2.0, w * w - x * x - y * y + z * z],
    ];
    [scaled(rows[0], part), scaled(rows[1], part), scaled(rows[2], part)]
}

impl Top {
    /// How many parameters the table takes, after the body's.
    pub const fn of_table(&self) -> usize {
        if matches!(self.form, Form::General) { 6 } else { 3 }
    }

    #[inline(always)]
    pub fn see<S: Scalar>(&self, s: &State<S>) -> Seen<S> {
        let (attitude, omega) = attitude::halves(s);
        let (own, rest) = s.values.numbers.split_at(self.form.count());
        let body = self.form.body(own);
        let shake = (self.form == Form::General).then(|| [rest[3], rest[4], rest[5]]);
        let ground = Ground { g: rest[0], slope: rest[1], damping: rest[2], shake };
        let rows = axes(attitude);
        let touch = body.touch(rows[2], omega);
        let (torque, felt) = (scaled(omega, -ground.damping), ground.felt(s.t));
        Seen { body, ground, attitude, omega, rows, touch, torque, felt }
    }
}

impl<S: Scalar> Seen<S> {
    /// Gravity in body axes.
    #[inline(always)]
    pub fn gravity(&self) -> Vector<S> {
        plus(scaled(self.rows[0], self.felt[0]), scaled(self.rows[2], self.felt[1]))
    }
    /// A vector along the table's axes.
    #[inline(always)]
    pub fn on_table(&self, v: Vector<S>) -> Vector<S> {
        [dot(self.rows[0], v), dot(self.rows[1], v), dot(self.rows[2], v)]
    }
}
