//! Tangent vectors: how neighbours of a trajectory move away from it, to first order and exactly.
//!
//!     y' = f(t, y)        v' = Df(t, y) v
//!
//! The derivative along v is the slope of f at the dual number y + v e; where a parameter p moves too, it is
//! Df v + df/dp, the slope at y + v e and p + e. A state and its tangent vectors are rows of
//! one larger state (see [`Shape`]), so every method integrates them as they are.

use crate::matrix::Matrix;
use precess_scalar::Dual;
use precess_system::{Field, Shape};
use std::sync::Mutex;

/// A field with tangent vectors in the rows behind the state.
pub(crate) struct Tangents<'a> {
    /// The system along each vector: its parameters may move with the state.
    fields: &'a [&'a dyn Field<Dual<f64>>],
    shape: Shape,
    /// The integration's zero of time.
    from: f64,
    /// A dual state and its rate.
    scratch: Mutex<[Vec<Dual<f64>>; 2]>,
}

impl<'a> Tangents<'a> {
    /// With a tangent vector for each field; `from` is the time at which the integration begins.
    pub fn new(fields: &'a [&'a dyn Field<Dual<f64>>], from: f64) -> Self {
        let mut shape = fields[0].shape().with_rows(1 + fields.len());
        (shape.observables, shape.events) = (0, 0);
        let blank = vec![Dual::constant(0.0); shape.full()];
        Self { fields, shape, from, scratch: Mutex::new([blank.clone(), blank]) }
    }

    /// State and tangent vectors as one full state; a tangent vector has no share in the modes.
    pub fn join(&self, state: &[f64], vectors: &[Vec<f64>]) -> Vec<f64> {
        let mut joined = vec![0.0; self.shape.size()];
        for (row, numbers) in std::iter::once(state).chain(vectors.iter().map(Vec::as_slice)).enumerate() {
            for (j, x) in numbers.iter().enumerate() {
                joined[self.shape.place(row, j)] = *x;
            }
        }
        joined
    }

    /// And back.
    pub fn part(&self, joined: &[f64], state: &mut [f64], vectors: &mut [Vec<f64>]) {
        let rows = std::iter::once(state).chain(vectors.iter_mut().map(Vec::as_mut_slice));
        for (row, numbers) in rows.enumerate() {
            for (j, x) in numbers.iter_mut().enumerate() {
                *x = joined[self.shape.place(row, j)];
            }
        }
    }
}

impl Field<f64> for Tangents<'_> {
    fn shape(&self) -> &Shape {
        &self.shape
    }

    fn rate(&self, t: f64, y: &[f64], dy: &mut [f64]) {
        let shape = &self.shape;
        // A lock that a panic has poisoned still holds numbers, and all of them are written before they are read.
        let mut scratch = self.scratch.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        let [state, rate] = &mut *scratch;
        let t = Dual::constant(t + self.from);
        for row in 1..shape.rows {
            for (j, number) in state.iter_mut().enumerate() {
                *number = Dual::new(y[shape.place(0, j)], y[shape.place(row, j)]);
            }
            self.fields[row - 1].rate(t, state, rate);
            for (j, number) in rate.iter().enumerate() {
                dy[shape.place(row, j)] = number.slope;
                dy[shape.place(0, j)] = number.value;
            }
        }
    }

    fn solution(&self, from: f64, start: &[f64], t: f64, y: &mut [f64]) {
        let shape = &self.shape;
        let mut scratch = self.scratch.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        let [state, end] = &mut *scratch;
        let [from, t] = [from, t].map(|t| Dual::constant(t + self.from));
        for row in 1..shape.rows {
            for (j, number) in state.iter_mut().enumerate() {
                *number = Dual::new(start[shape.place(0, j)], start[shape.place(row, j)]);
            }
            self.fields[row - 1].solution(from, state, t, end);
            for (j, number) in end.iter().enumerate() {
                y[shape.place(row, j)] = number.slope;
                y[shape.place(0, j)] = number.value;
            }
        }
    }
}

/// The derivative of the rates of the state by the state at a full state, row by row.
pub fn jacobian(field: &dyn Field<Dual<f64>>, t: f64, y: &[f64]) -> Matrix {
    let (size, full) = (field.shape().state(), field.shape().full());
    let mut matrix = Matrix::zeros(size);
    let mut state: Vec<Dual<f64>> = y.iter().map(|&x| Dual::constant(x)).collect();
    let mut rate = vec![Dual::constant(0.0); full];
    for j in 0..size {
        state[j].slope = 1.0;
        field.rate(Dual::constant(t), &state, &mut rate);
        for (i, number) in rate.iter().take(size).enumerate() {
            matrix.set(i, j, number.slope);
        }
        state[j].slope = 0.0;
    }
    matrix
}
