//! A driven oscillator with a cubic force.
//!
//!     x'' = -delta x' - alpha x - beta x^3 + gamma cos(omega t)
//!
//! (G. Duffing 1918; the two wells of alpha < 0: J. Guckenheimer, P. Holmes, *Nonlinear Oscillations*, section 2.2.)

use precess_scalar::Scalar;
use precess_system::{Card, State, System, Values, card, coordinate, number};

/// See the module.
#[derive(Clone)]
pub struct Duffing;

impl System for Duffing {
    fn card(&self) -> Card {
        card("duffing", "Duffing's oscillator", "Oscillateur de Duffing")
            .about(
                "A driven particle in two wells. It leaps from one to the other without a rule, and its section at the \
                 drive's period is a strange attractor.",
                "Une particule forcée dans deux puits. Elle saute de l'un à l'autre sans règle, et sa section à la période \
                 de l'excitation est un attracteur étrange.",
            )
            .source("Guckenheimer and Holmes, Nonlinear Oscillations, section 2.2")
            .coordinate(coordinate("x", "", "displacement", "élongation"))
            .parameter(number("delta", "", 0.3, "friction", "frottement"))
            .parameter(number("alpha", "", -1.0, "linear stiffness", "raideur linéaire"))
            .parameter(number("beta", "", 1.0, "cubic stiffness", "raideur cubique"))
            .parameter(number("gamma", "", 0.5, "strength of the drive", "amplitude de l'excitation"))
            .parameter(number("omega", "", 1.2, "angular frequency of the drive", "pulsation de l'excitation"))
            .invariant_if("energy", "", &["delta", "gamma"], "energy per mass", "énergie par unité de masse")
            .signal("kinetic", "", "kinetic energy per mass", "énergie cinétique par unité de masse")
            .signal("potential", "", "potential energy per mass", "énergie potentielle par unité de masse")
            .phase_view("x", "x_dot")
            .time_view(&["x"])
            .run(200.0, 0.002)
    }

    fn period(&self, values: &Values<f64>) -> Option<f64> {
        Some(std::f64::consts::TAU / values.numbers[4].abs())
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([x], [v], [delta, alpha, beta, gamma, omega]) = (s.q(), s.v(), s.p());
        highest[0] = gamma * (omega * s.t).cos() - delta * v - x * (alpha + beta * x * x);
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let [v] = s.v();
        let (kinetic, potential) = (v.squared() * 0.5, potential(s));
        out.copy_from_slice(&[kinetic + potential, kinetic, potential]);
    }

    #[inline(always)]
    fn lagrangian<S: Scalar>(&self, s: &State<S>) -> Option<S> {
        let ([x], [v], [delta, _, _, gamma, omega]) = (s.q(), s.v(), s.p());
        let still = v.squared() * 0.5 - potential(s);
        Some((delta * s.t).exp() * (still + gamma * (omega * s.t).cos() * x))
    }
}

#[inline(always)]
fn potential<S: Scalar>(s: &State<S>) -> S {
    let ([x], [_delta, alpha, beta]) = (s.q(), s.p());
    let square = x * x;
    square * (alpha * 0.5 + beta * square * 0.25)
}
