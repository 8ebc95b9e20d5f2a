//! Yoshida's symplectic method of order 6: seven Verlet steps.
//!
//! (H. Yoshida, Phys. Lett. A 150, 262, 1990, table 1, solution A.) His 14 digits were taken to 33 by Newton's method on the
//! conditions of order, in the free Lie algebra.

use super::composition::Composition;
use crate::coefficient::{Coefficient, decimal};
use crate::{Kind, Method, MethodCard, Needs, Options};
use precess_scalar::Scalar;
use precess_system::Shape;

/// See the module.
pub struct Yoshida6;

static CARD: MethodCard = MethodCard {
    id: "yoshida6",
    title: ("Yoshida 6", "Yoshida 6"),
    about: (
        "Symplectic and reversible, of order 6: 7 Verlet steps of several lengths, forwards and backwards.",
        "Symplectique et réversible, d'ordre 6 : 7 pas de Verlet de longueurs diverses, en avant et en arrière.",
    ),
    order: 6,
    kind: Kind::Fixed,
    needs: Needs::Separable,
    symplectic: true,
    reversible: true,
    source: "H. Yoshida, Phys. Lett. A 150, 262 (1990)",
    options: &[],
};

/// Lengths of the Verlet steps, from the outermost inwards.
const OUTER: &[Coefficient] = &[
    decimal("7.84513610477557263819497633866350e-1"),
    decimal("2.35573213359358133684793182978535e-1"),
    decimal("-1.17767998417887100694641568096432"),
];
/// Of the one in the middle.
const MIDDLE: Coefficient = decimal("1.31518632068391121888424972823886");

impl Method for Yoshida6 {
    fn card(&self) -> &'static MethodCard {
        &CARD
    }
    type Steps<S: Scalar> = Composition<S>;

    fn stepper<S: Scalar>(&self, shape: &Shape, _: &Options) -> Composition<S> {
        Composition::new(shape, OUTER, MIDDLE)
    }
}
