//! A star in a galaxy's plane, as Henon and Heiles drew it.
//!
//!     x'' = -x - 2 lambda x y        y'' = -y - lambda (x^2 - y^2)
//!
//! The potential (x^2 + y^2) / 2 + lambda (x^2 y - y^3 / 3) holds energies below 1 / (6 lambda^2). At 1/12 nearly all
//! motions are regular, at 1/8 about half, at 1/6 hardly any (M. Henon, C. Heiles, Astron. J. 69, 73, 1964).

use precess_scalar::Scalar;
use precess_system::{Card, State, System, card, coordinate, number};

/// See the module.
#[derive(Clone)]
pub struct HenonHeiles;

impl System for HenonHeiles {
    fn card(&self) -> Card {
        card("henon_heiles", "Hénon and Heiles's galaxy", "Galaxie de Hénon et Heiles")
            .about(
                "Two oscillators, coupled: at small energies regular, near the escape energy chaotic, in between both.",
                "Deux oscillateurs couplés : réguliers à petite énergie, chaotiques près de l'énergie d'évasion, les deux \
                 à la fois entre-temps.",
            )
            .source("M. Henon and C. Heiles, Astron. J. 69, 73 (1964)")
            .coordinate(coordinate("x", "", "position along x", "position selon x").start_dot(0.49))
            .coordinate(coordinate("y", "", "position along y", "position selon y").start(0.1))
            .parameter(number("lambda", "", 1.0, "strength of the coupling", "intensité du couplage"))
            .invariant("energy", "", "energy per mass", "énergie par unité de masse")
            .signal("potential", "", "potential energy per mass", "énergie potentielle par unité de masse")
            .path_view("x", "y")
            .phase_view("y", "y_dot")
            .time_view(&["x", "y"])
            .run(200.0, 0.002)
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([x, y], [lambda]) = (s.q(), s.p());
        highest.copy_from_slice(&[-x - lambda * x * y * 2.0, -y - lambda * (x * x - y * y)]);
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let (kinetic, potential) = energies(s);
        out.copy_from_slice(&[kinetic + potential, potential]);
    }

    #[inline(always)]
    fn lagrangian<S: Scalar>(&self, s: &State<S>) -> Option<S> {
        let (kinetic, potential) = energies(s);
        Some(kinetic - potential)
    }
}

#[inline(always)]
fn energies<S: Scalar>(s: &State<S>) -> (S, S) {
    let ([x, y], [x_dot, y_dot], [lambda]) = (s.q(), s.v(), s.p());
    let potential = (x * x + y * y) * 0.5 + lambda * y * (x * x - y * y / 3.0);
    ((x_dot.squared() + y_dot.squared()) * 0.5, potential)
}
