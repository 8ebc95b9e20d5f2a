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
//!
//! The loop begins where the polynomial through the last step's stages goes on to. Where that does not lead to rest soon, it
//! begins again from the rate at the start.
//!
//! The stages of an iteration do not wait for each other: where they fill the lanes of a register, one trajectory computes
//! several at once.

use super::compensated::Carry;
use super::fixed_point::{MOST_ITERATIONS, Settling};
use crate::coefficient::Coefficient;
use crate::{NoConvergence, Step, Stepper};
use precess_scalar::{Abreast, DoubleDouble, Kernel, Scalar};
use precess_system::{Field, Shape};

/// Times and weights of the first half of the stages; the middle one belongs to it.
pub(crate) type Half = &'static [(Coefficient, Coefficient)];

/// Iterations from what the last step goes on to; from a good beginning they are enough.
const PATIENCE: u32 = 40;

/// Takes steps.
pub struct Collocation<S: Scalar> {
    common: Common<S>,
    one_by_one: Stages<S>,
    /// Where they fill the lanes.
    abreast: Option<Stages<S::Abreast>>,
}

/// What a step needs besides its stages.
struct Common<S: Scalar> {
    /// The weight of each stage.
    weights: Vec<S>,
    /// The places of a coordinate and its velocity, and of all that is no such coordinate.
    pairs: Vec<(usize, usize)>,
    plain: Vec<usize>,
    /// The rate at the start.
    rate: Vec<S>,
    /// Where the sum of the steps is compensated.
    carry: Option<Carry<S>>,
    /// The length of the step whose rates the stages still hold; no number before the first.
    last: S,
    /// Where another length begins, for each row.
    fresh: Vec<S::Mask>,
    settling: Settling<S, 1>,
    evaluations: u64,
}

/// The stages, in numbers that hold several of them.
struct Stages<L> {
    /// The times.
    times: Vec<L>,
    /// The stages' own weights, and those that go on to the next step: of stage j in those of a number.
    a: Vec<Vec<L>>,
    ahead: Vec<Vec<L>>,
    /// Their states and rates, a new rate, and the square of what changes in each row.
    states: Vec<Vec<L>>,
    rates: Vec<Vec<L>>,
    new: Vec<L>,
    change: Vec<L>,
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

/// The numbers of a method.
struct Table {
    /// Time and weight of each stage.
    nodes: Vec<[DoubleDouble; 2]>,
    /// The stages' own weights.
    a: Vec<Vec<DoubleDouble>>,
    /// What the polynomial through the stages of a step is at the stages of the next, which is as long.
    ahead: Vec<Vec<DoubleDouble>>,
}

fn table(half: Half, stages: usize) -> Table {
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
    let next: Vec<_> = nodes.iter().map(|[c, _]| legendre(stages, *c * 2.0 + 1.0)).collect();
    let ahead = |i: usize, j: usize| {
        let terms = (0..stages).map(|k| p[j][k] * next[i][k] * (2.0 * k as f64 + 1.0));
        nodes[j][1] * terms.fold(DoubleDouble::from(0.0), |sum, term| sum + term)
    };
    let square = |entry: &dyn Fn(usize, usize) -> DoubleDouble| {
        (0..stages).map(|i| (0..stages).map(|j| entry(i, j)).collect()).collect()
    };
    Table { a: square(&a), ahead: square(&ahead), nodes }
}

/// A double-double in another number.
fn number<S: Scalar>(x: DoubleDouble) -> S {
    S::from(x.hi()) + x.lo()
}

impl<S: Scalar> Collocation<S> {
    /// With so many stages; `compensated` where the sum of the steps carries its rounding.
    pub fn new(shape: &Shape, half: Half, stages: usize, compensated: bool, epsilon: f64) -> Self {
        let table = table(half, stages);
        let zeros = vec![S::from(0.0); shape.size()];
        let pairs: Vec<_> = shape.pairs().collect();
        let fills = S::is_abreast() && stages.is_multiple_of(S::Abreast::COUNT);
        Self {
            one_by_one: Stages::new::<S>(shape, &table),
            abreast: fills.then(|| Stages::new::<S>(shape, &table)),
            common: Common {
                weights: table.nodes.iter().map(|[_, b]| number(*b)).collect(),
                plain: (0..shape.size()).filter(|i| !pairs.iter().any(|(x, _)| x == i)).collect(),
                pairs,
                carry: compensated.then(|| Carry::new(shape.size())),
                rate: zeros,
                last: S::from(f64::NAN),
                fresh: vec![S::always(); shape.rows],
                settling: Settling::new(shape, epsilon),
                evaluations: 0,
            },
        }
    }
}

impl<L: Scalar> Stages<L> {
    fn new<S: Scalar>(shape: &Shape, Table { nodes, a, ahead }: &Table) -> Self
    where
        L: Abreast<S>,
    {
        let blocks = nodes.len() / L::COUNT;
        let numbers = |block: usize, of: &dyn Fn(usize) -> DoubleDouble| {
            let mut numbers = L::from(0.0);
            for (k, part) in numbers.parts_mut().iter_mut().enumerate() {
                *part = number(of(block * L::COUNT + k));
            }
            numbers
        };
        let weights = |a: &[Vec<DoubleDouble>]| {
            let column = |block, j: usize| numbers(block, &|i| a[i][j]);
            (0..blocks).map(|block| (0..nodes.len()).map(|j| column(block, j)).collect()).collect()
        };
        let zeros = vec![L::from(0.0); shape.size()];
        Self {
            times: (0..blocks).map(|block| numbers(block, &|i| nodes[i][0])).collect(),
            a: weights(a),
            ahead: weights(ahead),
            states: vec![zeros.clone(); blocks],
            rates: vec![zeros.clone(); blocks],
            new: zeros,
            change: vec![L::from(0.0); shape.rows],
        }
    }

