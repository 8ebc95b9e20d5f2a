//! A pendulum that may swing in every direction.
//!
//!     theta'' = phi'^2 sin theta cos theta - (g / l) sin theta
//!     phi''   = -2 theta' phi' cos theta / sin theta
//!
//! (Landau, Lifshitz, *Mechanics*, section 14, problem 1.) theta is the angle from the downward vertical, phi the
//! azimuth; energy and the angular momentum about the vertical are constant. The angles are singular where the mass
//! hangs or stands exactly vertically.

use precess_scalar::Scalar;
use precess_system::{Card, State, System, card, coordinate, number};

/// See the module.
#[derive(Clone)]
pub struct SphericalPendulum;

impl System for SphericalPendulum {
    fn card(&self) -> Card {
        card("spherical_pendulum", "Spherical pendulum", "Pendule sphérique")
            .about(
                "A pendulum free to swing in every direction: its ellipse turns, faster for larger swings, between two \
                 parallels of its sphere.",
                "Un pendule libre de se balancer dans toutes les directions : son ellipse tourne, d'autant plus vite que \
                 l'amplitude est grande, entre deux parallèles de sa sphère.",
            )
            .source("Landau and Lifshitz, Mechanics, section 14, problem 1")
            .coordinate(coordinate("theta", "rad", "angle from the downward vertical", "angle avec la verticale descendante").start(1.0))
            .coordinate(coordinate("phi", "rad", "azimuth", "azimut").start_dot(2.0))
            .parameter(number("m", "kg", 1.0, "mass", "masse").positive())
            .parameter(number("l", "m", 1.0, "length", "longueur").positive())
            .parameter(number("g", "m/s^2", 9.81, "gravity", "pesanteur"))
            .invariant("energy", "J", "total energy", "énergie totale")
            .invariant("L_z", "kg m^2/s", "angular momentum about the vertical", "moment cinétique autour de la verticale")
            .signal("tension", "N", "pull of the rod", "tension de la tige")
            .signal("x", "m", "place of the mass along x", "position de la masse selon x")
            .signal("y", "m", "place of the mass along y", "position de la masse selon y")
            .signal("z", "m", "height of the mass", "hauteur de la masse")
            .path_view("x", "y")
            .time_view(&["theta"])
            .run(20.0, 0.001)
    }

    fn check(&self, s: &State<f64>) -> Result<(), String> {
        let theta = s.coordinates[0];
        if Scalar::sin(theta).abs() > 1e-12 {
            return Ok(());
        }
        Err(format!(
            "theta = {theta} is vertical, where the azimuth phi is not defined: tilt it a little, or use pendulum"
        ))
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([theta, _], [w, turn], [_m, l, g]) = (s.q(), s.v(), s.p());
        let (sin, cos) = theta.sin_cos();
        highest[0] = sin * (turn * turn * cos - g / l);
        highest[1] = -(w * turn * cos * 2.0 / sin);
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let ([theta, phi], [w, turn], [m, l, g]) = (s.q(), s.v(), s.p());
        let (kinetic, potential) = energies(s);
        let (sin, cos) = theta.sin_cos();
        let (east, north) = phi.sin_cos();
        let tension = m * (l * (w.squared() + (turn * sin).squared()) + g * cos);
        let reach = l * sin;
        out.copy_from_slice(&[
            kinetic + potential,
            m * reach.squared() * turn,
            tension,
            reach * north,
            reach * east,
            -(l * cos),
        ]);
    }

    #[inline(always)]
    fn lagrangian<S: Scalar>(&self, s: &State<S>) -> Option<S> {
        let (kinetic, potential) = energies(s);
        Some(kinetic - potential)
    }
}

#[inline(always)]
fn energies<S: Scalar>(s: &State<S>) -> (S, S) {
    let ([theta, _], [w, turn], [m, l, g]) = (s.q(), s.v(), s.p());
    let (sin, cos) = theta.sin_cos();
    (m * l * l * (w.squared() + (turn * sin).squared()) * 0.5, -(m * g * l * cos))
}
