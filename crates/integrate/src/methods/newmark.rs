//! Newmark's method with linear acceleration (beta = 1/6, gamma = 1/2), solved by T's loop.
//!
//!     v1 = v0 + h/2 (a1 + a0)      x1 = x0 + h v0 + h^2/3 (a1/2 + a0)
//!
//! (T 5.3; N. M. Newmark, J. Eng. Mech. Div. ASCE 85, 67, 1959.) Of order 2, symmetric in time, not symplectic.
//! The loop is T's fixed point. T stops it when the *position* rests; the velocity may then still move, so here
//! both must rest, relative to the size of the state. On an oscillator the loop diverges for
//! `omega h > sqrt(6)`. A first-order coordinate follows the velocity's formula, the trapezoid.

use super::fixed_point::{EPSILON, MOST_ITERATIONS, relative};
use crate::{Kind, Method, MethodCard, Needs, NoConvergence, Options, Step, Stepper};
use precess_scalar::Scalar;
use precess_system::Shape;

/// See the module.
pub struct Newmark;

static CARD: MethodCard = MethodCard {
    id: "newmark",
    title: ("Newmark", "Newmark"),
    about: (
        "Implicit and symmetric in time: its energy error stays bounded. A loop solves each step.",
        "Implicite et symétrique dans le temps : son erreur d'énergie reste bornée. Une boucle résout chaque pas.",
    ),
    order: 2,
    kind: Kind::Fixed,
    needs: Needs::Any,
    symplectic: false,
    reversible: true,
    source: "T 5.3; N. M. Newmark, J. Eng. Mech. Div. ASCE 85, 67 (1959)",
    options: &[EPSILON],
};

impl Method for Newmark {
    fn card(&self) -> &'static MethodCard {
        &CARD
    }
    type Steps<S: Scalar> = Steps<S>;

    fn stepper<S: Scalar>(&self, shape: &Shape, options: &Options) -> Steps<S> {
        let zeros = vec![S::from(0.0); shape.size()];
        Steps {
            pairs: shape.pairs().collect(),
            start: zeros.clone(),
            end: zeros.clone(),
            next: zeros,
            moving: vec![S::always(); shape.rows],
            change: vec![S::from(0.0); shape.rows],
            size: vec![S::from(0.0); shape.rows],
            row: shape.row_of_each(),
            epsilon: options.epsilon,
            evaluations: 0,
        }
    }
}

/// What a step needs besides the state.
pub struct Steps<S: Scalar> {
    pairs: Vec<(usize, usize)>,
    /// Rates at the start and at the end of the step.
    start: Vec<S>,
    end: Vec<S>,
    /// The next iterate.
    next: Vec<S>,
    /// What has not yet come to rest, a mask a row. A lane that rests is frozen, so that its bits do not depend on
    /// its neighbours.
    moving: Vec<S::Mask>,
    /// The squares of the last change and of the state, a sum a row.
    change: Vec<S>,
    size: Vec<S>,
    /// The row that each number belongs to.
    row: Vec<usize>,
    epsilon: f64,
    evaluations: u64,
}

impl<S: Scalar> Stepper<S> for Steps<S> {
    #[inline(always)]
    fn step(&mut self, step: &mut Step<S>) -> Result<(), NoConvergence> {
        let Step { field, t, y, h, ref mut out } = *step;
        field.rate(t, y, &mut self.start);
        self.evaluations += 1;
        out.copy_from_slice(y);
        self.moving.fill(S::always());
        for _ in 0..MOST_ITERATIONS {
            field.rate(t + h, out, &mut self.end);
            self.evaluations += 1;
            for (i, next) in self.next.iter_mut().enumerate() {
                *next = y[i] + h * 0.5 * (self.end[i] + self.start[i]);
            }
            for &(x, v) in &self.pairs {
                let acceleration = self.end[v] * 0.5 + self.start[v];
                self.next[x] = y[x] + h * y[v] + h * h / 3.0 * acceleration;
            }
            self.change.fill(S::from(0.0));
            self.size.fill(S::from(1.0));
            for ((old, new), &row) in out.iter_mut().zip(&self.next).zip(&self.row) {
                self.change[row] = self.change[row] + (*new - *old).squared();
                self.size[row] = self.size[row] + new.squared();
                *old = S::select(self.moving[row], *new, *old);
            }
            let mut rest = true;
            for ((change, size), moving) in self.change.iter().zip(&self.size).zip(&mut self.moving) {
                // Nothing is small beside what has run away.
                let rests = change.sqrt().le(size.sqrt() * self.epsilon) & size.lt(S::from(f64::INFINITY));
                *moving = *moving & !rests;
                rest &= S::all(!*moving);
            }
            if rest {
                return Ok(());
            }
        }
        Err(NoConvergence { iterations: MOST_ITERATIONS })
    }
    fn residual(&self) -> S {
        relative(&self.change, &self.size)
    }
    fn evaluations(&self) -> u64 {
        self.evaluations
    }
}
