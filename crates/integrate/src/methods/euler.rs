//! Euler's method: along the tangent.
//!
//!     y1 = y0 + h f(t0, y0)
//!
//! (T 5.1; Euler 1768.) Its two forms, of first and second order, are the same. An undamped oscillator gains the
//! factor `1 + (omega h)^2` of energy at each step.

use super::glide::Glide;
use crate::{Kind, Method, MethodCard, Needs, Options};
use precess_scalar::Scalar;
use precess_system::Shape;

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
    type Steps<S: Scalar> = Glide<S>;

    fn stepper<S: Scalar>(&self, shape: &Shape, _: &Options) -> Glide<S> {
        Glide::new(shape, 0.0)
    }
}