    /// The last step's rates go on to those of the next.
    #[inline(always)]
    fn go_on<S: Scalar>(&mut self, common: &Common<S>)
    where
        L: Abreast<S>,
    {
        for block in 0..self.states.len() {
            for &i in &common.plain {
                self.states[block][i] = weighted::<S, L, L>(&self.ahead[block], &self.rates, i);
            }
        }
        std::mem::swap(&mut self.states, &mut self.rates);
    }

    /// The rates are those at the start, in rows and lanes that this holds for.
    #[inline(always)]
    fn begin<S: Scalar>(&mut self, common: &Common<S>, rows: &[S::Mask])
    where
        L: Abreast<S>,
    {
        for rates in &mut self.rates {
            for &i in &common.plain {
                let mask = L::spread_mask(rows[common.settling.row(i)]);
                rates[i] = L::select(mask, L::spread(common.rate[i]), rates[i]);
            }
        }
    }

    /// The states from the rates.
    #[inline(always)]
    fn place<S: Scalar>(&mut self, common: &Common<S>, y: &[S], h: S)
    where
        L: Abreast<S>,
    {
        let h = L::spread(h);
        for block in 0..self.states.len() {
            for &i in &common.plain {
                let sum = weighted::<S, L, L>(&self.a[block], &self.rates, i);
                self.states[block][i] = L::spread(y[i]) + (h * sum + L::spread(common.left_out(i)));
            }
        }
        for block in 0..self.states.len() {
            for &(x, v) in &common.pairs {
                let sum = weighted::<S, L, L>(&self.a[block], &self.states, v);
                self.states[block][x] = L::spread(y[x]) + (h * sum + L::spread(common.left_out(x)));
            }
        }
    }

