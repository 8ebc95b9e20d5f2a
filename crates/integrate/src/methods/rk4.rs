//! The classical Runge-Kutta method of order 4.
//!
//! (T 5.4; W. Kutta, Z. Math. Phys. 46, 435, 1901.) T's form for second-order equations is the same arithmetic as
//! the first-order form on positions and velocities together.

use crate::{Kind, Method, MethodCard, Needs, NoConvergence, Options, Step, Stepper};
use precess_scalar::Scalar;
use precess_system::Shape;

/// See the module.
pub struct Rk4;

static CARD: MethodCard = MethodCard {
    id: "rk4",
    title: ("Runge-Kutta 4", "Runge-Kutta 4"),
    about: (
        "The workhorse of order 4. Not symplectic: over long times it loses a little energy.",
        "La bonne à tout faire d'ordre 4. Non symplectique : aux temps longs elle perd un peu d'énergie.",
    ),
    order: 4,
    kind: Kind::Fixed,
    needs: Needs::Any,
    symplectic: false,
    reversible: false,
    source: "T 5.4; W. Kutta, Z. Math. Phys. 46, 435 (1901)",
    options: &[],
};

impl Method for Rk4 {
    fn card(&self) -> &'static MethodCard {
        &CARD
    }
    type Steps<S: Scalar> = Steps<S>;

    fn stepper<S: Scalar>(&self, shape: &Shape, _: &Options) -> Steps<S> {
        let zeros = || vec![S::from(0.0); shape.size()];
        Steps { k: [zeros(), zeros(), zeros(), zeros()], evaluations: 0 }
    }
}

/// What a step needs besides the state.
pub struct Steps<S> {
    k: [Vec<S>; 4],
    evaluations: u64,
}

impl<S: Scalar> Stepper<S> for Steps<S> {
    #[inline(always)]
    fn step(&mut self, step: &mut Step<S>) -> Result<(), NoConvergence> {
        let Step { field, t, y, h, ref mut out } = *step;
        let half = h * 0.5;
        let [k1, k2, k3, k4] = &mut self.k;
        let along = |out: &mut [S], h: S, k: &[S]| {
            for i in 0..y.len() {
                out[i] = y[i] + h * k[i];
            }
        };
        field.rate(t, y, k1);
        along(out, half, k1);
        field.rate(t + half, out, k2);
        along(out, half, k2);
        field.rate(t + half, out, k3);
        along(out, h, k3);
        field.rate(t + h, out, k4);
        self.evaluations += 4;
        let sixth = h / 6.0;
        for i in 0..y.len() {
            out[i] = y[i] + sixth * (k1[i] + k2[i] * 2.0 + k3[i] * 2.0 + k4[i]);
        }
        Ok(())
    }
    fn evaluations(&self) -> u64 {
        self.evaluations
    }
}
