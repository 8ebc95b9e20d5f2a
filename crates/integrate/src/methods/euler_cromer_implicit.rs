//! Euler-Cromer for Hamiltonians that are not separable.
//!
//!     p1 = p0 - h dH/dq(p1, q0)        q1 = q0 + h dH/dp(p1, q0)
//!
//! (T C.2.3.) Symplectic for every Hamiltonian, and implicit in the new momentum. The state holds velocities, so the recorded
//! Lagrangian gives momenta `p = dL/dv` and forces `-dH/dq = dL/dq`: a loop finds the velocity w with
//!
//!     p(q0, w) - h f(q0, w) = p(q0, v0)        q1 = q0 + h w        p(q1, v1) = p(q0, w)
//!
//! T proposes a fixed point; ours is divided by the mass matrix `dp/dv`. Momenta and forces of other kinds than the Lagrangian's
//! (friction) have no place here.

use super::fixed_point::{EPSILON, MOST_ITERATIONS};
use crate::linear::Lu;
use crate::{Kind, Method, MethodCard, Needs, NoConvergence, Options, Step, Stepper};
use precess_scalar::{Scalar, Tape, Workspace};
use precess_system::Shape;
use std::sync::Arc;

/// See the module.
pub struct EulerCromerImplicit;

static CARD: MethodCard = MethodCard {
    id: "euler_cromer_implicit",
    title: ("Implicit Euler-Cromer", "Euler-Cromer implicite"),
    about: (
        "Euler-Cromer in momenta: symplectic for every Hamiltonian, a top's too. A loop solves each step.",
        "Euler-Cromer en impulsions : symplectique pour tout hamiltonien, celui d'une toupie aussi. Une boucle résout \
         chaque pas.",
    ),
    order: 1,
    kind: Kind::Fixed,
    needs: Needs::Lagrangian,
    symplectic: true,
    reversible: false,
    source: "T C.2.3",
    options: &[EPSILON],
};

impl Method for EulerCromerImplicit {
    fn card(&self) -> &'static MethodCard {
        &CARD
    }
    type Steps<S: Scalar> = Steps<S>;

    fn stepper<S: Scalar>(&self, shape: &Shape, options: &Options) -> Steps<S> {
        let n = shape.coordinates;
        let zeros = vec![S::from(0.0); n];
        Steps {
            momenta: options.equations.clone().filter(|tape| tape.inputs() == 1 + 2 * n),
            places: shape.places(),
            workspace: Workspace::default(),
            inputs: vec![S::from(0.0); 1 + 2 * n],
            outputs: vec![S::from(0.0); n * (n + 2)],
            target: zeros.clone(),
            miss: zeros,
            mass: Lu::new(n),
            epsilon: options.epsilon,
            residual: S::from(0.0),
            evaluations: 0,
        }
    }
}

/// What a step needs besides the state.
pub struct Steps<S: Scalar> {
    /// Momenta, forces, mass matrix; without them steps end in NaN (a [`drive`](crate::drive) refuses such a run).
    momenta: Option<Arc<Tape>>,
    /// Where the numbers of each row stand.
    places: Vec<Vec<usize>>,
    workspace: Workspace<S>,
    /// Time, coordinates, velocities of a row.
    inputs: Vec<S>,
    outputs: Vec<S>,
    /// The momenta that are sought.
    target: Vec<S>,
    miss: Vec<S>,
    mass: Lu<S>,
    epsilon: f64,
    /// The last change of the velocities, relative to them.
    residual: S,
    evaluations: u64,
}

impl<S: Scalar> Steps<S> {
    #[inline(always)]
    fn evaluate(&mut self, tape: &Tape) {
        tape.evaluate_into(&mut self.workspace, &self.inputs, &mut self.outputs);
        self.evaluations += 1;
    }

    /// Moves the velocities until `p - h f` is the target.
    #[inline(always)]
    fn settle(&mut self, tape: &Tape, h: S) -> Result<(), NoConvergence> {
        let n = self.target.len();
        self.evaluate(tape);
        self.mass.entries().copy_from_slice(&self.outputs[2 * n..]);
        self.mass.factorise();
        // A lane that rests is frozen, so that its bits do not depend on its neighbours.
        let mut moving = S::always();
        for _ in 0..MOST_ITERATIONS {
            for i in 0..n {
                self.miss[i] = self.outputs[i] - h * self.outputs[n + i] - self.target[i];
            }
            self.mass.solve(&mut self.miss);
            let (mut change, mut size) = (S::from(0.0), S::from(1.0));
            for (v, miss) in self.inputs[1 + n..].iter_mut().zip(&self.miss) {
                change = change + miss.squared();
                size = size + v.squared();
                *v = S::select(moving, *v - *miss, *v);
            }
            self.evaluate(tape);
            self.residual = (change / size).sqrt();
            // Nothing is small beside what has run away.
            let rests = change.sqrt().le(size.sqrt() * self.epsilon) & size.lt(S::from(f64::INFINITY));
            moving = moving & !rests;
            if S::all(!moving) {
                return Ok(());
            }
        }
        Err(NoConvergence { iterations: MOST_ITERATIONS })
    }
}

impl<S: Scalar> Stepper<S> for Steps<S> {
    #[inline(always)]
    fn step(&mut self, step: &mut Step<S>) -> Result<(), NoConvergence> {
        let Some(tape) = self.momenta.clone() else {
            step.out.fill(S::from(f64::NAN));
            return Ok(());
        };
        let n = self.target.len();
        for row in 0..self.places.len() {
            self.inputs[0] = step.t;
            for (input, &place) in self.inputs[1..].iter_mut().zip(&self.places[row]) {
                *input = step.y[place];
            }
            self.evaluate(&tape);
            self.target.copy_from_slice(&self.outputs[..n]);
            self.settle(&tape, step.h)?;
            // The new momenta, and with the velocity found the new coordinates.
            self.target.copy_from_slice(&self.outputs[..n]);
            self.inputs[0] = step.t + step.h;
            let (q, v) = self.inputs[1..].split_at_mut(n);
            for (q, v) in q.iter_mut().zip(v) {
                *q = *q + step.h * *v;
            }
            self.settle(&tape, S::from(0.0))?;
            for (input, &place) in self.inputs[1..].iter().zip(&self.places[row]) {
                step.out[place] = *input;
            }
        }
        Ok(())
    }
    fn residual(&self) -> S {
        self.residual
    }
    fn evaluations(&self) -> u64 {
        self.evaluations
    }
}
