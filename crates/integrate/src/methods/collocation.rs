//! Gauss's collocation: the shared form of `implicit_midpoint` and the `gauss_legendre` methods.
//!
//!     Y_i = y + h sum_j a_ij f(t + c_j h, Y_j)        y1 = y + h sum_j b_j f(t + c_j h, Y_j)
//!
//! with c the zeros of Legendre's polynomial on [0, 1] (E. Hairer, Ch. Lubich, G. Wanner, *Geometric Numerical
//! Integration*, II.1.3). With s stages the order is 2 s; the methods are symplectic and symmetric, for every system. A
//! fixed point solves the stages: accelerations give the velocities of all stages and these, at once, the
//! positions, so that an error shrinks with the square of the step where no velocity enters. It goes on until it no longer
//! comes closer, far below the tolerance. The a follow from c and b in double-double, by Legendre's series of the
//! stages' polynomials. With many stages a step adds little to much, so that sum carries what its rounding leaves out.

use super::fixed_point::{MOST_ITERATIONS, Settling};
use crate::coefficient::Coefficient;
use crate::{NoConvergence, Step, Stepper};
use precess_scalar::{DoubleDouble, Scalar};
use precess_system::Shape;

/// Times and weights of the first half of the stages; the middle one belongs to it.
pub(crate) type Half = &'static [(Coefficient, Coefficient)];

/// What a step needs besides the state.
pub struct Collocation<S: Scalar> {
    /// Time and weight of each stage.
    nodes: Vec<(S, S)>,
    /// The stages' own weights.
    a: Vec<Vec<S>>,
    /// The places of a coordinate and its velocity, and of all that is no such coordinate.
    pairs: Vec<(usize, usize)>,
    plain: Vec<usize>,
    /// State and rate of each stage; a new rate.
    states: Vec<Vec<S>>,
    rates: Vec<Vec<S>>,
    new: Vec<S>,
    /// What rounding has left out of the state at the start, and at the end.
    carry: Option<[Vec<S>; 2]>,
    settling: Settling<S, 1>,
    evaluations: u64,
}

/// Legendre's polynomials up to degree `most` at `x`.
fn legendre(most: usize, x: DoubleDouble) -> Vec<DoubleDouble> {
    let mut p = vec![DoubleDouble::from(1.0), x];
    for k in 1..most {
        let k_as = k as f64;
        p.push((x * p[k] * (2.0 * k_as + 1.0) - p[k - 1] * k_as) / (k_as + 1.0));
    }
    p
}

/// Times, weights, and the stages' own weights.
fn table(half: Half, stages: usize) -> (Vec<[DoubleDouble; 2]>, Vec<Vec<DoubleDouble>>) {
    let one = DoubleDouble::from(1.0);
    let node = |j: usize| {
        let (c, b) = half[if j < half.len() { j } else { stages - 1 - j }];
        let (c, b) = (c.value::<DoubleDouble>(), b.value());
        [if j < half.len() { c } else { one - c }, b]
    };
    let nodes: Vec<_> = (0..stages).map(node).collect();
    let p: Vec<_> = nodes.iter().map(|[c, _]| legendre(stages, *c * 2.0 - 1.0)).collect();
    let a = |i: usize, j: usize| {
        // The integral of each polynomial from 0 to c_i is a difference of its neighbours.
        let rest = (1..stages).map(|k| p[j][k] * (p[i][k + 1] - p[i][k - 1]) * 0.5);
        nodes[j][1] * rest.fold(nodes[i][0], |sum, term| sum + term)
    };
    let a = (0..stages).map(|i| (0..stages).map(|j| a(i, j)).collect()).collect();
    (nodes, a)
}

impl<S: Scalar> Collocation<S> {
    /// With so many stages; `compensated` where the sum of the steps carries its rounding.
    pub fn new(shape: &Shape, half: Half, stages: usize, compensated: bool, epsilon: f64) -> Self {
        let number = |x: DoubleDouble| S::from(x.hi()) + x.lo();
        let (nodes, a) = table(half, stages);
        let zeros = vec![S::from(0.0); shape.size()];
        let pairs: Vec<_> = shape.pairs().collect();
        Self {
            nodes: nodes.into_iter().map(|[c, b]| (number(c), number(b))).collect(),
            a: a.into_iter().map(|row| row.into_iter().map(number).collect()).collect(),
            plain: (0..shape.size()).filter(|i| !pairs.iter().any(|(x, _)| x == i)).collect(),
            pairs,
            states: vec![zeros.clone(); stages],
            rates: vec![zeros.clone(); stages],
            carry: compensated.then(|| [zeros.clone(), zeros.clone()]),
            new: zeros,
            settling: Settling::new(shape, epsilon),
            evaluations: 0,
        }
    }

