//! Runge-Kutta methods given by their coefficients, with an error estimate and dense output.

use crate::controller::norm;
use crate::{Dense, NoConvergence, Stepper};
use precess_scalar::Scalar;
use precess_system::{Field, Shape};

/// Coefficients of the stages that matter: (stage, coefficient), in the order in which they are summed.
pub(crate) type Row = &'static [(usize, f64)];

/// An explicit Runge-Kutta pair. After the stages comes one more, the rate at the end of the step, which is
/// the first stage of the next step.
pub(crate) struct Tableau {
    /// Times of the stages, in steps.
    pub nodes: &'static [f64],
    /// Rows of the stages after the first.
    pub stages: &'static [Row],
    /// The step itself.
    pub weights: Row,
    /// Its difference to a formula of lower order; may use the stage at the end.
    pub error: Row,
    /// Its difference to a formula of still lower order, or empty: the estimate is then Hairer's combination.
    pub second_error: Row,
    /// Times of the stages that only dense output needs.
    pub extra_nodes: &'static [f64],
    /// Their rows; stages count on after the one at the end.
    pub extra_stages: &'static [Row],
    /// Terms of the dense output beyond the cubic.
    pub dense: &'static [Row],
}

impl Tableau {
    /// A stepper for states of this shape.
    pub fn stepper<S: Scalar + Send>(&'static self, shape: &Shape) -> Box<dyn Stepper<S>> {
        let zeros = vec![S::from(0.0); shape.full()];
        let stages = self.nodes.len() + 1 + self.extra_nodes.len();
        Box::new(Steps {
            tableau: self,
            k: vec![zeros.clone(); stages],
            state: zeros,
            first_known: false,
            evaluations: 0,
        })
    }
}

struct Steps<S> {
    tableau: &'static Tableau,
    /// Rates at the stages, then at the end, then at the extra stages.
    k: Vec<Vec<S>>,
    state: Vec<S>,
    first_known: bool,
    evaluations: u64,
}

/// The sum of stages, component by component, in the order of the row.
fn combine<S: Scalar>(row: Row, k: &[Vec<S>], i: usize) -> S {
    let mut terms = row.iter();
    let Some(&(first, c)) = terms.next() else { return S::from(0.0) };
    terms.fold(k[first][i] * c, |sum, &(j, c)| sum + k[j][i] * c)
}

impl<S: Scalar> Steps<S> {
    /// The rate at stage number `stage`, whose time and row are given.
    fn stage(
        &mut self,
        field: &dyn Field<S>,
        (t, h): (S, S),
        y: &[S],
        stage: usize,
        (node, row): (f64, Row),
    ) {
        for (i, state) in self.state.iter_mut().enumerate() {
            *state = y[i] + h * combine(row, &self.k, i);
        }
        field.rate(t + h * node, &self.state, &mut self.k[stage]);
        self.evaluations += 1;
    }

    /// Weighted root mean square of an error row, over one step of unit length.
    fn estimate(&mut self, row: Row, weights: &[S]) -> S {
        for (i, state) in self.state.iter_mut().enumerate() {
            *state = combine(row, &self.k, i);
        }
        norm(&self.state, weights)
    }
}

impl<S: Scalar + Send> Stepper<S> for Steps<S> {
    fn step(
        &mut self,
        field: &dyn Field<S>,
        t: S,
        y: &[S],
        h: S,
        out: &mut [S],
    ) -> Result<(), NoConvergence> {
        let tableau = self.tableau;
        if !self.first_known {
            field.rate(t, y, &mut self.k[0]);
            self.evaluations += 1;
            self.first_known = true;
        }
        for (row, stage) in tableau.stages.iter().zip(1..) {
            self.stage(field, (t, h), y, stage, (tableau.nodes[stage], row));
        }
        for (i, out) in out.iter_mut().enumerate() {
            *out = y[i] + h * combine(tableau.weights, &self.k, i);
        }
        let end = tableau.nodes.len();
        field.rate(t + h, out, &mut self.k[end]);
        self.evaluations += 1;
        Ok(())
    }

    fn error(&mut self, h: S, weights: &[S]) -> S {
        let tableau = self.tableau;
        let first = self.estimate(tableau.error, weights);
        if tableau.second_error.is_empty() {
            return h.abs() * first;
        }
        // Hairer's combination of two estimates: e5^2 / sqrt(e5^2 + e3^2 / 100).
        let second = self.estimate(tableau.second_error, weights);
        let square = first * first;
        let below = (square + second * second * 0.01).sqrt();
        let nonzero = S::from(0.0).lt(below);
        S::select(nonzero, h.abs() * square / below, first)
    }

    fn dense(&mut self, field: &dyn Field<S>, t: S, y: &[S], h: S, end: &[S]) -> Dense<S> {
        let tableau = self.tableau;
        let last = tableau.nodes.len();
        for (n, row) in tableau.extra_stages.iter().enumerate() {
            self.stage(field, (t, h), y, last + 1 + n, (tableau.extra_nodes[n], row));
        }
        let mut dense = Dense::hermite(t, h, y, end, &self.k[0], &self.k[last]);
        for row in tableau.dense {
            dense.push((0..y.len()).map(|i| h * combine(row, &self.k, i)).collect());
        }
        dense
    }

    fn accept(&mut self) {
        let end = self.tableau.nodes.len();
        self.k.swap(0, end);
    }

    fn restart(&mut self) {
        self.first_known = false;
    }

    fn evaluations(&self) -> u64 {
        self.evaluations
    }
}

#[cfg(test)]
mod order_conditions;
