//! A body that rolls without slipping: the system. Its equations are in `rolling.rs`.

use super::body::length;
use super::check::check;
use super::measure::{Found, height, measure};
use super::parameters::card_of;
use super::regimes::ROLLS;
use super::rolling::roll;
use super::top::Top;
use crate::attitude;
use crate::inertia::{apply, solve, transferred};
use crate::rotation::{cross, dot, quaternion_rate};
use precess_scalar::Scalar;
use precess_system::{Card, Given, State, System, Values};

/// A body that rolls without slipping. The table keeps it: `normal` shows where it would lift off.
#[derive(Clone)]
pub struct Roller(pub(super) &'static Top);

impl System for Roller {
    fn card(&self) -> Card {
        card_of(self.0, false)
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let seen = self.0.see(s);
        let rolling = roll(&seen.body, &seen.touch, seen.omega, seen.gravity(), seen.torque);
        let velocity = cross(seen.touch.r, seen.omega);
        highest[..4].copy_from_slice(&quaternion_rate(seen.attitude, seen.omega));
        highest[4..7].copy_from_slice(&rolling.omega_dot);
        highest[7] = dot(seen.rows[0], velocity);
        highest[8] = dot(seen.rows[1], velocity);
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let seen = self.0.see(s);
        let zero = S::from(0.0);
        let rolling = roll(&seen.body, &seen.touch, seen.omega, seen.gravity(), seen.torque);
        let force = seen.on_table(rolling.force);
        let velocity = cross(seen.touch.r, seen.omega);
        let arm = cross(seen.touch.core, seen.touch.gamma);
        let [height, rise] = height(&seen);
        let found = Found {
            place: [s.coordinates[7], s.coordinates[8]],
            velocity: [dot(seen.rows[0], velocity), dot(seen.rows[1], velocity)],
            height,
            rise,
            slip: [zero, zero],
            force,
            drill: zero,
            needed: length([force[0], force[1]]),
            denominator: S::from(1.0) / seen.body.mass + dot(arm, solve(seen.body.inertia, arm)),
            regime: S::from(ROLLS),
        };
        measure(self.0, &seen, &found, out);
        // omega.J omega / 2 with J about the contact point, axis by axis.
        let inertia = transferred(seen.body.inertia, seen.body.mass, seen.touch.r);
        let momentum = apply(inertia, seen.omega);
        let first = out.len() - 3;
        for k in 0..3 {
            out[first + k] = seen.omega[k] * momentum[k] * 0.5;
        }
    }

    fn start(&self, given: &Given, _values: &Values<f64>, y: &mut [f64]) -> Result<(), String> {
        attitude::start(given, y)
    }

    fn check(&self, s: &State<f64>) -> Result<(), String> {
        check(self.0, s)
    }
}
