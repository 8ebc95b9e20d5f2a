//! Radau IIA: implicit, of order 5, for stiff equations.
//!
//!     Z_i = h sum_j a_ij f(t + c_j h, y + Z_j)        y1 = y + Z_3        c = (4 - sqrt 6)/10, (4 + sqrt 6)/10, 1
//!
//! (E. Hairer, G. Wanner, *Solving ODEs II*, IV.5 and IV.8.) Fast motions that have died out do not shorten its steps: it is
//! stable however long a step is, and damps what it cannot follow. Newton's iteration solves the stages, with the derivatives
//! at the start of the step from differences; it goes on until it no longer comes closer, so the bits do not hang on where a
//! tolerance cuts it. A step for which it fails ends in NaN and is tried again, shorter. All stages are solved as one
//! system: Hairer and Wanner's change of variables would cost a third of it, but a page of constants.
//!
//! The estimate is theirs (IV.8.19), of order 3: filtered by the derivatives, so that stiff parts do not spoil it.

use super::fixed_point::FAR_BELOW;
use crate::linear::Lu;
use crate::{Kind, Method, MethodCard, Needs, NoConvergence, Options, Step, Stepper};
use precess_scalar::Scalar;
use precess_system::{Field, Shape};

/// See the module.
pub struct Radau5;

static CARD: MethodCard = MethodCard {
    id: "radau5",
    title: ("Radau IIA 5(3)", "Radau IIA 5(3)"),
    about: (
        "Adaptive, implicit, of order 5: for stiff equations, whose fast parts have died out.",
        "Adaptative, implicite, d'ordre 5 : pour les équations raides, dont les parties rapides sont amorties.",
    ),
    order: 5,
    kind: Kind::Adaptive,
    needs: Needs::Any,
    symplectic: false,
    reversible: false,
    source: "E. Hairer, G. Wanner, Solving ODEs II, IV.8 (1996)",
    options: &[],
};

const STAGES: usize = 3;
/// An iteration that converges at all is there before; beyond, a shorter step is cheaper.
const MOST_ITERATIONS: u32 = 40;
/// Length of the differences, relative to the size of the state: half its digits.
const REACH: f64 = 1.0 / (1 << 26) as f64;
/// Components below this size are differenced as if they had it.
const SMALL: f64 = 1e-3;

impl Method for Radau5 {
    fn card(&self) -> &'static MethodCard {
        &CARD
    }
    type Steps<S: Scalar> = Steps<S>;

    fn stepper<S: Scalar>(&self, shape: &Shape, options: &Options) -> Steps<S> {
        let (size, full) = (shape.size(), shape.full());
        let zeros = vec![S::from(0.0); size];
        let root = S::from(6.0).sqrt();
        let over = |a: f64, b: f64, n: f64| (root * b + a) / n;
        // The real eigenvalue of the stages' weights.
        let ninth = S::from(9.0).cbrt();
        let gamma = (ninth * (ninth - 1.0) + 6.0) / 30.0;
        Steps {
            nodes: [over(4.0, -1.0, 10.0), over(4.0, 1.0, 10.0), S::from(1.0)],
            a: [
                [over(88.0, -7.0, 360.0), over(296.0, -169.0, 1800.0), over(-2.0, 3.0, 225.0)],
                [over(296.0, 169.0, 1800.0), over(88.0, 7.0, 360.0), over(-2.0, -3.0, 225.0)],
                [over(16.0, -1.0, 36.0), over(16.0, 1.0, 36.0), S::from(1.0) / 9.0],
            ],
            gamma,
            estimate: [over(-13.0, -7.0, 3.0), over(-13.0, 7.0, 3.0), over(-1.0, 0.0, 3.0)],
            places: shape.places(),
            rows: (0..shape.rows).map(|_| Row::new(full)).collect(),
            start: zeros.clone(),
            z: [zeros.clone(), zeros.clone(), zeros.clone()],
            rates: [zeros.clone(), zeros.clone(), zeros.clone()],
            state: zeros.clone(),
            rate: zeros,
            epsilon: options.epsilon,
            evaluations: 0,
        }
    }
}

/// What belongs to one row of states: its derivatives, its equations, its way to rest.
struct Row<S: Scalar> {
    /// The derivative of rate `i` by number `j` at `i * full + j`.
    jacobian: Vec<S>,
    stages: Lu<S>,
    filter: Lu<S>,
    right: Vec<S>,
    /// A lane that rests is frozen, so that its bits do not depend on its neighbours.
    moving: S::Mask,
    /// Of those at rest: which have not converged.
    failed: S::Mask,
    /// Squares of the last change, and the size of the state.
    before: S,
    size: S,
}

impl<S: Scalar> Row<S> {
    fn new(full: usize) -> Self {
        let zero = S::from(0.0);
        Self {
            jacobian: vec![zero; full * full],
            stages: Lu::new(STAGES * full),
            filter: Lu::new(full),
            right: vec![zero; STAGES * full],
            moving: S::always(),
            failed: !S::always(),
            before: zero,
            size: zero,
        }
    }
}

/// What a step needs besides the state.
pub struct Steps<S: Scalar> {
    nodes: [S; STAGES],
    a: [[S; STAGES]; STAGES],
    gamma: S,
    /// Weights of the stages in the estimate.
    estimate: [S; STAGES],
    /// Where the numbers of each row stand.
    places: Vec<Vec<usize>>,
    rows: Vec<Row<S>>,
    /// The rate at the start of the step.
    start: Vec<S>,
    /// The stages, from the start of the step on, and their rates.
    z: [Vec<S>; STAGES],
    rates: [Vec<S>; STAGES],
    state: Vec<S>,
    rate: Vec<S>,
    epsilon: f64,
    evaluations: u64,
}