    /// The rates from the states: how far they move is watched.
    #[inline(always)]
    fn evaluate<S: Scalar>(&mut self, common: &mut Common<S>, field: &dyn Field<L>, t: S, h: S)
    where
        L: Abreast<S>,
    {
        let (t, h) = (L::spread(t), L::spread(h));
        let settling = &mut common.settling;
        settling.iterate();
        for ((state, rate), c) in self.states.iter().zip(&mut self.rates).zip(&self.times) {
            field.rate(t + h * *c, state, &mut self.new);
            self.change.fill(L::from(0.0));
            for &i in &common.plain {
                let (row, change) = (settling.row(i), h * (self.new[i] - rate[i]));
                self.change[row] = self.change[row] + change.squared();
                rate[i] = L::select(L::spread_mask(settling.moving()[row]), self.new[i], rate[i]);
            }
            for (row, change) in self.change.iter().enumerate() {
                for change in change.parts() {
                    settling.add(row, *change);
                }
            }
        }
        common.evaluations += (self.times.len() * L::COUNT) as u64;
    }
}

/// The sum over stages, in their order; the weights hold several of them, or one.
#[inline(always)]
fn weighted<S: Scalar, L: Abreast<S>, W: Abreast<S>>(weights: &[W], stages: &[Vec<L>], i: usize) -> W {
    let mut sum = W::from(0.0);
    for (stage, weights) in stages.iter().zip(weights.chunks_exact(L::COUNT)) {
        for (part, weight) in stage[i].parts().iter().zip(weights) {
            sum = sum + *weight * W::spread(*part);
        }
    }
    sum
}

/// A step with stages of some number, compiled for its instructions.
struct Taken<'a, 'b, S: Scalar, L> {
    common: &'a mut Common<S>,
    stages: &'a mut Stages<L>,
    field: &'a dyn Field<L>,
    step: &'a mut Step<'b, S>,
}

impl<S: Scalar, L: Abreast<S>> Kernel for Taken<'_, '_, S, L> {
    type Output = Result<(), NoConvergence>;

    #[inline(always)]
    fn run(self) -> Self::Output {
        let Self { common, stages, field, step } = self;
        let (t, y, h) = (step.t, step.y, step.h);
        stages.go_on(common);
        let goes_on = common.last.le(h) & h.le(common.last);
        if !S::all(goes_on) {
            common.evaluate(step);
            common.fresh.fill(!goes_on);
            stages.begin(common, &common.fresh);
        }
        common.last = h;
        common.settling.begin(y);
        for iteration in 0..MOST_ITERATIONS {
            if iteration == PATIENCE {
                common.evaluate(step);
                stages.begin(common, common.settling.moving());
            }
            stages.place(common, y, h);
            stages.evaluate(common, field, t, h);
            if common.settling.rests() {
                stages.place(common, y, h);
                common.finish(stages, y, h, step.out);
                return Ok(());
            }
        }
        Err(NoConvergence { iterations: MOST_ITERATIONS })
    }
}

impl<S: Scalar> Stepper<S> for Collocation<S> {
    #[inline(always)]
    fn step(&mut self, step: &mut Step<S>) -> Result<(), NoConvergence> {
        let common = &mut self.common;
        match (&mut self.abreast, step.field.abreast()) {
            (Some(stages), Some(field)) => S::Abreast::enter(Taken { common, stages, field, step }),
            _ => Taken { common, stages: &mut self.one_by_one, field: step.field, step }.run(),
        }
    }

    #[inline(always)]
    fn accept(&mut self, accepted: S::Mask) {
        if let Some(carry) = &mut self.common.carry {
            carry.accept(accepted);
        }
    }
    fn restart(&mut self) {
        self.begin(S::always());
    }
    fn begin(&mut self, lanes: S::Mask) {
        self.common.last = S::select(lanes, S::from(f64::NAN), self.common.last);
        if let Some(carry) = &mut self.common.carry {
            carry.begin(lanes);
        }
    }
    fn residual(&self) -> S {
        self.common.settling.residual()
    }
    fn evaluations(&self) -> u64 {
        self.common.evaluations
    }
}

impl<S: Scalar> Common<S> {
    /// The rate at the start.
    #[inline(always)]
    fn evaluate(&mut self, step: &Step<S>) {
        step.field.rate(step.t, step.y, &mut self.rate);
        self.evaluations += 1;
    }

    /// What the sum of the steps so far has left out of a number.
    #[inline(always)]
    fn left_out(&self, i: usize) -> S {
        match &self.carry {
            Some(carry) => carry.left_out(i),
            None => S::from(0.0),
        }
    }

    /// The state at the end.
    #[inline(always)]
    fn finish<L: Abreast<S>>(&mut self, stages: &Stages<L>, y: &[S], h: S, out: &mut [S]) {
        for &i in &self.plain {
            out[i] = h * weighted::<S, L, S>(&self.weights, &stages.rates, i);
        }
        for &(x, v) in &self.pairs {
            out[x] = h * weighted::<S, L, S>(&self.weights, &stages.states, v);
        }
        for (i, out) in out.iter_mut().enumerate() {
            *out = match &mut self.carry {
                Some(carry) => carry.add(i, y[i], *out),
                None => y[i] + *out,
            };
        }
    }
}
