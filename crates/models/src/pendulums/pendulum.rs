//! A mass on a rigid rod, or on a string, swinging in a vertical plane.
//!
//!     theta'' = -b theta' - b2 theta' |theta'| - dry sign(theta') - (g / l) sin theta
//!
//! (P, sections 1, 3, 7 and 9.1.) The energy m l^2 theta'^2 / 2 - m g l cos theta is constant without friction; the rod
//! pulls with m l theta'^2 + m g cos theta.
//!
//! A string in place of the rod goes slack where that vanishes (at 131.81 degrees on the way up, with the energy m g l), and
//! the mass flies, as a stone does, until the string is taut again: the motion along it ends there in a jerk, and its energy
//! is lost. Dry friction holds the pendulum fast where it stops and gravity is the weaker. Both are modes that events
//! change (see `hold`).

use super::hold::{self, Hold};
use super::swing::swing;
use precess_scalar::Scalar;
use precess_system::{Card, Given, Layout, State, System, Values, card, choice, coordinate, number};

/// See the module.
#[derive(Clone)]
pub struct Pendulum;

const FRICTIONLESS: [&str; 3] = ["b", "b2", "dry"];

impl System for Pendulum {
    fn card(&self) -> Card {
        card("pendulum", "Pendulum", "Pendule")
            .about(
                "A mass on a rigid rod. Small swings are sinusoidal; near the top the period grows without bound.",
                "Une masse au bout d'une tige rigide. Les petites oscillations sont sinusoïdales ; près du sommet \
                 la période croît sans limite.",
            )
            .source("P, sections 1-3, 7 and 9.1, exercises 2, 3 and 11")
            .coordinate(
                coordinate("theta", "rad", "angle from the downward vertical", "angle avec la verticale descendante")
                    .start(1.0),
            )
            .parameter(number("m", "kg", 1.0, "mass", "masse").positive())
            .parameter(number("l", "m", 1.0, "length of the rod", "longueur de la tige").positive())
            .parameter(number("g", "m/s^2", 9.81, "gravity", "pesanteur"))
            .parameter(number("b", "1/s", 0.0, "linear friction", "frottement linéaire"))
            .parameter(number("b2", "1", 0.0, "quadratic friction", "frottement quadratique").not_negative())
            .parameter(number("dry", "1/s^2", 0.0, "dry friction", "frottement sec").not_negative())
            .parameter(choice(
                "string",
                &["false", "true"],
                "a string instead of the rod: it pulls and cannot push",
                "un fil au lieu de la tige : il tire et ne peut pousser",
            ))
            .invariant_if("energy", "J", &FRICTIONLESS, "total energy", "énergie totale")
            .signal("kinetic", "J", "kinetic energy", "énergie cinétique")
            .signal("potential", "J", "potential energy, zero at the pivot's height", "énergie potentielle, nulle à la hauteur du pivot")
            .signal("tension", "N", "pull of the rod", "tension de la tige")
            .time_view(&["theta"])
            .phase_view("theta", "theta_dot")
            .run(20.0, 0.001)
    }

    fn layout(&self, values: &Values<f64>, _given: &Given) -> Layout {
        hold::layout(Layout::of(&self.card()), values)
    }

    fn start(&self, given: &Given, values: &Values<f64>, y: &mut [f64]) -> Result<(), String> {
        hold::start(given, values, y)
    }

    fn start_modes(&self, s: &State<f64>, modes: &mut [f64]) {
        hold::start_modes(s, modes);
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([theta], [w], [_m, l, g, b, b2, dry]) = (s.q(), s.v(), s.p());
        let hold = Hold::of(s);
        let rub = hold.map_or(w.sign(), |hold| hold.slip);
        highest[0] = -(b * w) - b2 * w * w.abs() - dry * rub - g / l * theta.sin();
        if let Some(hold) = hold {
            hold.correct(s, highest);
        }
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let ([theta], [w], [m, l, g]) = (s.q(), s.v(), s.p());
        let hold = Hold::of(s);
        let [r, r_dot] = hold::along(s);
        let kinetic = m * r * r * w * w * 0.5;
        let kinetic = if s.coordinates.len() > 1 { kinetic + m * r_dot * r_dot * 0.5 } else { kinetic };
        let potential = -(m * g * r * theta.cos());
        let tension = m * l * w * w + m * g * theta.cos();
        let tension = hold.map_or(tension, |hold| hold.tension(s, tension));
        let sums = [kinetic + potential, kinetic, potential, tension];
        let (plain, more) = out.split_at_mut(sums.len());
        plain.copy_from_slice(&sums);
        if let Some(hold) = hold {
            hold.observe(s, sums[0], more);
        }
    }

    fn solvable(&self, start: &State<f64>) -> Result<(), String> {
        let [_m, _l, _g, friction @ ..] = start.p::<6>();
        match () {
            () if friction != [0.0; 3] => Err("the pendulum has a closed form without friction only".into()),
            () if start.choice(0) == hold::STRING => Err("a string goes slack: the rod has one".into()),
            () => Ok(()),
        }
    }

    #[inline(always)]
    fn solution<S: Scalar>(&self, start: &State<S>, t: S, q: &mut [S], v: &mut [S]) {
        let ([theta], [w], [_m, l, g]) = (start.q(), start.v(), start.p());
        [q[0], v[0]] = swing(g / l, t - start.t, [theta, w]);
    }

    #[inline(always)]
    fn lagrangian<S: Scalar>(&self, s: &State<S>) -> Option<S> {
        let ([theta], [w], [m, l, g]) = (s.q(), s.v(), s.p());
        // Of the rod alone.
        (s.coordinates.len() == 1).then(|| m * l * l * w * w * 0.5 + m * g * l * theta.cos())
    }

    #[inline(always)]
    fn crossings<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        if let Some(hold) = Hold::of(s) {
            hold.crossings(s, out);
        }
    }

    #[inline(always)]
    fn jump<S: Scalar>(&self, event: usize, s: &State<S>, y: &mut [S]) {
        if let Some(hold) = Hold::of(s) {
            hold.jump(event, s, y);
        }
    }
}
