//! A mass on a rigid rod, swinging in a vertical plane.
//!
//!     theta'' = -b theta' - b2 theta' |theta'| - dry sign(theta') - (g / l) sin theta
//!
//! (P, sections 1, 3, 7 and 9.1.) The energy m l^2 theta'^2 / 2 - m g l cos theta is constant without
//! friction; the rod pulls with m l theta'^2 + m g cos theta, and a string in its place goes slack where
//! that vanishes.

use super::swing::swing;
use precess_scalar::Scalar;
use precess_system::{Card, State, System, card, coordinate, number};

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
            .invariant_if("energy", "J", &FRICTIONLESS, "total energy", "énergie totale")
            .signal("kinetic", "J", "kinetic energy", "énergie cinétique")
            .signal("potential", "J", "potential energy, zero at the pivot's height", "énergie potentielle, nulle à la hauteur du pivot")
            .signal("tension", "N", "pull of the rod", "tension de la tige")
            .time_view(&["theta"])
            .phase_view("theta", "theta_dot")
            .run(20.0, 0.001)
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([theta], [w], [_m, l, g, b, b2, dry]) = (s.q(), s.v(), s.p());
        highest[0] = -(b * w) - b2 * w * w.abs() - dry * w.sign() - g / l * theta.sin();
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let ([theta], [w], [m, l, g]) = (s.q(), s.v(), s.p());
        let kinetic = m * l * l * w * w * 0.5;
        let potential = -(m * g * l * theta.cos());
        let tension = m * l * w * w + m * g * theta.cos();
        out.copy_from_slice(&[kinetic + potential, kinetic, potential, tension]);
    }

    fn solvable(&self, start: &State<f64>) -> Result<(), String> {
        let [_m, _l, _g, friction @ ..] = start.p::<6>();
        if friction == [0.0; 3] {
            Ok(())
        } else {
            Err("the pendulum has a closed form without friction only".into())
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
        Some(m * l * l * w * w * 0.5 + m * g * l * theta.cos())
    }
}
