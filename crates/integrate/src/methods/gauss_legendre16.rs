//! Gauss's collocation with eight stages: order 16, with compensated sums.
//!
//! (Hairer, Lubich, Wanner, *Geometric Numerical Integration*, II.1.3.) With steps of a tenth of a period its
//! error lies at the rounding of the numbers, and the sum of the steps carries what its own rounding leaves out, so that over
//! millions of steps the error of the energy wanders rather than grows.

use super::collocation::{Collocation, Half};
use super::fixed_point::EPSILON_AT_LEAST;
use crate::coefficient::decimal;
use crate::{Kind, Method, MethodCard, Needs, Options};
use precess_scalar::Scalar;
use precess_system::Shape;

/// See the module.
pub struct GaussLegendre16;

static CARD: MethodCard = MethodCard {
    id: "gauss_legendre16",
    title: ("Gauss-Legendre 16", "Gauss-Legendre 16"),
    about: (
        "Symplectic and symmetric for every system, of order 16, with compensated sums: for long and very accurate runs with large steps.",
        "Symplectique et symétrique pour tout système, d'ordre 16, à sommes compensées : pour les calculs longs et très précis à grands pas.",
    ),
    order: 16,
    kind: Kind::Fixed,
    needs: Needs::Any,
    symplectic: true,
    reversible: true,
    source: "Hairer, Lubich, Wanner, Geometric Numerical Integration (2006), II.1.3",
    options: &[EPSILON_AT_LEAST],
};

/// Times and weights of the first half of the stages.
const HALF: Half = &[
    (decimal("1.98550717512318841582195657152635e-2"), decimal("5.06142681451881295762656771549811e-2")),
    (decimal("0.101666761293186630204223031762085"), decimal("0.111190517226687235272177997213120")),
    (decimal("0.237233795041835507091130475405377"), decimal("0.156853322938943643668981100993301")),
    (decimal("0.408282678752175097530261928819908"), decimal("0.181341891689180991482575224638598")),
];

impl Method for GaussLegendre16 {
    fn card(&self) -> &'static MethodCard {
        &CARD
    }
    type Steps<S: Scalar> = Collocation<S>;

    fn stepper<S: Scalar>(&self, shape: &Shape, options: &Options) -> Collocation<S> {
        Collocation::new(shape, HALF, 8, true, options.epsilon)
    }
}
