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
//! Worth knowing: Euler angles are singular where the axis is vertical; a path may pass close, but a start
//! there is refused. The default cone (T, 6.1) swings far below the horizontal: a gyroscope in gimbals.

use crate::rotation::dot;
use precess_scalar::Scalar;
use precess_system::{Card, State, System, card, coordinate, number};
use std::f64::consts::PI;

/// See the module.
#[derive(Clone)]
pub struct Gyroscope;

/// T's cone (6.1): density, height and radius; its mass and inertia (3.3).
const DENSITY: f64 = 100.0;
const HEIGHT: f64 = 0.15;
const RADIUS: f64 = 0.05;
const MASS: f64 = PI * DENSITY * RADIUS * RADIUS * HEIGHT / 3.0;
const I1: f64 = 3.0 * MASS / 20.0 * (RADIUS * RADIUS + HEIGHT * HEIGHT / 4.0);
const I3: f64 = 3.0 * MASS / 10.0 * RADIUS * RADIUS;
const D: f64 = 3.0 * HEIGHT / 4.0;

const MOMENTS: [&str; 3] = ["moment1", "moment2", "moment3"];

/// Angular velocity in the axes (u, b, a): T's (1).
#[inline(always)]
fn omega<S: Scalar>(s: &State<S>) -> [S; 3] {
    let ([_psi, theta], [psi_dot, theta_dot, phi_dot]) = (s.q(), s.v());
    let (sin, cos) = theta.sin_cos();
    [theta_dot, psi_dot * sin, psi_dot * cos + phi_dot]
}

/// Moments of inertia about A, in the axes (u, b, a).
#[inline(always)]
fn inertia<S: Scalar>(s: &State<S>) -> [S; 3] {
    let [m, i1, i3, d] = s.p();
    let i_a1 = i1 + m * d * d;
    [i_a1, i_a1, i3]
}

/// Kinetic and potential energy (zero with G at the height of A).
#[inline(always)]
fn energies<S: Scalar>(s: &State<S>) -> (S, S) {
    let ([_psi, theta], [m, _i1, _i3, d, g]) = (s.q(), s.p());
    (dot(inertia(s), omega(s).map(S::squared)) * 0.5, m * g * d * theta.cos())
}

impl System for Gyroscope {
    fn card(&self) -> Card {
        card("gyroscope", "Gyroscope with a fixed point", "Gyroscope simple")
            .about(
                "A symmetric top that turns about a fixed point of its axis: under its weight the axis precesses \
                 and nods between two heights.",
                "Une toupie de révolution dont un point de l'axe est fixe : sous l'effet du poids, l'axe précesse \
                 et oscille entre deux hauteurs (nutation).",
            )
            .source("T, sections 4.2 and 6.1, equations 10 to 15")
            .coordinate(coordinate("psi", "rad", "precession", "précession"))
            .coordinate(coordinate("theta", "rad", "nutation", "nutation").start(PI / 6.0))
            .coordinate(coordinate("phi", "rad", "proper rotation", "rotation propre").start_dot(60.0))
            .parameter(number("m", "kg", MASS, "mass", "masse").positive())
            .parameter(number("i1", "kg m^2", I1, "transverse inertia at G", "inertie transverse en G").positive())
            .parameter(number("i3", "kg m^2", I3, "inertia about the axis", "inertie axiale").positive())
            .parameter(number("d", "m", D, "distance from A to G", "distance de A à G"))
            .parameter(number("g", "m/s^2", 9.81, "gravity", "pesanteur"))
            .parameter(number("moment1", "N m", 0.0, "applied moment along u", "moment appliqué selon u"))
            .parameter(number("moment2", "N m", 0.0, "applied moment along b", "moment appliqué selon b"))
            .parameter(number("moment3", "N m", 0.0, "applied moment along a", "moment appliqué selon a"))
            .invariant_if("energy", "J", &MOMENTS, "total energy", "énergie totale")
            .invariant_if(
                "L_A3",
                "kg m^2/s",
                &["moment3"],
                "angular momentum at A along the axis",
                "moment cinétique en A selon l'axe",
            )
            .invariant_if(
                "L_Az",
                "kg m^2/s",
                &["moment2", "moment3"],
                "angular momentum at A along the vertical",
                "moment cinétique en A selon la verticale",
            )
            .signal("kinetic", "J", "kinetic energy", "énergie cinétique")
            .signal("potential", "J", "potential energy", "énergie potentielle")
            .signal("omega1", "rad/s", "angular velocity along u", "vitesse angulaire selon u")
            .signal("omega2", "rad/s", "angular velocity along b", "vitesse angulaire selon b")
            .signal("omega3", "rad/s", "angular velocity along the axis", "vitesse angulaire selon l'axe")
            .signal("axis_x", "", "axis, first component", "axe, première composante")
            .signal("axis_y", "", "axis, second component", "axe, deuxième composante")
            .signal("axis_z", "", "axis, upward component", "axe, composante verticale")
            .path_view("axis_x", "axis_y")
            .time_view(&["theta"])
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
        let omega1_dot = (moment1 + m * g * d * sin + psi_dot * sin * gyration) / i_a1;
        let omega2_dot = (moment2 - theta_dot * gyration) / i_a1;
        let omega3_dot = moment3 / i3;
        let psi_ddot = (omega2_dot - psi_dot * theta_dot * cos) / sin;
        highest[0] = psi_ddot;
        highest[1] = omega1_dot;
        highest[2] = omega3_dot + psi_dot * theta_dot * sin - psi_ddot * cos;
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let [psi, theta] = s.q();
        let ((sin_psi, cos_psi), (sin, cos)) = (psi.sin_cos(), theta.sin_cos());
        let (kinetic, potential) = energies(s);
        let ([o1, o2, o3], [_, i2, i3]) = (omega(s), inertia(s));
        let axis = [sin_psi * sin, -(cos_psi * sin), cos];
        out[..3].copy_from_slice(&[kinetic + potential, i3 * o3, i2 * o2 * sin + i3 * o3 * cos]);
        out[3..8].copy_from_slice(&[kinetic, potential, o1, o2, o3]);
        out[8..].copy_from_slice(&axis);
    }

    #[inline(always)]
    fn lagrangian<S: Scalar>(&self, s: &State<S>) -> Option<S> {
        let (kinetic, potential) = energies(s);
        Some(kinetic - potential)
    }

    fn check(&self, s: &State<f64>) -> Result<(), String> {
        super::refuse_vertical(s.q::<2>()[1])
    }
}
