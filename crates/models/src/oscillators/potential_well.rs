//! A particle in any polynomial potential on a line.
//!
//!     x'' = -U'(x) - b x',      U(x) = u_0 + u_1 x + u_2 x^2 + ...
//!
//! (P, sections 4 and 5, exercises 2 and 4.) A valley of U is a centre of the phase plane, or a focus with friction; a
//! hill is a saddle: U = k x^2 / 2 gives ellipses where k > 0 and hyperbolas where k < 0.

use super::polynomial::value_and_slope;
use crate::complex::Complex;
use crate::linear;
use precess_scalar::Scalar;
use precess_system::{Card, State, System, card, coordinate, list, number};

/// See the module.
#[derive(Clone)]
pub struct PotentialWell;

impl System for PotentialWell {
    fn card(&self) -> Card {
        card("potential_well", "Particle in a potential", "Particule dans un potentiel")
            .about(
                "Any polynomial potential: valleys are surrounded by ovals of the phase plane, hills by hyperbolas, and \
                 the separatrix passes through the hilltop.",
                "N'importe quel potentiel polynomial : les vallées sont entourées d'ovales du plan de phase, les bosses \
                 d'hyperboles, et la séparatrice passe par le sommet.",
            )
            .source("P, sections 4 and 5, exercises 2 and 4, figures 6, 12 and 13")
            .coordinate(coordinate("x", "", "position", "position").start(0.5))
            .parameter(
                list("u", "", &[0.0, 0.0, 0.5, -1.0 / 3.0], "coefficients of the potential, the constant first", "coefficients du potentiel, la constante d'abord")
                    .at_most(64),
            )
            .parameter(number("b", "", 0.0, "friction", "frottement"))
            .invariant_if("energy", "", &["b"], "energy per mass", "énergie par unité de masse")
            .signal("kinetic", "", "kinetic energy per mass", "énergie cinétique par unité de masse")
            .signal("potential", "", "potential energy per mass", "énergie potentielle par unité de masse")
            .phase_view("x", "x_dot")
            .time_view(&["x"])
            .run(20.0, 0.001)
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([x], [v], [b]) = (s.q(), s.v(), s.p());
        let (_, slope) = value_and_slope(s.list(0), x);
        highest[0] = -(b * v) - slope;
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let ([x], [v]) = (s.q(), s.v());
        let (potential, _) = value_and_slope(s.list(0), x);
        let kinetic = v.squared() * 0.5;
        out.copy_from_slice(&[kinetic + potential, kinetic, potential]);
    }

    fn solvable(&self, start: &State<f64>) -> Result<(), String> {
        let curved = start.list(0).iter().skip(3).any(|&u| u != 0.0);
        if curved {
            Err("it has a closed form for a potential of the second degree only".into())
        } else {
            Ok(())
        }
    }

    /// Of a potential of the second degree: a linear oscillator under a constant force.
    #[inline(always)]
    fn solution<S: Scalar>(&self, start: &State<S>, t: S, q: &mut [S], v: &mut [S]) {
        let ([x], [x_dot], [b]) = (start.q(), start.v(), start.p());
        let zero = S::from(0.0);
        let u = |k: usize| start.list(0).get(k).copied().unwrap_or(zero);
        let (time, oscillator) = (t - start.t, [b, u(2) * 2.0]);
        [q[0], v[0]] = linear::driven(oscillator, time, [x, x_dot], Complex::imaginary(-u(1)), zero);
    }

    #[inline(always)]
    fn lagrangian<S: Scalar>(&self, s: &State<S>) -> Option<S> {
        let ([x], [v], [b]) = (s.q(), s.v(), s.p());
        let (potential, _) = value_and_slope(s.list(0), x);
        Some((b * s.t).exp() * (v.squared() * 0.5 - potential))
    }
}
