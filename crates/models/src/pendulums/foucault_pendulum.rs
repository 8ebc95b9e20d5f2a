//! A long pendulum with small swings on the turning Earth.
//!
//!     x'' =  2 rotation sin(latitude) y' - (g / l) x
//!     y'' = -2 rotation sin(latitude) x' - (g / l) y
//!
//! (L. Foucault 1851; Landau, Lifshitz, *Mechanics*, section 39, problem 3.) x points east, y north; the centrifugal force
//! is part of g. The plane of the swing turns by -rotation sin(latitude): clockwise in the north.

use crate::linear;
use precess_scalar::Scalar;
use precess_system::{Card, State, System, card, coordinate, number};

/// See the module.
#[derive(Clone)]
pub struct FoucaultPendulum;

/// The Pantheon in Paris, 48 deg 50 min 46 s north.
const PARIS: f64 = 0.852_5;
/// One turn a sidereal day.
const EARTH: f64 = 7.292_115e-5;

impl System for FoucaultPendulum {
    fn card(&self) -> Card {
        card("foucault_pendulum", "Foucault's pendulum", "Pendule de Foucault")
            .about(
                "The Earth turns under a long pendulum: at Paris the plane of its swing goes round in 32 hours.",
                "La Terre tourne sous un long pendule : à Paris, le plan d'oscillation fait le tour en 32 heures.",
            )
            .source("L. Foucault 1851; Landau and Lifshitz, Mechanics, section 39, problem 3")
            .coordinate(coordinate("x", "m", "displacement to the east", "élongation vers l'est").start(3.0))
            .coordinate(coordinate("y", "m", "displacement to the north", "élongation vers le nord"))
            .parameter(number("l", "m", 67.0, "length", "longueur").positive())
            .parameter(number("g", "m/s^2", 9.81, "gravity", "pesanteur").positive())
            .parameter(number("latitude", "rad", PARIS, "latitude", "latitude").symbol("\\lambda"))
            .parameter(number("rotation", "rad/s", EARTH, "rotation of the Earth", "rotation de la Terre").symbol("\\Omega"))
            .invariant("energy", "m^2/s^2", "energy per mass", "énergie par unité de masse")
            .invariant("angular_momentum", "m^2/s", "angular momentum per mass in the frame that does not turn", "moment cinétique par unité de masse dans le repère qui ne tourne pas")
            .path_view("x", "y")
            .time_view(&["x", "y"])
            .run(3600.0, 0.01)
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([x, y], [x_dot, y_dot], [l, g]) = (s.q(), s.v(), s.p());
        let (turn, pull) = (turn(s) * 2.0, g / l);
        highest.copy_from_slice(&[turn * y_dot - pull * x, -(turn * x_dot) - pull * y]);
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let (kinetic, potential, moment) = parts(s);
        out.copy_from_slice(&[kinetic + potential, moment]);
    }

    fn solvable(&self, _start: &State<f64>) -> Result<(), String> {
        Ok(())
    }

    /// In the frame that turns back with the Earth it is a planar oscillator.
    #[inline(always)]
    fn solution<S: Scalar>(&self, start: &State<S>, t: S, q: &mut [S], v: &mut [S]) {
        let ([x, y], [x_dot, y_dot], [l, g]) = (start.q(), start.v(), start.p());
        let (turn, time) = (turn(start), t - start.t);
        let oscillator = [S::from(0.0), turn * turn + g / l];
        let east = [x, x_dot - turn * y];
        let north = [y, y_dot + turn * x];
        let [x, x_dot] = linear::free(oscillator, time, east);
        let [y, y_dot] = linear::free(oscillator, time, north);
        let (sin, cos) = (turn * time).sin_cos();
        let (u, w) = (x_dot + turn * y, y_dot - turn * x);
        (q[0], q[1]) = (x * cos + y * sin, y * cos - x * sin);
        (v[0], v[1]) = (u * cos + w * sin, w * cos - u * sin);
    }

    #[inline(always)]
    fn lagrangian<S: Scalar>(&self, s: &State<S>) -> Option<S> {
        let ([x, y], [x_dot, y_dot]) = (s.q(), s.v());
        let (kinetic, potential, _) = parts(s);
        Some(kinetic - potential + turn(s) * (x * y_dot - y * x_dot))
    }
}

/// The rotation about the vertical of the place.
#[inline(always)]
fn turn<S: Scalar>(s: &State<S>) -> S {
    let [_l, _g, latitude, rotation] = s.p();
    rotation * latitude.sin()
}

/// Energies and angular momentum per mass.
#[inline(always)]
fn parts<S: Scalar>(s: &State<S>) -> (S, S, S) {
    let ([x, y], [x_dot, y_dot], [l, g]) = (s.q(), s.v(), s.p());
    let square = x.squared() + y.squared();
    let kinetic = (x_dot.squared() + y_dot.squared()) * 0.5;
    (kinetic, g / l * square * 0.5, x * y_dot - y * x_dot + turn(s) * square)
}
