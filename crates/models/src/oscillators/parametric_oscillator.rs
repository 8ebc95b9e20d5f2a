//! An oscillator whose stiffness is shaken: a pendulum with small swings whose pivot moves up and down.
//!
//!     x'' = -omega^2 (1 - h sin(alpha t)) x                                              direct
//!     x'' = -omega^2 (1 - phi) x,    phi'' = -alpha^2 phi                                coupled
//!
//! (P, exercise 6.1.) Mathieu's equation: with the pivot at a sin(alpha t), h = a alpha^2 / g. P writes it as two
//! oscillators of which the second drives the first; phi starts as h sin(alpha t) unless a start says otherwise. P calls
//! it chaotic: it is linear, so its exponents are Floquet's, and no solution is chaotic. It grows without bound where
//! alpha is close to 2 omega / n.

use precess_scalar::Scalar;
use precess_system::{
    Card, Coordinate, Given, Layout, State, System, Values, card, choice, coordinate, number,
};

/// See the module.
#[derive(Clone)]
pub struct ParametricOscillator;

const COUPLED: usize = 1;

/// The pivot's motion as a coordinate of its own.
fn phi() -> Coordinate {
    coordinate("phi", "", "motion of the pivot", "mouvement du pivot")
}

impl System for ParametricOscillator {
    fn card(&self) -> Card {
        card("parametric_oscillator", "Parametric oscillator", "Oscillateur paramétrique")
            .about(
                "A pendulum with small swings whose pivot is shaken up and down. Near alpha = 2 omega it swings itself up; \
                 elsewhere the trace fills a band of the phase plane.",
                "Un pendule aux petites oscillations dont le pivot est secoué de haut en bas. Près de alpha = 2 omega il \
                 s'amplifie sans limite ; ailleurs la trace remplit une bande du plan de phase.",
            )
            .source("P, exercise 6.1, figure 16")
            .coordinate(coordinate("x", "", "displacement", "élongation").start_dot(0.2))
            .parameter(number("omega", "", 1.0, "angular frequency at rest", "pulsation au repos"))
            .parameter(number("h", "", 0.4 / 4.7, "strength of the shaking", "intensité de la secousse"))
            .parameter(number("alpha", "", 4.7, "angular frequency of the shaking", "pulsation de la secousse"))
            .parameter(choice(
                "form",
                &["direct", "coupled"],
                "the shaking as a function of time, or as a second oscillator",
                "la secousse comme fonction du temps, ou comme deuxième oscillateur",
            ))
            .invariant_if("energy", "", &["h"], "energy per mass, pivot at rest", "énergie par unité de masse, pivot au repos")
            .signal("shake", "", "the shaking, h sin(alpha t)", "la secousse, h sin(alpha t)")
            .phase_view("x", "x_dot")
            .time_view(&["x"])
            .run(300.0, 0.001)
    }

    fn period(&self, values: &Values<f64>) -> Option<f64> {
        // As two oscillators it has no clock.
        (values.choices[0] != COUPLED).then(|| std::f64::consts::TAU / values.numbers[2].abs())
    }

    fn layout(&self, values: &Values<f64>, _given: &Given) -> Layout {
        let mut layout = Layout::of(&self.card());
        if values.choices[0] == COUPLED {
            layout.coordinates.push(phi());
            // Its energy is now at the mercy of a start.
            layout.observables[0].kind = precess_system::ObservableKind::Signal;
        }
        layout
    }

    fn start(&self, given: &Given, values: &Values<f64>, y: &mut [f64]) -> Result<(), String> {
        if values.choices[0] == COUPLED && given.get("phi_dot").is_none() {
            y[3] = values.numbers[1] * values.numbers[2];
        }
        Ok(())
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([x], [omega, _h, alpha]) = (s.q(), s.p());
        highest[0] = -(omega * omega * (S::from(1.0) - shake(s)) * x);
        if let Some(phi) = highest.get_mut(1) {
            *phi = -(alpha * alpha * s.coordinates[1]);
        }
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let ([x], [v], [omega]) = (s.q(), s.v(), s.p());
        out.copy_from_slice(&[(v.squared() + (omega * x).squared()) * 0.5, shake(s)]);
    }

    #[inline(always)]
    fn lagrangian<S: Scalar>(&self, s: &State<S>) -> Option<S> {
        let ([x], [v], [omega]) = (s.q(), s.v(), s.p());
        // A coupling that acts one way only has no Lagrangian.
        let direct = s.choice(0) != COUPLED;
        direct.then(|| (v.squared() - omega * omega * (S::from(1.0) - shake(s)) * x * x) * 0.5)
    }
}

#[inline(always)]
fn shake<S: Scalar>(s: &State<S>) -> S {
    let [_omega, h, alpha] = s.p();
    if s.choice(0) == COUPLED { s.coordinates[1] } else { h * (alpha * s.t).sin() }
}
