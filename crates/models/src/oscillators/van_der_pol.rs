//! The oscillator that keeps itself going.
//!
//!     x'' = b0 (1 - x^2 / x0^2) x' - omega^2 x
//!
//! (P, section 8, exercise 5; B. van der Pol, Phil. Mag. 2, 978, 1926.) Friction is negative below x0 and positive
//! above, so all trajectories wind onto one closed curve. P's short form x'' = (e - x^2) x' - x is b0 = e,
//! x0 = sqrt(e). For small b0 the amplitude is 2 x0, and the period 2 pi / omega (1 + b0^2 / (16 omega^2)).

use precess_scalar::Scalar;
use precess_system::{Card, State, System, card, coordinate, number};

/// See the module.
#[derive(Clone)]
pub struct VanDerPol;

impl System for VanDerPol {
    fn card(&self) -> Card {
        card("van_der_pol", "Van der Pol's oscillator", "Oscillateur de Van der Pol")
            .about(
                "Small oscillations are fed, large ones damped: every start winds onto the same limit cycle, round for \
                 small b0, angular for large.",
                "Les petites oscillations sont entretenues, les grandes freinées : tout départ s'enroule sur le même \
                 cycle limite, rond pour b0 petit, anguleux pour b0 grand.",
            )
            .source("P, section 8, exercise 5, figure 15")
            .coordinate(coordinate("x", "", "displacement", "élongation").start(0.05).start_dot(0.05))
            .parameter(number("b0", "", 1.0, "strength of the negative friction", "intensité du frottement négatif"))
            .parameter(number("x0", "", 1.0, "displacement where friction changes its sign", "élongation où le frottement change de signe").positive())
            .parameter(number("omega", "", 1.0, "angular frequency without friction", "pulsation sans frottement"))
            .invariant_if("energy", "", &["b0"], "energy per mass", "énergie par unité de masse")
            .signal("gain", "", "power fed per mass", "puissance fournie par unité de masse")
            .phase_view("x", "x_dot")
            .time_view(&["x"])
            .run(60.0, 0.003)
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([x], [_, _, omega]) = (s.q(), s.p::<3>());
        highest[0] = push(s) - omega * omega * x;
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let ([x], [v], [_b0, _x0, omega]) = (s.q(), s.v(), s.p());
        out.copy_from_slice(&[(v.squared() + (omega * x).squared()) * 0.5, push(s) * v]);
    }

    #[inline(always)]
    fn lagrangian<S: Scalar>(&self, s: &State<S>) -> Option<S> {
        let ([x], [v], [_b0, _x0, omega]) = (s.q(), s.v(), s.p());
        Some((v.squared() - (omega * x).squared()) * 0.5)
    }
}

/// The negative friction.
#[inline(always)]
fn push<S: Scalar>(s: &State<S>) -> S {
    let ([x], [v], [b0, x0]) = (s.q(), s.v(), s.p());
    b0 * (S::from(1.0) - x * x / (x0 * x0)) * v
}
