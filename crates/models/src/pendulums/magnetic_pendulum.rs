//! A pendulum over magnets, seen from above, swinging a little.
//!
//!     x'' = -c x - r x' + sum s_k (x_k - x) / D_k^3,     D_k^2 = (x_k - x)^2 + (y_k - y)^2 + d^2
//!
//! and the same for y. (P, exercise 7.) The magnets lie a distance d below the plane of motion. With friction the
//! mass comes to rest over one of them; which one depends on the start in a fractal manner.

use precess_scalar::Scalar;
use precess_system::{Card, State, System, card, coordinate, number, rows};

/// See the module.
#[derive(Clone)]
pub struct MagneticPendulum;

/// The three magnets of P's programs, on a circle of radius 1/2.
const MAGNETS: [[f64; 3]; 3] = [[0.5, 0.0, 1.0], [-0.25, 0.433, 1.0], [-0.25, -0.433, 1.0]];

impl System for MagneticPendulum {
    fn card(&self) -> Card {
        card("magnetic_pendulum", "Pendulum over magnets", "Pendule attiré par des aimants")
            .about(
                "A pendulum that ends over one of several magnets. Neighbouring starts end over different ones: the \
                 basins of attraction are fractal.",
                "Un pendule qui s'arrête sur l'un de plusieurs aimants. Des départs voisins finissent sur des aimants \
                 différents : les bassins d'attraction sont fractals.",
            )
            .source("P, exercise 7, figures 23 to 25")
            .coordinate(coordinate("x", "", "position along x", "position selon x").start(1.0))
            .coordinate(coordinate("y", "", "position along y", "position selon y").start_dot(1.0))
            .parameter(number("c", "", 4.0, "pull towards the centre (gravity over length)", "rappel vers le centre (pesanteur sur longueur)"))
            .parameter(number("r", "", 0.2, "friction", "frottement"))
            .parameter(number("d", "", 0.2, "distance of the magnets below the plane", "distance des aimants sous le plan").positive())
            .parameter(rows("magnets", &["x", "y", "strength"], &MAGNETS, "the magnets: place and strength", "les aimants : position et force"))
            .invariant_if("energy", "", &["r"], "energy per mass", "énergie par unité de masse")
            .path_view("x", "y")
            .time_view(&["x", "y"])
            .run(20.0, 0.0001)
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([x, y], [x_dot, y_dot], [c, r, d]) = (s.q(), s.v(), s.p());
        let mut ax = -(c * x) - r * x_dot;
        let mut ay = -(c * y) - r * y_dot;
        for &[xk, yk, strength] in s.rows(0) {
            let (dx, dy) = (xk - x, yk - y);
            let square = dx * dx + dy * dy + d * d;
            let pull = strength / (square * square.sqrt());
            ax = ax + pull * dx;
            ay = ay + pull * dy;
        }
        highest.copy_from_slice(&[ax, ay]);
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let (kinetic, potential) = energies(s);
        out[0] = kinetic + potential;
    }

    #[inline(always)]
    fn lagrangian<S: Scalar>(&self, s: &State<S>) -> Option<S> {
        let (kinetic, potential) = energies(s);
        Some(kinetic - potential)
    }
}

#[inline(always)]
fn energies<S: Scalar>(s: &State<S>) -> (S, S) {
    let ([x, y], [x_dot, y_dot], [c, _, d]) = (s.q(), s.v(), s.p());
    let kinetic = (x_dot * x_dot + y_dot * y_dot) * 0.5;
    let wells = s.rows(0).iter().fold(S::from(0.0), |sum, &[xk, yk, strength]| {
        sum + strength / ((xk - x).squared() + (yk - y).squared() + d * d).sqrt()
    });
    (kinetic, c * (x * x + y * y) * 0.5 - wells)
}
