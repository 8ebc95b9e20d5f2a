//! Atwood's machine whose lighter mass swings.
//!
//!     (1 + mu) r'' = r theta'^2 + g (cos theta - mu)
//!     r theta''    = -g sin theta - 2 r' theta'
//!
//! (N. Tufillaro, T. Abbott, D. Griffiths, Am. J. Phys. 52, 895, 1984.) mu is the heavy mass over the swinging one, r the
//! free length of the string. Integrable for mu = 3 alone, where `tufillaro` is constant too (N. Tufillaro, Am. J. Phys.
//! 54, 142, 1986); chaotic for most others.

use precess_scalar::Scalar;
use precess_system::{Card, State, System, card, coordinate, number};

/// See the module.
#[derive(Clone)]
pub struct SwingingAtwood;

impl System for SwingingAtwood {
    fn card(&self) -> Card {
        card("swinging_atwood", "Swinging Atwood's machine", "Machine d'Atwood oscillante")
            .about(
                "Two masses over pulleys, the lighter one swinging: its swing lifts the heavier one. For mu = 3 it draws \
                 closed teardrops, for others tangles.",
                "Deux masses sur des poulies, la plus légère se balance : son mouvement soulève la plus lourde. Pour mu = 3 \
                 elle dessine des gouttes fermées, pour d'autres rapports des enchevêtrements.",
            )
            .source("Tufillaro, Abbott and Griffiths, Am. J. Phys. 52, 895 (1984)")
            .coordinate(coordinate("r", "m", "length of the swinging string", "longueur du fil qui se balance").start(1.0))
            .coordinate(coordinate("theta", "rad", "angle from the downward vertical", "angle avec la verticale descendante").start(std::f64::consts::FRAC_PI_2))
            .parameter(number("mu", "1", 3.0, "heavy mass over swinging mass", "masse lourde sur masse oscillante").positive())
            .parameter(number("g", "m/s^2", 9.81, "gravity", "pesanteur"))
            .invariant("energy", "m^2/s^2", "energy per swinging mass", "énergie par unité de masse oscillante")
            .signal("tufillaro", "m^3/s^2", "Tufillaro's integral, constant for mu = 3", "intégrale de Tufillaro, constante pour mu = 3")
            .signal("px", "m", "swinging mass, horizontally", "masse oscillante, horizontalement")
            .signal("py", "m", "swinging mass, upwards", "masse oscillante, vers le haut")
            .path_view("px", "py")
            .time_view(&["r"])
            .time_view(&["theta"])
            .run(20.0, 0.001)
    }

    fn check(&self, s: &State<f64>) -> Result<(), String> {
        if s.coordinates[0] > 0.0 {
            return Ok(());
        }
        Err(format!("the length r must be above zero at the start, not {}", s.coordinates[0]))
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([r, theta], [r_dot, w], [mu, g]) = (s.q(), s.v(), s.p());
        let (sin, cos) = theta.sin_cos();
        highest[0] = (r * w * w + g * (cos - mu)) / (mu + 1.0);
        highest[1] = -((g * sin + r_dot * w * 2.0) / r);
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let ([r, theta], [r_dot, w], [_mu, g]) = (s.q(), s.v(), s.p());
        let (kinetic, potential) = energies(s);
        let (sin, cos) = (theta * 0.5).sin_cos();
        let tufillaro = r * r * (w * (r_dot * cos - r * w * sin * 0.5) + g * sin * cos * cos);
        let (sin, cos) = theta.sin_cos();
        out.copy_from_slice(&[kinetic + potential, tufillaro, r * sin, -(r * cos)]);
    }

    #[inline(always)]
    fn lagrangian<S: Scalar>(&self, s: &State<S>) -> Option<S> {
        let (kinetic, potential) = energies(s);
        Some(kinetic - potential)
    }
}

#[inline(always)]
fn energies<S: Scalar>(s: &State<S>) -> (S, S) {
    let ([r, theta], [r_dot, w], [mu, g]) = (s.q(), s.v(), s.p());
    let kinetic = ((mu + 1.0) * r_dot.squared() + (r * w).squared()) * 0.5;
    (kinetic, g * r * (mu - theta.cos()))
}
