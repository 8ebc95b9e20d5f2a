//! A pendulum that swings a little in both directions, seen from above.
//!
//!     x'' = -c x - r x'        y'' = -c y - r y'
//!
//! (P, exercises 1.3, 7.1 and 7.2.) Without friction it draws ellipses about their centre, with friction spirals.

use crate::linear;
use precess_scalar::Scalar;
use precess_system::{Card, State, System, card, coordinate, number};

/// See the module.
#[derive(Clone)]
pub struct PlanarOscillator;

impl System for PlanarOscillator {
    fn card(&self) -> Card {
        card("planar_oscillator", "Planar oscillator", "Oscillateur plan")
            .about(
                "A pendulum that swings a little in both directions: an ellipse about its centre, a spiral with friction.",
                "Un pendule aux petites oscillations dans les deux directions : une ellipse autour de son centre, une \
                 spirale avec frottement.",
            )
            .source("P, exercises 1.3, 7.1 and 7.2, figures 4, 5 and 22")
            .coordinate(coordinate("x", "m", "displacement along x", "élongation selon x").start(1.0))
            .coordinate(coordinate("y", "m", "displacement along y", "élongation selon y").start_dot(1.0))
            .parameter(number("c", "1/s^2", 1.0, "stiffness per mass", "raideur par unité de masse").positive())
            .parameter(number("r", "1/s", 0.0, "friction per mass", "frottement par unité de masse"))
            .invariant_if("energy", "m^2/s^2", &["r"], "energy per mass", "énergie par unité de masse")
            .invariant_if(
                "angular_momentum",
                "m^2/s",
                &["r"],
                "angular momentum per mass",
                "moment cinétique par unité de masse",
            )
            .path_view("x", "y")
            .time_view(&["x", "y"])
            .run(20.0, 0.0001)
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([x, y], [x_dot, y_dot], [c, r]) = (s.q(), s.v(), s.p());
        highest.copy_from_slice(&[-(c * x) - r * x_dot, -(c * y) - r * y_dot]);
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let ([x, y], [x_dot, y_dot], [c]) = (s.q(), s.v(), s.p());
        let energy = (x_dot.squared() + y_dot.squared() + c * (x.squared() + y.squared())) * 0.5;
        out.copy_from_slice(&[energy, x * y_dot - y * x_dot]);
    }

    fn solvable(&self, _start: &State<f64>) -> Result<(), String> {
        Ok(())
    }

    #[inline(always)]
    fn solution<S: Scalar>(&self, start: &State<S>, t: S, q: &mut [S], v: &mut [S]) {
        let [c, r] = start.p();
        for i in 0..2 {
            [q[i], v[i]] = linear::free([r, c], t - start.t, [start.coordinates[i], start.velocities[i]]);
        }
    }

    #[inline(always)]
    fn lagrangian<S: Scalar>(&self, s: &State<S>) -> Option<S> {
        let ([x, y], [x_dot, y_dot], [c]) = (s.q(), s.v(), s.p());
        Some((x_dot.squared() + y_dot.squared() - c * (x.squared() + y.squared())) * 0.5)
    }
}
