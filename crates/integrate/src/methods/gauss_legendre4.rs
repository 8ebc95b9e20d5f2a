//! Gauss's collocation with two stages: order 4 (J. C. Butcher, Math. Comp. 18, 50, 1964).

use super::collocation::{Collocation, Half};
use super::fixed_point::EPSILON_AT_LEAST;
use crate::coefficient::{decimal, ratio};
use crate::{Kind, Method, MethodCard, Needs, Options};
use precess_scalar::Scalar;
use precess_system::Shape;

/// See the module.
pub struct GaussLegendre4;

static CARD: MethodCard = MethodCard {
    id: "gauss_legendre4",
    title: ("Gauss-Legendre 4", "Gauss-Legendre 4"),
    about: (
        "Symplectic and symmetric for every system, of order 4; a loop solves each step.",
        "Symplectique et symétrique pour tout système, d'ordre 4 ; une boucle résout chaque pas.",
    ),
    order: 4,
    kind: Kind::Fixed,
    needs: Needs::Any,
    symplectic: true,
    reversible: true,
    source: "J. C. Butcher, Math. Comp. 18, 50 (1964)",
    options: &[EPSILON_AT_LEAST],
};

/// Times and weights of the first half of the stages.
const HALF: Half = &[(decimal("0.211324865405187117745425609749021"), ratio(1, 2))];

impl Method for GaussLegendre4 {
    fn card(&self) -> &'static MethodCard {
        &CARD
    }
    type Steps<S: Scalar> = Collocation<S>;

    fn stepper<S: Scalar>(&self, shape: &Shape, options: &Options) -> Collocation<S> {
        Collocation::new(shape, HALF, 2, false, options.epsilon)
    }
}
