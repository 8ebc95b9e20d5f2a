//! Gauss's collocation with three stages: order 6 (J. C. Butcher, Math. Comp. 18, 50, 1964).

use super::collocation::{Collocation, Half};
use super::fixed_point::EPSILON_AT_LEAST;
use crate::coefficient::{decimal, ratio};
use crate::{Kind, Method, MethodCard, Needs, Options};
use precess_scalar::Scalar;
use precess_system::Shape;

/// See the module.
pub struct GaussLegendre6;

static CARD: MethodCard = MethodCard {
    id: "gauss_legendre6",
    title: ("Gauss-Legendre 6", "Gauss-Legendre 6"),
    about: (
        "Symplectic and symmetric for every system, of order 6; a loop solves each step.",
        "Symplectique et symétrique pour tout système, d'ordre 6 ; une boucle résout chaque pas.",
    ),
    order: 6,
    kind: Kind::Fixed,
    needs: Needs::Any,
    symplectic: true,
    reversible: true,
    source: "J. C. Butcher, Math. Comp. 18, 50 (1964)",
    options: &[EPSILON_AT_LEAST],
};

/// Times and weights of the first half of the stages.
const HALF: Half =
    &[(decimal("0.112701665379258311482073460021760"), ratio(5, 18)), (ratio(1, 2), ratio(4, 9))];

impl Method for GaussLegendre6 {
    fn card(&self) -> &'static MethodCard {
        &CARD
    }
    type Steps<S: Scalar> = Collocation<S>;

    fn stepper<S: Scalar>(&self, shape: &Shape, options: &Options) -> Collocation<S> {
        Collocation::new(shape, HALF, 3, false, options.epsilon)
    }
}
