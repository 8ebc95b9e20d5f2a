//! Euler-Cromer: the velocity first, then the position with the new velocity.
//!
//!     v1 = v0 + h a(t0, x0, v0)        x1 = x0 + h v1
//!
//! (T 5.2; A. Cromer, Am. J. Phys. 49, 455, 1981.) Symplectic where accelerations depend on positions alone;
//! elsewhere its energy error grows. A first-order coordinate follows the velocity's formula, which is Euler's
//! (T 5.2.2).

use super::glide::Glide;
use crate::{Kind, Method, MethodCard, Needs, Options};
use precess_scalar::Scalar;
use precess_system::Shape;

/// See the module.
pub struct EulerCromer;

static CARD: MethodCard = MethodCard {
    id: "euler_cromer",
    title: ("Euler-Cromer", "Euler-Cromer"),
    about: (
        "As cheap as Euler, and symplectic where forces depend on positions alone: the energy oscillates but \
         stays.",
        "Aussi simple qu'Euler, et symplectique quand les forces ne dépendent que des positions : l'énergie \
         oscille mais se conserve en moyenne.",
    ),
    order: 1,
    kind: Kind::Fixed,
    needs: Needs::Any,
    symplectic: true,
    reversible: false,
    source: "T 5.2; A. Cromer, Am. J. Phys. 49, 455 (1981)",
    options: &[],
};

impl Method for EulerCromer {
    fn card(&self) -> &'static MethodCard {
        &CARD
    }
    type Steps<S: Scalar> = Glide<S>;

    fn stepper<S: Scalar>(&self, shape: &Shape, _: &Options) -> Glide<S> {
        Glide::new(shape, 1.0)
    }
}
