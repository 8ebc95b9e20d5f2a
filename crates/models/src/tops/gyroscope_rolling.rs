//! The gyroscope again, by T's general formulation of a top that rolls (4.2, 4.4), in vectors and step by step.
//!
//! 1. omega by (1); the moment of the weight about A, `M_A = AG x (-m g k)`; `I_A = I + m (d^2 1 - AG AG^T)`;
//! 2. the rates of omega's components by (9), where `I_A' = 0` for a point of the axis;
//! 3. the accelerations of the angles by (2).
//!
//! Nothing here knows of (10) to (15): agreeing with `gyroscope` to rounding checks both.

use super::contact::{omega_rate, vertical};
use super::euler_angles::{self, accelerations, omega, start_on_the_vertical};
use super::gyroscope_card::{self, energies, observe, share_on_the_vertical};
use crate::inertia::{diagonal, transferred};
use crate::rotation::cross;
use precess_scalar::Scalar;
use precess_system::{Card, Given, State, System, Values, card};

/// See the module.
#[derive(Clone)]
pub struct GyroscopeRolling;

impl System for GyroscopeRolling {
    fn card(&self) -> Card {
        let card = card("gyroscope_rolling", "Gyroscope as a rolling top", "Gyroscope en toupie roulante")
            .about(
                "The simple gyroscope by the general method for tops that roll: inertia carried to the contact point, \
                 moments as vectors. It must do what the gyroscope does.",
                "Le gyroscope simple par la méthode générale des toupies roulantes : inertie transférée au point de \
                 contact, moments vectoriels. Il doit faire ce que fait le gyroscope.",
            )
            .source("T, sections 4.2 and 4.4, equations 1, 2 and 9");
        let card = gyroscope_card::moments(gyroscope_card::body(euler_angles::angles(card, |angle| angle)));
        gyroscope_card::observables(card, true)
            .path_view("axis_x", "axis_y")
            .time_view(&["theta"])
            .run(2.0, 1e-4)
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let [m, i1, i3, d, g, moment1, moment2, moment3] = s.p();
        let zero = S::from(0.0);
        let arm = [zero, zero, d];
        let [k1, k2, k3] = vertical(s);
        let weight = cross(arm, [-(m * g * k1), -(m * g * k2), -(m * g * k3)]);
        let moment = [weight[0] + moment1, weight[1] + moment2, weight[2] + moment3];
        let inertia = transferred(diagonal([i1, i1, i3]), m, arm);
        let omega_dot = omega_rate(s, inertia, omega(s), moment, [zero; 3]);
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
