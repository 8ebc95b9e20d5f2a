//! A valley and a hill: a particle in a potential of the third degree, with friction.
//!
//!     x'' = -b x' - x + x^2,      U(x) = x^2 / 2 - x^3 / 3
//!
//! (P, exercise 4.) The valley at 0 catches spirals, the hill at 1 is a saddle of height 1/6; what passes it is lost.

use precess_scalar::Scalar;
use precess_system::{Card, State, System, card, coordinate, number};

/// See the module.
#[derive(Clone)]
pub struct CubicWell;

impl System for CubicWell {
    fn card(&self) -> Card {
        card("cubic_well", "Valley and hill", "Puits et bosse de potentiel")
            .about(
                "A valley beside a hill: trajectories wind into the valley, or pass the hill and leave for ever.",
                "Une vallée à côté d'une bosse : les trajectoires s'enroulent dans la vallée, ou passent la bosse et \
                 s'en vont à l'infini.",
            )
            .source("P, exercise 4, figures 12 to 14")
            .coordinate(coordinate("x", "", "position", "position").start(0.5))
            .parameter(number("b", "", 0.17, "friction", "frottement"))
            .invariant_if("energy", "", &["b"], "energy per mass", "énergie par unité de masse")
            .signal("kinetic", "", "kinetic energy per mass", "énergie cinétique par unité de masse")
            .signal("potential", "", "potential energy per mass", "énergie potentielle par unité de masse")
            .phase_view("x", "x_dot")
            .time_view(&["x"])
            .run(40.0, 0.001)
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([x], [v], [b]) = (s.q(), s.v(), s.p());
        highest[0] = -(b * v) - x + x * x;
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let ([x], [v]) = (s.q(), s.v());
        let (kinetic, potential) = (v.squared() * 0.5, height(x));
        out.copy_from_slice(&[kinetic + potential, kinetic, potential]);
    }

    #[inline(always)]
    fn lagrangian<S: Scalar>(&self, s: &State<S>) -> Option<S> {
        let ([x], [v], [b]) = (s.q(), s.v(), s.p());
        Some((b * s.t).exp() * (v.squared() * 0.5 - height(x)))
    }
}

#[inline(always)]
fn height<S: Scalar>(x: S) -> S {
    x * x * (S::from(0.5) - x / 3.0)
}
