//! Euler's method: along the tangent.
//!
//!     y1 = y0 + h f(t0, y0)
//!
//! (T 5.1; Euler 1768.) Its two forms, of first and second order, are the same. An undamped oscillator gains the
//! factor `1 + (omega h)^2` of energy at each step.

use crate::{Kind, Method, MethodCard, Needs, NoConvergence, Options, Stepper};
use precess_scalar::Scalar;
use precess_system::{Field, Shape};

/// See the module.
pub struct Euler;

static CARD: MethodCard = MethodCard {
    id: "euler",
    title: ("Euler", "Euler"),
    about: (
        "The simplest method, along the tangent. It spirals outwards: useful to see why others exist.",
        "La méthode la plus simple, le long de la tangente. Elle s'écarte en spirale : utile pour voir pourquoi \
         les autres existent.",
    ),
    order: 1,
    kind: Kind::Fixed,
    needs: Needs::Any,
    symplectic: false,
    reversible: false,
    source: "T 5.1; L. Euler, Institutionum calculi integralis I (1768)",
    options: &[],
};

impl Method for Euler {
    fn card(&self) -> &'static MethodCard {
        &CARD
    }
    fn stepper<S: Scalar + Send>(&self, shape: &Shape, _: &Options) -> Box<dyn Stepper<S>> {
        Box::new(Steps { rate: vec![S::from(0.0); shape.full()], evaluations: 0 })
    }
}

struct Steps<S> {
    rate: Vec<S>,
    evaluations: u64,
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
        field.rate(t, y, &mut self.rate);
        self.evaluations += 1;
        for i in 0..y.len() {
            out[i] = y[i] + h * self.rate[i];
        }
        Ok(())
    }
    fn evaluations(&self) -> u64 {
        self.evaluations
    }
}
