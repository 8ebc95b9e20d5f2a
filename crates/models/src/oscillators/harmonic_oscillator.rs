//! The harmonic oscillator: what every small oscillation is.
//!
//!     x'' = -omega^2 x
//!
//! (P, section 2.) From x0 at rest, x = x0 cos(omega t); the period 2 pi / omega does not depend on x0.

use crate::linear;
use precess_scalar::Scalar;
use precess_system::{Card, State, System, card, coordinate, number};

/// See the module.
#[derive(Clone)]
pub struct HarmonicOscillator;

impl System for HarmonicOscillator {
    fn card(&self) -> Card {
        card("harmonic_oscillator", "Harmonic oscillator", "Oscillateur harmonique")
            .about(
                "The limit of every small oscillation: sinusoidal, with a period that does not depend on the amplitude.",
                "La limite de toute petite oscillation : sinusoïdale, de période indépendante de l'amplitude.",
            )
            .source("P, section 2, exercise 1.1")
            .coordinate(coordinate("x", "m", "displacement", "élongation").start(1.0))
            .parameter(number("omega", "rad/s", 1.0, "angular frequency", "pulsation").positive())
            .invariant("energy", "m^2/s^2", "energy per mass", "énergie par unité de masse")
            .time_view(&["x"])
            .phase_view("x", "x_dot")
            .run(9.0 * std::f64::consts::PI, 0.0001)
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([x], [omega]) = (s.q(), s.p());
        highest[0] = -(omega * omega * x);
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let ([x], [v], [omega]) = (s.q(), s.v(), s.p());
        out[0] = (v.squared() + (omega * x).squared()) * 0.5;
    }

    fn solvable(&self, _start: &State<f64>) -> Result<(), String> {
        Ok(())
    }

    #[inline(always)]
    fn solution<S: Scalar>(&self, start: &State<S>, t: S, q: &mut [S], v: &mut [S]) {
        let ([x], [x_dot], [omega]) = (start.q(), start.v(), start.p());
        [q[0], v[0]] = linear::free([S::from(0.0), omega * omega], t - start.t, [x, x_dot]);
    }

    #[inline(always)]
    fn lagrangian<S: Scalar>(&self, s: &State<S>) -> Option<S> {
        let ([x], [v], [omega]) = (s.q(), s.v(), s.p());
        Some((v.squared() - (omega * x).squared()) * 0.5)
    }
}
