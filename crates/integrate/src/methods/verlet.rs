//! Velocity Verlet: half a kick, a drift, half a kick.
//!
//!     v = v0 + h/2 a(x0)     x1 = x0 + h v     v1 = v + h/2 a(x1)
//!
//! (Verlet 1967; Swope et al. 1982.) Of order 2, symplectic and reversible; one evaluation a step.

use super::composition::Composition;
use crate::coefficient::ratio;
use crate::{Kind, Method, MethodCard, Needs, Options};
use precess_scalar::Scalar;
use precess_system::Shape;

/// See the module.
pub struct Verlet;

static CARD: MethodCard = MethodCard {
    id: "verlet",
    title: ("Velocity Verlet", "Verlet (vitesses)"),
    about: (
        "Symplectic, reversible and as cheap as Euler: the method for planets and pendulums without friction.",
        "Symplectique, réversible et aussi peu coûteuse qu'Euler : la méthode des planètes et des pendules sans \
         frottement.",
    ),
    order: 2,
    kind: Kind::Fixed,
    needs: Needs::Separable,
    symplectic: true,
    reversible: true,
    source: "L. Verlet, Phys. Rev. 159, 98 (1967)",
    options: &[],
};

impl Method for Verlet {
    fn card(&self) -> &'static MethodCard {
        &CARD
    }
    type Steps<S: Scalar> = Composition<S>;

    fn stepper<S: Scalar>(&self, shape: &Shape, _: &Options) -> Composition<S> {
        Composition::new(shape, &[], ratio(1, 1))
    }
}
