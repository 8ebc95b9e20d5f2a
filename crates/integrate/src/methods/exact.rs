//! The closed form of a motion, where it has one.
//!
//! A step is no step: the state is computed from the one where the run (or its last restart) began, so errors do not add
//! up, and the length of the steps does not matter.

use crate::{Kind, Method, MethodCard, Needs, NoConvergence, Options, Step, Stepper};
use precess_scalar::Scalar;
use precess_system::Shape;

/// See the module.
pub struct Exact;

static CARD: MethodCard = MethodCard {
    id: "exact",
    title: ("Closed form", "Forme close"),
    about: (
        "No integration: the formula of the motion, where there is one (linear oscillators, the pendulum, two bodies, the symmetric top, the free body).",
        "Pas d'intégration : la formule du mouvement, quand elle existe (oscillateurs linéaires, pendule, deux corps, toupie symétrique, solide libre).",
    ),
    order: 0,
    kind: Kind::Fixed,
    needs: Needs::ClosedForm,
    symplectic: true,
    reversible: true,
    source: "the system's own",
    options: &[],
};

impl Method for Exact {
    fn card(&self) -> &'static MethodCard {
        &CARD
    }
    type Steps<S: Scalar> = Steps<S>;

    fn stepper<S: Scalar>(&self, shape: &Shape, _: &Options) -> Steps<S> {
        let zero = S::from(0.0);
        Steps { anchored: false, from: zero, start: vec![zero; shape.size()], evaluations: 0 }
    }
}

/// Where the motion began.
pub struct Steps<S> {
    anchored: bool,
    from: S,
    start: Vec<S>,
    evaluations: u64,
}

impl<S: Scalar> Stepper<S> for Steps<S> {
    #[inline(always)]
    fn step(&mut self, step: &mut Step<S>) -> Result<(), NoConvergence> {
        let Step { field, t, y, h, ref mut out } = *step;
        if !self.anchored {
            self.anchored = true;
            self.from = t;
            self.start.copy_from_slice(y);
        }
        field.solution(self.from, &self.start, t + h, out);
        self.evaluations += 1;
        Ok(())
    }
    fn restart(&mut self) {
        self.anchored = false;
    }
    fn evaluations(&self) -> u64 {
        self.evaluations
    }
}
