//! Runge-Kutta methods given by their coefficients, with an error estimate and dense output.

use crate::coefficient::Coefficient;
use crate::controller::norm;
use crate::{Dense, NoConvergence, Step, Stepper};
use precess_scalar::Scalar;
use precess_system::{Field, Shape};

/// Coefficients of the stages that matter: (stage, coefficient), in the order in which they are summed.
pub(crate) type Row = &'static [(usize, Coefficient)];

/// An explicit Runge-Kutta pair. After the stages comes one more, the rate at the end of the step, which is
/// the first stage of the next step.
pub(crate) struct Tableau {
    /// Times of the stages, in steps.
    pub nodes: &'static [Coefficient],
    /// Rows of the stages after the first.
    pub stages: &'static [Row],
    /// The step itself.
    pub weights: Row,
    /// Its difference to a formula of lower order; may use the stage at the end.
    pub error: Row,
    /// Its difference to a formula of still lower order, or empty: the estimate is then Hairer's combination.
    pub second_error: Row,
    /// Times of the stages that only dense output needs.
    pub extra_nodes: &'static [Coefficient],
    /// Their rows; stages count on after the one at the end.
    pub extra_stages: &'static [Row],
    /// Terms of the dense output beyond the cubic.
    pub dense: &'static [Row],
}

impl Tableau {
    /// A stepper for states of this shape.
    pub fn stepper<S: Scalar + Send>(&'static self, shape: &Shape) -> Steps<S> {
        let zeros = vec![S::from(0.0); shape.size()];
        let stages = self.nodes.len() + 1 + self.extra_nodes.len();
        let end = std::iter::once(S::from(1.0));
        let nodes = self.nodes.iter().map(|c| c.value());
        Steps {
            nodes: nodes.chain(end).chain(self.extra_nodes.iter().map(|c| c.value())).collect(),
            stages: values(self.stages),
            weights: values(&[self.weights]),
            errors: values(&[self.error, self.second_error]),
            extra_stages: values(self.extra_stages),
            dense: values(self.dense),
            k: vec![zeros.clone(); stages],
            state: zeros,
            first_known: false,
            evaluations: 0,
        }
    }
}

/// The coefficients as numbers of the run.
type Values<S> = Vec<Vec<(usize, S)>>;

fn values<S: Scalar>(rows: &[Row]) -> Values<S> {
    rows.iter().map(|row| row.iter().map(|(stage, c)| (*stage, c.value())).collect()).collect()
}

/// The stages and what else a step needs.
pub struct Steps<S> {
    nodes: Vec<S>,
    stages: Values<S>,
    weights: Values<S>,
    errors: Values<S>,
    extra_stages: Values<S>,
    dense: Values<S>,
    /// Rates at the stages, then at the end, then at the extra stages.
    k: Vec<Vec<S>>,
    state: Vec<S>,
    first_known: bool,
    evaluations: u64,
}

/// The sum of stages, component by component, in the order of the row.
#[inline(always)]
fn combine<S: Scalar>(row: &[(usize, S)], k: &[Vec<S>], i: usize) -> S {
    let Some((&(first, c), terms)) = row.split_first() else { return S::from(0.0) };
    terms.iter().fold(k[first][i] * c, |sum, &(j, c)| sum + k[j][i] * c)
}

impl<S: Scalar> Steps<S> {
    /// The place of the rate at the end, after those of the stages.
    fn last(&self) -> usize {
        self.stages.len() + 1
    }

    /// Evaluates a stage from its row: its state lies along the stages before.
    #[inline(always)]
    fn stage(&mut self, field: &dyn Field<S>, t: S, y: &[S], h: S, extra: bool, n: usize) {
        let (row, stage) =
            if extra { (&self.extra_stages[n], self.stages.len() + 2 + n) } else { (&self.stages[n], n + 1) };
        for (i, state) in self.state.iter_mut().enumerate() {
            *state = y[i] + h * combine(row, &self.k, i);
        }
        field.rate(t + h * self.nodes[stage], &self.state, &mut self.k[stage]);
        self.evaluations += 1;
    }

    /// Weighted root mean square of an error row, over one step of unit length.
    #[inline(always)]
    fn estimate(&mut self, which: usize, weights: &[S]) -> S {
        for (i, state) in self.state.iter_mut().enumerate() {
            *state = combine(&self.errors[which], &self.k, i);
        }
        norm(&self.state, weights)
    }
}

impl<S: Scalar + Send> Stepper<S> for Steps<S> {
    #[inline(always)]
    fn step(&mut self, step: &mut Step<S>) -> Result<(), NoConvergence> {
        let Step { field, t, y, h, ref mut out } = *step;
        if !self.first_known {
            field.rate(t, y, &mut self.k[0]);
            self.evaluations += 1;
            self.first_known = true;
        }
        for n in 0..self.stages.len() {
            self.stage(field, t, y, h, false, n);
        }
        for (i, out) in out.iter_mut().enumerate() {
            *out = y[i] + h * combine(&self.weights[0], &self.k, i);
        }
        let last = self.last();
        field.rate(t + h, out, &mut self.k[last]);
        self.evaluations += 1;
        Ok(())
    }

    #[inline(always)]
    fn error(&mut self, h: S, weights: &[S]) -> S {
        let first = self.estimate(0, weights);
        if self.errors[1].is_empty() {
            return h.abs() * first;
        }
        // Hairer's combination of two estimates: e5^2 / sqrt(e5^2 + e3^2 / 100).
        let second = self.estimate(1, weights);
        let square = first * first;
        let below = (square + second * second * 0.01).sqrt();
        let nonzero = S::from(0.0).lt(below);
        S::select(nonzero, h.abs() * square / below, first)
    }

    #[inline(always)]
    fn dense(&mut self, field: &dyn Field<S>, t: S, y: &[S], h: S, end: &[S]) -> Dense<S> {
        for n in 0..self.extra_stages.len() {
            self.stage(field, t, y, h, true, n);
        }
        let mut dense = Dense::hermite(t, h, y, end, &self.k[0], &self.k[self.last()]);
        for row in &self.dense {
            dense.push((0..y.len()).map(|i| h * combine(row, &self.k, i)).collect());
        }
        dense
    }

    #[inline(always)]
    fn accept(&mut self, accepted: S::Mask) {
        let last = self.last();
        if S::all(accepted) {
            self.k.swap(0, last);
            return;
        }
        for i in 0..self.state.len() {
            self.k[0][i] = S::select(accepted, self.k[last][i], self.k[0][i]);
        }
    }

    fn restart(&mut self) {
        self.first_known = false;
    }

    fn evaluations(&self) -> u64 {
        self.evaluations
    }
}
