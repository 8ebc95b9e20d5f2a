//! The implicit midpoint rule: Gauss's collocation with one stage.
//!
//!     y1 = y + h f(t + h/2, (y + y1) / 2)

use super::collocation::{Collocation, Half};
use super::fixed_point::EPSILON_AT_LEAST;
use crate::coefficient::ratio;
use crate::{Kind, Method, MethodCard, Needs, Options};
use precess_scalar::Scalar;
use precess_system::Shape;

/// See the module.
pub struct ImplicitMidpoint;

static CARD: MethodCard = MethodCard {
    id: "implicit_midpoint",
    title: ("Implicit midpoint", "Point milieu implicite"),
    about: (
        "Symplectic and symmetric for every system, separable or not; a loop solves each step.",
        "Symplectique et symétrique pour tout système, séparable ou non ; une boucle résout chaque pas.",
    ),
    order: 2,
    kind: Kind::Fixed,
    needs: Needs::Any,
    symplectic: true,
    reversible: true,
    source: "Hairer, Lubich, Wanner, Geometric Numerical Integration (2006), II.1.3",
    options: &[EPSILON_AT_LEAST],
};

/// Times and weights of the first half of the stages.
const HALF: Half = &[(ratio(1, 2), ratio(1, 1))];

impl Method for ImplicitMidpoint {
    fn card(&self) -> &'static MethodCard {
        &CARD
    }
    type Steps<S: Scalar> = Collocation<S>;

    fn stepper<S: Scalar>(&self, shape: &Shape, options: &Options) -> Collocation<S> {
        Collocation::new(shape, HALF, 1, false, options.epsilon)
    }
}
