//! A mass on a spring, lying on the floor or hung from the ceiling.
//!
//!     m x'' = -k x - b x'
//!
//! x is measured from the equilibrium, as in P, section 6: where gravity pulls along the spring it stretches it by
//! m g / k, and nothing else changes. Its length is l0 + m g / k + x.

use crate::linear;
use precess_scalar::Scalar;
use precess_system::{Card, State, System, card, coordinate, number};

/// See the module.
#[derive(Clone)]
pub struct Spring;

impl System for Spring {
    fn card(&self) -> Card {
        card("spring", "Mass on a spring", "Masse au bout d'un ressort")
            .about(
                "A horizontal spring, or a vertical one where g is not zero: the weight moves the equilibrium and leaves \
                 the period 2 pi sqrt(m/k) as it is.",
                "Un ressort horizontal, ou vertical si g n'est pas nul : le poids déplace l'équilibre et laisse la période \
                 2 pi sqrt(m/k) inchangée.",
            )
            .source("P, section 6, figures 8 and 9")
            .coordinate(
                coordinate("x", "m", "elongation from the equilibrium", "élongation depuis l'équilibre").start(1.0),
            )
            .parameter(number("m", "kg", 1.0, "mass", "masse").positive())
            .parameter(number("k", "N/m", 1.0, "stiffness", "raideur").positive())
            .parameter(number("b", "kg/s", 0.0, "friction", "frottement"))
            .parameter(
                number("g", "m/s^2", 0.0, "gravity along the spring (0: horizontal)", "pesanteur le long du ressort (0 : horizontal)"),
            )
            .parameter(number("l0", "m", 1.0, "natural length", "longueur à vide").symbol("l_0"))
            .invariant_if("energy", "J", &["b"], "total energy, zero at the equilibrium", "énergie totale, nulle à l'équilibre")
            .signal("kinetic", "J", "kinetic energy", "énergie cinétique")
            .signal("elastic", "J", "elastic energy", "énergie élastique")
            .signal("weight_energy", "J", "energy of the weight, zero at the natural length", "énergie de pesanteur, nulle à la longueur à vide")
            .signal("length", "m", "length of the spring", "longueur du ressort")
            .signal("force", "N", "pull of the spring", "force du ressort")
            .time_view(&["x"])
            .phase_view("x", "x_dot")
            .run(20.0, 0.001)
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([x], [v], [m, k, b]) = (s.q(), s.v(), s.p());
        highest[0] = -((k * x + b * v) / m);
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let ([x], [v], [m, k, _b, g, l0]) = (s.q(), s.v(), s.p());
        let kinetic = m * v.squared() * 0.5;
        let stretch = m * g / k + x;
        let energy = kinetic + k * x.squared() * 0.5;
        let elastic = k * stretch.squared() * 0.5;
        out.copy_from_slice(&[energy, kinetic, elastic, -(m * g * stretch), l0 + stretch, -(k * stretch)]);
    }

    fn solvable(&self, _start: &State<f64>) -> Result<(), String> {
        Ok(())
    }

    #[inline(always)]
    fn solution<S: Scalar>(&self, start: &State<S>, t: S, q: &mut [S], v: &mut [S]) {
        let ([x], [x_dot], [m, k, b]) = (start.q(), start.v(), start.p());
        [q[0], v[0]] = linear::free([b / m, k / m], t - start.t, [x, x_dot]);
    }

    #[inline(always)]
    fn lagrangian<S: Scalar>(&self, s: &State<S>) -> Option<S> {
        let ([x], [v], [m, k, b]) = (s.q(), s.v(), s.p());
        Some((b / m * s.t).exp() * (m * v.squared() - k * x.squared()) * 0.5)
    }
}