    /// The stages' states from their rates.
    #[inline(always)]
    fn place(&mut self, y: &[S], h: S) {
        let carry = self.carry.as_ref().map(|[carry, _]| carry);
        let small = |i: usize| carry.map_or(S::from(0.0), |carry| carry[i]);
        for stage in 0..self.nodes.len() {
            for &i in &self.plain {
                let sum = weighted(&self.a[stage], &self.rates, i);
                self.states[stage][i] = y[i] + (h * sum + small(i));
            }
        }
        for stage in 0..self.nodes.len() {
            for &(x, v) in &self.pairs {
                let sum = weighted(&self.a[stage], &self.states, v);
                self.states[stage][x] = y[x] + (h * sum + small(x));
            }
        }
    }

    /// The stages' rates from their states: how far they move is watched.
    #[inline(always)]
    fn evaluate(&mut self, step: &Step<S>) {
        self.settling.iterate();
        for ((state, rate), (c, _)) in self.states.iter().zip(&mut self.rates).zip(&self.nodes) {
            step.field.rate(step.t + step.h * *c, state, &mut self.new);
            self.evaluations += 1;
            for &i in &self.plain {
                let moving = self.settling.change(i, step.h * (self.new[i] - rate[i]));
                rate[i] = S::select(moving, self.new[i], rate[i]);
            }
        }
    }
}

/// The sum over stages, in their order.
#[inline(always)]
fn weighted<S: Scalar>(weights: &[S], stages: &[Vec<S>], i: usize) -> S {
    let terms = weights.iter().zip(stages).map(|(a, stage)| *a * stage[i]);
    terms.fold(S::from(0.0), |sum, term| sum + term)
}

impl<S: Scalar + Send> Stepper<S> for Collocation<S> {
    #[inline(always)]
    fn step(&mut self, step: &mut Step<S>) -> Result<(), NoConvergence> {
        let (y, h) = (step.y, step.h);
        step.field.rate(step.t, y, &mut self.new);
        self.evaluations += 1;
        for rate in &mut self.rates {
            rate.copy_from_slice(&self.new);
        }
        self.settling.begin(y);
        for _ in 0..MOST_ITERATIONS {
            self.place(y, h);
            self.evaluate(step);
            if self.settling.rests() {
                self.finish(y, h, step.out);
                return Ok(());
            }
        }
        Err(NoConvergence { iterations: MOST_ITERATIONS })
    }

    #[inline(always)]
    fn accept(&mut self, accepted: S::Mask) {
        if let Some([start, end]) = &mut self.carry {
            for (start, end) in start.iter_mut().zip(end) {
                *start = S::select(accepted, *end, *start);
            }
        }
    }
    fn restart(&mut self) {
        for carry in self.carry.iter_mut().flatten() {
            carry.fill(S::from(0.0));
        }
    }
    fn evaluations(&self) -> u64 {
        self.evaluations
    }
}

impl<S: Scalar> Collocation<S> {
    /// The state at the end.
    #[inline(always)]
    fn finish(&mut self, y: &[S], h: S, out: &mut [S]) {
        self.place(y, h);
        let weight = |sum: S, term: (&(S, S), &Vec<S>), i: usize| sum + term.0.1 * term.1[i];
        for &i in &self.plain {
            let stages = self.nodes.iter().zip(&self.rates);
            out[i] = h * stages.fold(S::from(0.0), |sum, term| weight(sum, term, i));
        }
        for &(x, v) in &self.pairs {
            let stages = self.nodes.iter().zip(&self.states);
            out[x] = h * stages.fold(S::from(0.0), |sum, term| weight(sum, term, v));
        }
        for (i, out) in out.iter_mut().enumerate() {
            let Some([start, end]) = &mut self.carry else {
                *out = y[i] + *out;
                continue;
            };
            // What the rounding of the sum leaves out, exactly (Knuth).
            let increment = *out + start[i];
            let sum = y[i] + increment;
            let part = sum - y[i];
            end[i] = (y[i] - (sum - part)) + (increment - part);
            *out = sum;
        }
    }
}
