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
    pub fn stepper<S: Scalar>(&'static self, shape: &Shape) -> Steps<S> {
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
            k: vec![S::from(0.0); stages * zeros.len()],
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
    /// Rates at the stages, then at the end, then at the extra stages: one state after another.
    k: Vec<S>,
    state: Vec<S>,
    first_known: bool,
    evaluations: u64,
}

/// The sums of stages, each in the order of the row: `take` is given a component and its sum.
#[inline(always)]
fn combine<S: Scalar>(row: &[(usize, S)], k: &[S], size: usize, mut take: impl FnMut(usize, S)) {
    let mut i = 0;
    while i + 4 <= size {
        together::<S, 4>(row, k, size, i, &mut take);
        i += 4;
    }
    if i + 2 <= size {
        together::<S, 2>(row, k, size, i, &mut take);
        i += 2;
    }
    if i < size {
        together::<S, 1>(row, k, size, i, &mut take);
    }
}

/// The sums of a few components: they stay in registers, and a processor adds one while it waits for another.
#[inline(always)]
fn together<S: Scalar, const N: usize>(
    row: &[(usize, S)],
    k: &[S],
    size: usize,
    i: usize,
    take: &mut impl FnMut(usize, S),
) {
    let rates = |stage: usize| &k[stage * size + i..][..N];
    let mut sums = [S::from(0.0); N];
    if let Some((&(first, c), terms)) = row.split_first() {
        for (sum, k) in sums.iter_mut().zip(rates(first)) {
            *sum = *k * c;
        }
        for &(stage, c) in terms {
            for (sum, k) in sums.iter_mut().zip(rates(stage)) {
                *sum = *sum + *k * c;
            }
        }
    }
    for (n, sum) in sums.into_iter().enumerate() {
        take(i + n, sum);
    }
}

impl<S: Scalar> Steps<S> {
    /// The place of the rate at the end, after those of the stages.
    fn last(&self) -> usize {
        self.stages.len() + 1
    }

    /// The rates of a stage.
    fn rates(&mut self, stage: usize) -> &mut [S] {
        let size = self.state.len();
        &mut self.k[stage * size..][..size]
    }

    /// Evaluates a stage from its row: its state lies along the stages before.
    #[inline(always)]
    fn stage(&mut self, field: &dyn Field<S>, t: S, y: &[S], h: S, extra: bool, n: usize) {
        let (row, stage) =
            if extra { (&self.extra_stages[n], self.stages.len() + 2 + n) } else { (&self.stages[n], n + 1) };
        let (size, state) = (self.state.len(), &mut self.state[..]);
        combine(row, &self.k, size, |i, sum| state[i] = y[i] + h * sum);
        field.rate(t + h * self.nodes[stage], state, &mut self.k[stage * size..][..size]);
        self.evaluations += 1;
    }

    /// Weighted root mean square of an error row, over one step of unit length.
    #[inline(always)]
    fn estimate(&mut self, which: usize, weights: &[S]) -> S {
        let (size, state) = (self.state.len(), &mut self.state[..]);
        combine(&self.errors[which], &self.k, size, |i, sum| state[i] = sum);
        norm(state, weights)
    }
}

impl<S: Scalar> Stepper<S> for Steps<S> {
    #[inline(always)]
    fn step(&mut self, step: &mut Step<S>) -> Result<(), NoConvergence> {
        let Step { field, t, y, h, ref mut out } = *step;
        if !self.first_known {
            field.rate(t, y, self.rates(0));
            self.evaluations += 1;
            self.first_known = true;
        }
        for n in 0..self.stages.len() {
            self.stage(field, t, y, h, false, n);
        }
        combine(&self.weights[0], &self.k, y.len(), |i, sum| out[i] = y[i] + h * sum);
        let last = self.last();
        field.rate(t + h, out, self.rates(last));
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
        let size = y.len();
        let (first, last) = (&self.k[..size], &self.k[self.last() * size..][..size]);
        let mut dense = Dense::hermite(t, h, y, end, first, last);
        for row in &self.dense {
            let mut term = end.to_vec();
            combine(row, &self.k, size, |i, sum| term[i] = h * sum);
            dense.push(term);
        }
        dense
    }

    #[inline(always)]
    fn accept(&mut self, accepted: S::Mask) {
        let (size, last) = (self.state.len(), self.last());
        let (first, rest) = self.k.split_at_mut(last * size);
        for (first, end) in first.iter_mut().zip(&rest[..size]) {
            *first = S::select(accepted, *end, *first);
        }
    }

    fn restart(&mut self) {
        self.first_known = false;
    }

    fn evaluations(&self) -> u64 {
        self.evaluations
    }
}
