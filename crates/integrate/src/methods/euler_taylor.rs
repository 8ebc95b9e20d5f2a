//! P's "improved Euler": the position to second order, the velocity to first.
//!
//!     x1 = x0 + h v0 + alpha h^2 a0        v1 = v0 + h a0
//!
//! with alpha = 1/2 (P, exercise 1; T, annex C). alpha = 0 is Euler and alpha = 1 is Euler-Cromer. With 1/2 an
//! oscillator's step has the determinant `1 + (omega h)^2 / 2`: the energy grows, an anti-damping of
//! `omega^2 h / 4`.

use super::glide::Glide;
use crate::{Kind, Method, MethodCard, Needs, OptionCard, Options};
use precess_scalar::Scalar;
use precess_system::Shape;

/// See the module.
pub struct EulerTaylor;

static CARD: MethodCard = MethodCard {
    id: "euler_taylor",
    title: ("Euler-Taylor (\"improved Euler\")", "Euler-Taylor (« Euler améliorée »)"),
    about: (
        "The method of the second course's programs: better to look at than Euler, but of first order, and it \
         gains energy.",
        "La méthode des programmes du second cours : plus belle qu'Euler à l'écran, mais d'ordre un, et elle gagne \
         de l'énergie.",
    ),
    order: 1,
    kind: Kind::Fixed,
    needs: Needs::Any,
    symplectic: false,
    reversible: false,
    source: "P, exercise 1; T, annex C",
    options: &[OptionCard {
        name: "alpha",
        default: 0.5,
        low: 0.0,
        high: 1.0,
        text: (
            "share of the acceleration in the position: 0 Euler, 1 Euler-Cromer",
            "part de l'accélération dans la position : 0 Euler, 1 Euler-Cromer",
        ),
    }],
};

impl Method for EulerTaylor {
    fn card(&self) -> &'static MethodCard {
        &CARD
    }
    type Steps<S: Scalar> = Glide<S>;

    fn stepper<S: Scalar>(&self, shape: &Shape, options: &Options) -> Glide<S> {
        Glide::new(shape, options.alpha)
    }
}