impl<S: Scalar> Steps<S> {
    /// The derivatives at the start of the step, by differences of one number in all rows at once.
    #[inline(always)]
    fn differentiate(&mut self, field: &dyn Field<S>, t: S, y: &[S]) {
        let full = self.places[0].len();
        self.state.copy_from_slice(y);
        for j in 0..full {
            for places in &self.places {
                let x = y[places[j]];
                self.state[places[j]] = x + x.abs().larger(S::from(SMALL)) * REACH;
            }
            field.rate(t, &self.state, &mut self.rate);
            self.evaluations += 1;
            for (places, row) in self.places.iter().zip(&mut self.rows) {
                // The length as it was rounded.
                let length = self.state[places[j]] - y[places[j]];
                for (i, &place) in places.iter().enumerate() {
                    row.jacobian[i * full + j] = (self.rate[place] - self.start[place]) / length;
                }
                self.state[places[j]] = y[places[j]];
            }
        }
    }

    /// The matrices `1 - h a_ij J` of the stages together, and `1 - h gamma J` of the estimate.
    #[inline(always)]
    fn factorise(&mut self, h: S) {
        let full = self.places[0].len();
        let width = STAGES * full;
        for row in &mut self.rows {
            let stages = row.stages.entries();
            for p in 0..STAGES {
                for q in 0..STAGES {
                    let weight = h * self.a[p][q];
                    for i in 0..full {
                        for j in 0..full {
                            let one = S::from(if p == q && i == j { 1.0 } else { 0.0 });
                            stages[(p * full + i) * width + q * full + j] =
                                one - weight * row.jacobian[i * full + j];
                        }
                    }
                }
            }
            row.stages.factorise();
            let filter = row.filter.entries();
            for i in 0..full {
                for j in 0..full {
                    let one = S::from(if i == j { 1.0 } else { 0.0 });
                    filter[i * full + j] = one - h * self.gamma * row.jacobian[i * full + j];
                }
            }
            row.filter.factorise();
        }
    }

    /// One step of Newton's iteration; whether all rests.
    #[inline(always)]
    fn improve(&mut self, step: &Step<S>) -> bool {
        for stage in 0..STAGES {
            for ((state, y), z) in self.state.iter_mut().zip(step.y).zip(&self.z[stage]) {
                *state = *y + *z;
            }
            step.field.rate(step.t + step.h * self.nodes[stage], &self.state, &mut self.rates[stage]);
            self.evaluations += 1;
        }
        let mut rest = true;
        for (places, row) in self.places.iter().zip(&mut self.rows) {
            let full = places.len();
            for (stage, weights) in self.a.iter().enumerate() {
                for (i, &place) in places.iter().enumerate() {
                    let sum =
                        (0..STAGES).fold(S::from(0.0), |sum, q| sum + weights[q] * self.rates[q][place]);
                    row.right[stage * full + i] = step.h * sum - self.z[stage][place];
                }
            }
            row.stages.solve(&mut row.right);
            let mut change = S::from(0.0);
            for stage in 0..STAGES {
                for (i, &place) in places.iter().enumerate() {
                    let moved = row.right[stage * full + i];
                    let z = &mut self.z[stage][place];
                    *z = S::select(row.moving, *z + moved, *z);
                    change = change + moved.squared();
                }
            }
            let change = change.sqrt();
            let small = row.size * self.epsilon;
            // Comparisons with NaN are false: what is no number does not move on.
            let closer = change.lt(row.before);
            let there = change.le(small * FAR_BELOW) | (change.le(small) & !closer);
            row.failed = row.failed | (row.moving & !there & !closer);
            row.moving = row.moving & !there & closer;
            row.before = change;
            rest &= S::all(!row.moving);
        }
        rest
    }
}

impl<S: Scalar> Stepper<S> for Steps<S> {
    #[inline(always)]
    fn step(&mut self, step: &mut Step<S>) -> Result<(), NoConvergence> {
        step.field.rate(step.t, step.y, &mut self.start);
        self.evaluations += 1;
        self.differentiate(step.field, step.t, step.y);
        self.factorise(step.h);
        for z in &mut self.z {
            z.fill(S::from(0.0));
        }
        for (places, row) in self.places.iter().zip(&mut self.rows) {
            row.moving = S::always();
            row.failed = !S::always();
            row.before = S::from(f64::INFINITY);
            row.size = places.iter().fold(S::from(1.0), |sum, &place| sum + step.y[place].squared()).sqrt();
        }
        for _ in 0..MOST_ITERATIONS {
            if self.improve(step) {
                break;
            }
        }
        for (places, row) in self.places.iter().zip(&self.rows) {
            let failed = row.failed | row.moving;
            for &place in places {
                let end = step.y[place] + self.z[STAGES - 1][place];
                step.out[place] = S::select(failed, S::from(f64::NAN), end);
            }
        }
        Ok(())
    }

    #[inline(always)]
    fn error(&mut self, h: S, weights: &[S]) -> S {
        for (places, row) in self.places.iter().zip(&mut self.rows) {
            let full = places.len();
            for (i, &place) in places.iter().enumerate() {
                let stages =
                    (0..STAGES).fold(S::from(0.0), |sum, q| sum + self.estimate[q] * self.z[q][place]);
                row.right[i] = self.gamma * (h * self.start[place] + stages);
            }
            row.filter.solve(&mut row.right[..full]);
            for (i, &place) in places.iter().enumerate() {
                self.rate[place] = row.right[i];
            }
        }
        // The estimate falls with the fourth power of the step; a method of order 5 is asked for the fifth.
        let error = crate::controller::norm(&self.rate, weights);
        error * error.sqrt().sqrt()
    }

    fn evaluations(&self) -> u64 {
        self.evaluations
    }
}
