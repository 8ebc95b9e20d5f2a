//! A damped pendulum that is driven by a torque.
//!
//!     theta'' = -b theta' - sin theta + f cos(omega t)
//!
//! (G. Baker, J. Gollub, *Chaotic Dynamics*, chapter 3: b = 1/2, omega = 2/3, f from 0.9 to 1.5.)

use precess_scalar::Scalar;
use precess_system::{Card, State, System, Values, card, coordinate, number};

/// See the module.
#[derive(Clone)]
pub struct DrivenPendulum;

impl System for DrivenPendulum {
    fn card(&self) -> Card {
        card("driven_pendulum", "Driven pendulum", "Pendule forcé")
            .about(
                "A damped pendulum under a periodic torque: with a growing torque its period doubles again and again until \
                 it tumbles without a rule.",
                "Un pendule amorti sous un couple périodique : quand le couple croît, sa période double encore et encore, \
                 jusqu'à ce qu'il culbute sans règle.",
            )
            .source("Baker and Gollub, Chaotic Dynamics, chapter 3")
            .coordinate(coordinate("theta", "", "angle from the downward vertical", "angle avec la verticale descendante"))
            .parameter(number("b", "", 0.5, "friction", "frottement"))
            .parameter(number("f", "", 1.2, "torque of the drive", "couple d'excitation"))
            .parameter(number("omega", "", 2.0 / 3.0, "angular frequency of the drive", "pulsation de l'excitation"))
            .invariant_if("energy", "", &["b", "f"], "energy", "énergie")
            .signal("drive", "", "torque of the drive", "couple d'excitation")
            .phase_view("theta", "theta_dot")
            .time_view(&["theta"])
            .run(200.0, 0.002)
    }

    fn period(&self, values: &Values<f64>) -> Option<f64> {
        Some(std::f64::consts::TAU / values.numbers[2].abs())
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([theta], [w], [b]) = (s.q(), s.v(), s.p());
        highest[0] = drive(s) - b * w - theta.sin();
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let ([theta], [w]) = (s.q(), s.v());
        out.copy_from_slice(&[w.squared() * 0.5 - theta.cos(), drive(s)]);
    }

    #[inline(always)]
    fn lagrangian<S: Scalar>(&self, s: &State<S>) -> Option<S> {
        let ([theta], [w], [b]) = (s.q(), s.v(), s.p());
        Some((b * s.t).exp() * (w.squared() * 0.5 + theta.cos() + drive(s) * theta))
    }
}

#[inline(always)]
fn drive<S: Scalar>(s: &State<S>) -> S {
    let [_b, f, omega] = s.p();
    f * (omega * s.t).cos()
}
