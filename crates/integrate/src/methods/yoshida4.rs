//! Yoshida's symplectic method of order 4: three Verlet steps, the one in the middle backwards.
//!
//! (E. Forest, R. D. Ruth, Physica D 43, 105, 1990; H. Yoshida, Phys. Lett. A 150, 262, 1990.) The outer ones have the
//! length `1 / (2 - 2^(1/3))`.

use super::composition::Composition;
use crate::coefficient::{Coefficient, decimal};
use crate::{Kind, Method, MethodCard, Needs, Options};
use precess_scalar::Scalar;
use precess_system::Shape;

/// See the module.
pub struct Yoshida4;

static CARD: MethodCard = MethodCard {
    id: "yoshida4",
    title: ("Yoshida 4", "Yoshida 4"),
    about: (
        "Symplectic and reversible, of order 4: 3 Verlet steps of several lengths, forwards and backwards.",
        "Symplectique et réversible, d'ordre 4 : 3 pas de Verlet de longueurs diverses, en avant et en arrière.",
    ),
    order: 4,
    kind: Kind::Fixed,
    needs: Needs::Separable,
    symplectic: true,
    reversible: true,
    source: "H. Yoshida, Phys. Lett. A 150, 262 (1990)",
    options: &[],
};

/// Lengths of the Verlet steps, from the outermost inwards.
const OUTER: &[Coefficient] = &[decimal("1.35120719195965763404768780897146")];
/// Of the one in the middle.
const MIDDLE: Coefficient = decimal("-1.70241438391931526809537561794292");

impl Method for Yoshida4 {
    fn card(&self) -> &'static MethodCard {
        &CARD
    }
    type Steps<S: Scalar> = Composition<S>;

    fn stepper<S: Scalar>(&self, shape: &Shape, _: &Options) -> Composition<S> {
        Composition::new(shape, OUTER, MIDDLE)
    }
}
