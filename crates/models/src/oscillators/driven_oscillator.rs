//! A damped oscillator that is driven by a sine.
//!
//!     x'' = -p x' - q x + amplitude sin(frequency t)
//!
//! (P, exercise 6.3.) Without the drive it oscillates where p^2 < 4 q and creeps where p^2 > 4 q. Driven, it settles to
//! the amplitude A / sqrt((q - f^2)^2 + (p f)^2), which is largest at f^2 = q - p^2 / 2: the resonance.

use crate::complex::Complex;
use crate::linear;
use precess_scalar::Scalar;
use precess_system::{Card, State, System, Values, card, coordinate, number};

/// See the module.
#[derive(Clone)]
pub struct DrivenOscillator;

impl System for DrivenOscillator {
    fn card(&self) -> Card {
        card("driven_oscillator", "Driven oscillator", "Oscillateur forcé")
            .about(
                "A damped oscillator under a sinusoidal force: its own oscillation dies away, what is left follows the \
                 drive, and grows huge at the resonance.",
                "Un oscillateur amorti sous une force sinusoïdale : son oscillation propre s'éteint, ce qui reste suit \
                 l'excitation, et devient énorme à la résonance.",
            )
            .source("P, exercise 6.3, figures 18 to 20")
            .coordinate(coordinate("x", "", "displacement", "élongation").start_dot(0.1))
            .parameter(number("p", "", 0.1, "friction", "frottement"))
            .parameter(number("q", "", 1.0, "stiffness", "raideur"))
            .parameter(number("amplitude", "", 1.0, "strength of the drive", "amplitude de l'excitation").symbol("A"))
            .parameter(number("frequency", "", 8.0, "angular frequency of the drive", "pulsation de l'excitation").symbol("f"))
            .invariant_if("energy", "", &["p", "amplitude"], "energy per mass", "énergie par unité de masse")
            .signal("drive", "", "force of the drive per mass", "force d'excitation par unité de masse")
            .signal("steady", "", "amplitude of the steady oscillation", "amplitude du régime permanent")
            .time_view(&["x"])
            .phase_view("x", "x_dot")
            .run(60.0, 0.0001)
    }

    fn period(&self, values: &Values<f64>) -> Option<f64> {
        Some(std::f64::consts::TAU / values.numbers[3].abs())
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([x], [v], [p, q]) = (s.q(), s.v(), s.p());
        highest[0] = drive(s) - p * v - q * x;
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let ([x], [v], [p, q, amplitude, frequency]) = (s.q(), s.v(), s.p());
        let energy = (v.squared() + q * x.squared()) * 0.5;
        let response = ((q - frequency.squared()).squared() + (p * frequency).squared()).sqrt();
        out.copy_from_slice(&[energy, drive(s), amplitude.abs() / response]);
    }

    fn solvable(&self, _start: &State<f64>) -> Result<(), String> {
        Ok(())
    }

    #[inline(always)]
    fn solution<S: Scalar>(&self, start: &State<S>, t: S, q: &mut [S], v: &mut [S]) {
        let ([x], [x_dot], [p, k, amplitude, frequency]) = (start.q(), start.v(), start.p());
        let time = t - start.t;
        let force = Complex::imaginary(frequency * start.t).exp().scaled(amplitude);
        [q[0], v[0]] = linear::driven([p, k], time, [x, x_dot], force, frequency);
    }

    #[inline(always)]
    fn lagrangian<S: Scalar>(&self, s: &State<S>) -> Option<S> {
        let ([x], [v], [p, q]) = (s.q(), s.v(), s.p());
        Some((p * s.t).exp() * ((v.squared() - q * x.squared()) * 0.5 + drive(s) * x))
    }
}

#[inline(always)]
fn drive<S: Scalar>(s: &State<S>) -> S {
    let [_p, _q, amplitude, frequency] = s.p();
    amplitude * (frequency * s.t).sin()
}
