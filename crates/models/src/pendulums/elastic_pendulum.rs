//! A mass on a spring that also swings.
//!
//!     l''     = l theta'^2 + g cos theta - (k / m) (l - l0) - b l'
//!     theta'' = -(g sin theta + 2 l' theta') / l - b theta'
//!
//! (P, section 9.2, where polar coordinates come from.) l0 is the natural length, which P calls the length at
//! equilibrium and then uses as the natural one: hanging at rest the spring is l0 + m g / k long. Friction is a drag of
//! b per mass.

use precess_scalar::Scalar;
use precess_system::{Card, State, System, card, coordinate, number};

/// See the module.
#[derive(Clone)]
pub struct ElasticPendulum;

impl System for ElasticPendulum {
    fn card(&self) -> Card {
        card("elastic_pendulum", "Pendulum on a spring", "Pendule à ressort")
            .about(
                "The rod of a pendulum is a spring: bouncing and swinging feed one another, and the path is a tangle.",
                "La tige du pendule est un ressort : va-et-vient et balancement s'échangent l'énergie, et la trajectoire \
                 s'embrouille.",
            )
            .source("P, section 9.2, figure 33")
            .coordinate(coordinate("l", "m", "length of the spring", "longueur du ressort").start(1.0))
            .coordinate(coordinate("theta", "rad", "angle from the downward vertical", "angle avec la verticale descendante").start_dot(0.7))
            .parameter(number("m", "kg", 0.2, "mass", "masse").positive())
            .parameter(number("k", "N/m", 0.1, "stiffness", "raideur"))
            .parameter(number("g", "m/s^2", 0.098, "gravity", "pesanteur"))
            .parameter(number("l0", "m", 1.0, "natural length", "longueur à vide").symbol("l_0"))
            .parameter(number("b", "1/s", 0.0, "friction", "frottement"))
            .invariant_if("energy", "J", &["b"], "total energy", "énergie totale")
            .signal("kinetic", "J", "kinetic energy", "énergie cinétique")
            .signal("potential", "J", "energy of the weight and the spring", "énergie du poids et du ressort")
            .signal("tension", "N", "pull of the spring", "tension du ressort")
            .signal("px", "m", "place of the mass, horizontally", "position horizontale de la masse")
            .signal("py", "m", "height of the mass", "hauteur de la masse")
            .path_view("px", "py")
            .time_view(&["l"])
            .time_view(&["theta"])
            .run(60.0, 0.001)
    }

    fn check(&self, s: &State<f64>) -> Result<(), String> {
        if s.coordinates[0] > 0.0 {
            return Ok(());
        }
        Err(format!("the length l must be above zero at the start, not {}", s.coordinates[0]))
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([l, theta], [l_dot, w], [m, k, g, l0, b]) = (s.q(), s.v(), s.p());
        let (sin, cos) = theta.sin_cos();
        highest[0] = l * w * w + g * cos - k / m * (l - l0) - b * l_dot;
        highest[1] = -((g * sin + l_dot * w * 2.0) / l) - b * w;
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let ([l, theta], [_m, k, _g, l0]) = (s.q(), s.p());
        let (kinetic, potential) = energies(s);
        let (sin, cos) = theta.sin_cos();
        out.copy_from_slice(&[kinetic + potential, kinetic, potential, k * (l - l0), l * sin, -(l * cos)]);
    }

    #[inline(always)]
    fn lagrangian<S: Scalar>(&self, s: &State<S>) -> Option<S> {
        let (kinetic, potential) = energies(s);
        let [_m, _k, _g, _l0, b] = s.p();
        Some((b * s.t).exp() * (kinetic - potential))
    }
}

#[inline(always)]
fn energies<S: Scalar>(s: &State<S>) -> (S, S) {
    let ([l, theta], [l_dot, w], [m, k, g, l0]) = (s.q(), s.v(), s.p());
    let kinetic = m * (l_dot.squared() + (l * w).squared()) * 0.5;
    (kinetic, k * (l - l0).squared() * 0.5 - m * g * l * theta.cos())
}
