//! Yoshida's symplectic method of order 8: fifteen Verlet steps.
//!
//! (H. Yoshida, Phys. Lett. A 150, 262, 1990, table 2, solution D.) His 14 digits were taken to 33 by Newton's method on the
//! conditions of order, in the free Lie algebra.

use super::composition::Composition;
use crate::coefficient::{Coefficient, decimal};
use crate::{Kind, Method, MethodCard, Needs, Options};
use precess_scalar::Scalar;
use precess_system::Shape;

/// See the module.
pub struct Yoshida8;

static CARD: MethodCard = MethodCard {
    id: "yoshida8",
    title: ("Yoshida 8", "Yoshida 8"),
    about: (
        "Symplectic and reversible, of order 8: 15 Verlet steps of several lengths, forwards and backwards.",
        "Symplectique et réversible, d'ordre 8 : 15 pas de Verlet de longueurs diverses, en avant et en arrière.",
    ),
    order: 8,
    kind: Kind::Fixed,
    needs: Needs::Separable,
    symplectic: true,
    reversible: true,
    source: "H. Yoshida, Phys. Lett. A 150, 262 (1990)",
    options: &[],
};

/// Lengths of the Verlet steps, from the outermost inwards.
const OUTER: &[Coefficient] = &[
    decimal("9.14844246229791566748793489847510e-1"),
    decimal("2.53693336566211354146146020689942e-1"),
    decimal("-1.44485223686060515769473065753739"),
    decimal("-1.58240635368050175204066776759754e-1"),
    decimal("1.93813913762252598657918648744364"),
    decimal("-1.96061023297531080760763337639966"),
    decimal("1.02799849391796440698115131601226e-1"),
];
/// Of the one in the middle.
const MIDDLE: Coefficient = decimal("1.70845307078728158466837936222898");

impl Method for Yoshida8 {
    fn card(&self) -> &'static MethodCard {
        &CARD
    }
    type Steps<S: Scalar> = Composition<S>;

    fn stepper<S: Scalar>(&self, shape: &Shape, _: &Options) -> Composition<S> {
        Composition::new(shape, OUTER, MIDDLE)
    }
}
