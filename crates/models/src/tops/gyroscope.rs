//! A top whose axis turns about a fixed point A: T's simple gyroscope (the top of Lagrange).
//!
//! In the axes (u, b, a) that follow the top's axis but not its spin, omega = (theta', psi' sin theta, omega3)
//! with omega3 = psi' cos theta + phi', and `L_A' = M_A` reads, with `I_A1 = i1 + m d^2`,
//!
//!     I_A1 theta''                                  = M1 + psi' sin theta (I_A1 psi' cos theta - i3 omega3)
//!     I_A1 (psi'' sin theta + psi' theta' cos theta) = M2 + theta' (i3 omega3 - I_A1 psi' cos theta)
//!     i3 omega3'                                    = M3
//!
//! which are T's (10), (11), (12); the weight adds m g d sin theta to M1 and makes them (13), (14), (15).
//! Energy, the component of `L_A` along the axis and the one along the vertical are constant (T, 4.5).
//!
//! Worth knowing: Euler angles are singular where the axis is vertical (see `euler_angles`). The default cone (T, 6.1) swings far below the horizontal: a gyroscope in gimbals.

use super::euler_angles::{self, accelerations, omega, start_on_the_vertical};
use super::gyroscope_card::{self, energies, inertia, observe, share_on_the_vertical};
use precess_scalar::Scalar;
use precess_system::{Card, Given, State, System, Values, card};

/// See the module.
#[derive(Clone)]
pub struct Gyroscope;

impl System for Gyroscope {
    fn card(&self) -> Card {
        let card = card("gyroscope", "Gyroscope with a fixed point", "Gyroscope simple")
            .about(
                "A symmetric top that turns about a fixed point of its axis: under its weight the axis precesses \
                 and nods between two heights.",
                "Une toupie de révolution dont un point de l'axe est fixe : sous l'effet du poids, l'axe précesse \
                 et oscille entre deux hauteurs (nutation).",
            )
            .source("T, sections 4.2 and 6.1, equations 10 to 15");
        let card = gyroscope_card::moments(gyroscope_card::body(euler_angles::angles(card, |angle| angle)));
        gyroscope_card::observables(card, true)
            .path_view("axis_x", "axis_y")
            .time_view(&["theta"])
            .time_view(&["effective_potential", "energy"])
            .run(2.0, 1e-4)
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([_psi, theta], [psi_dot, theta_dot]) = (s.q(), s.v());
        let [m, _i1, i3, d, g, moment1, moment2, moment3] = s.p();
        let [i_a1, ..] = inertia(s);
        let [.., omega3] = omega(s);
        let (sin, cos) = theta.sin_cos();
        let gyration = i_a1 * psi_dot * cos - i3 * omega3;
        let omega_dot = [
            (moment1 + m * g * d * sin + psi_dot * sin * gyration) / i_a1,
            (moment2 - theta_dot * gyration) / i_a1,
            moment3 / i3,
        ];
        highest.copy_from_slice(&accelerations(s, omega_dot));
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        observe(s, out);
    }

    fn solvable(&self, start: &State<f64>) -> Result<(), String> {
        gyroscope_card::solvable(start)
    }

    #[inline(always)]
    fn solution<S: Scalar>(&self, start: &State<S>, t: S, q: &mut [S], v: &mut [S]) {
        gyroscope_card::solution(start, t, q, v);
    }

    #[inline(always)]
    fn lagrangian<S: Scalar>(&self, s: &State<S>) -> Option<S> {
        let (kinetic, potential) = energies(s);
        Some(kinetic - potential)
    }

    fn start(&self, _given: &Given, values: &Values<f64>, y: &mut [f64]) -> Result<(), String> {
        start_on_the_vertical(y, 3, share_on_the_vertical(values));
        Ok(())
    }

    fn check(&self, s: &State<f64>) -> Result<(), String> {
        let [_m, i1, i3] = s.p();
        super::possible_inertia([i1, i1, i3])
    }
}
