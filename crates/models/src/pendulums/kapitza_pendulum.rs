//! A pendulum whose pivot is shaken up and down.
//!
//!     theta'' = -(g / l - (a alpha^2 / l) sin(alpha t)) sin theta - b theta'
//!
//! (P, exercise 6.1, with the whole sine; P. L. Kapitza 1951; Landau, Lifshitz, *Mechanics*, section 30, problem 1.) The
//! pivot is at the height a sin(alpha t). Shaken fast it stands on its head: stable where a^2 alpha^2 > 2 g l.

use precess_scalar::Scalar;
use precess_system::{Card, State, System, Values, card, coordinate, number};

/// See the module.
#[derive(Clone)]
pub struct KapitzaPendulum;

impl System for KapitzaPendulum {
    fn card(&self) -> Card {
        card("kapitza_pendulum", "Kapitza's pendulum", "Pendule de Kapitza")
            .about(
                "A rod whose pivot is shaken fast enough stands on its head, and swings about the top.",
                "Une tige dont le pivot est secoué assez vite tient debout sur sa tête, et oscille autour du sommet.",
            )
            .source("P, exercise 6.1; Landau and Lifshitz, Mechanics, section 30")
            .coordinate(coordinate("theta", "rad", "angle from the downward vertical", "angle avec la verticale descendante").start(3.0))
            .parameter(number("l", "m", 1.0, "length of the rod", "longueur de la tige").positive())
            .parameter(number("g", "m/s^2", 9.81, "gravity", "pesanteur"))
            .parameter(number("a", "m", 0.1, "amplitude of the pivot", "amplitude du pivot"))
            .parameter(number("alpha", "rad/s", 100.0, "angular frequency of the pivot", "pulsation du pivot"))
            .parameter(number("b", "1/s", 0.0, "friction", "frottement"))
            .invariant_if("energy", "m^2/s^2", &["a", "b"], "energy per mass", "énergie par unité de masse")
            .signal("pivot", "m", "height of the pivot", "hauteur du pivot")
            .signal("px", "m", "place of the mass, horizontally", "position horizontale de la masse")
            .signal("py", "m", "height of the mass", "hauteur de la masse")
            .time_view(&["theta"])
            .phase_view("theta", "theta_dot")
            .run(10.0, 0.0001)
    }

    fn period(&self, values: &Values<f64>) -> Option<f64> {
        Some(std::f64::consts::TAU / values.numbers[3].abs())
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([theta], [w], [l, g, a, alpha, b]) = (s.q(), s.v(), s.p());
        let weight = g - a * alpha * alpha * (alpha * s.t).sin();
        highest[0] = -(weight / l * theta.sin()) - b * w;
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let ([theta], [l, _g, a, alpha]) = (s.q(), s.p());
        let (kinetic, potential) = energies(s);
        let pivot = a * (alpha * s.t).sin();
        let (sin, cos) = theta.sin_cos();
        out.copy_from_slice(&[kinetic + potential, pivot, l * sin, pivot - l * cos]);
    }

    #[inline(always)]
    fn lagrangian<S: Scalar>(&self, s: &State<S>) -> Option<S> {
        let (kinetic, potential) = energies(s);
        Some(kinetic - potential)
    }
}

/// Per mass, the pivot's motion included.
#[inline(always)]
fn energies<S: Scalar>(s: &State<S>) -> (S, S) {
    let ([theta], [w], [l, g, a, alpha]) = (s.q(), s.v(), s.p());
    let (sin, cos) = theta.sin_cos();
    let (pivot, beat) = (alpha * s.t).sin_cos();
    let (x_dot, y_dot) = (l * w * cos, a * alpha * beat + l * w * sin);
    ((x_dot.squared() + y_dot.squared()) * 0.5, g * (a * pivot - l * cos))
}
