//! Lorenz's equations: convection in three numbers.
//!
//!     x' = sigma (y - x)        y' = x (rho - z) - y        z' = x y - beta z
//!
//! (E. N. Lorenz, J. Atmos. Sci. 20, 130, 1963.) The waterwheel of Malkus obeys them with beta = 1: see
//! `malkus_waterwheel`.

use precess_scalar::Scalar;
use precess_system::{Card, State, System, card, coordinate, number};

/// See the module.
#[derive(Clone)]
pub struct Lorenz;

impl System for Lorenz {
    fn card(&self) -> Card {
        card("lorenz", "Lorenz's equations", "Équations de Lorenz")
            .about(
                "The first strange attractor: two wings between which the motion changes without a rule. Neighbouring \
                 starts part within some ten units of time.",
                "Le premier attracteur étrange : deux ailes entre lesquelles le mouvement passe sans règle. Des départs \
                 voisins se séparent en une dizaine d'unités de temps.",
            )
            .source("E. N. Lorenz, J. Atmos. Sci. 20, 130 (1963)")
            .coordinate(coordinate("x", "", "rate of convection", "intensité de la convection").first_order().start(1.0))
            .coordinate(coordinate("y", "", "difference of temperature across", "écart de température horizontal").first_order().start(1.0))
            .coordinate(coordinate("z", "", "distortion of the profile upwards", "déformation du profil vertical").first_order().start(1.0))
            .parameter(number("sigma", "", 10.0, "Prandtl number", "nombre de Prandtl"))
            .parameter(number("rho", "", 28.0, "heating (Rayleigh number over its critical value)", "chauffage (nombre de Rayleigh sur sa valeur critique)"))
            .parameter(number("beta", "", 8.0 / 3.0, "shape of the rolls", "forme des rouleaux"))
            .phase_view("x", "z")
            .time_view(&["x", "y", "z"])
            .run(40.0, 0.001)
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([x, y, z], [sigma, rho, beta]) = (s.q(), s.p());
        highest.copy_from_slice(&[sigma * (y - x), x * (rho - z) - y, x * y - beta * z]);
    }
}
