//! A body of revolution under a given moment about its centre of mass, in Euler angles.
//!
//!     i1 omega1' = M1 + (i1 - i3) omega2 omega3 - i1 omega2 phi'                                       (6)
//!     i1 omega2' = M2 - (i1 - i3) omega1 omega3 + i1 omega1 phi'                                       (7)
//!     i3 omega3' = M3                                                                                  (8)
//!
//! with (1) and (2), in the axes (u, b, a) that follow the axis but not the proper rotation. (T, sections 2.2 and 4.1.)
//! Without a moment the angular momentum rests in space, and the axis goes round it at `L / i1` on a cone.

use super::euler_angles::{self, accelerations, axis, omega, start_on_the_vertical, to_space};
use super::gyroscope_card::{I1, I3};
use crate::rotation::dot;
use precess_scalar::Scalar;
use precess_system::{Card, Given, State, System, Values, card, number};

/// See the module.
#[derive(Clone)]
pub struct SymmetricBody;

const MOMENTS: [&str; 3] = ["moment1", "moment2", "moment3"];

/// Angular momentum at G in (u, b, a).
#[inline(always)]
fn momentum<S: Scalar>(s: &State<S>) -> [S; 3] {
    let ([o1, o2, o3], [i1, i3]) = (omega(s), s.p());
    [i1 * o1, i1 * o2, i3 * o3]
}

impl System for SymmetricBody {
    fn card(&self) -> Card {
        let momentum = |card: Card, name, en, fr| card.invariant_if(name, "kg m^2/s", &MOMENTS, en, fr);
        let card = card("symmetric_body", "Body of revolution", "Solide de révolution")
            .about(
                "A body of revolution that turns about its centre of mass, free or under a given moment: free, its \
                 axis goes round the angular momentum at a steady pace.",
                "Un solide de révolution qui tourne autour de son centre de masse, libre ou soumis à un moment donné : \
                 libre, son axe tourne autour du moment cinétique à vitesse constante.",
            )
            .source("T, sections 2.2 and 4.1, equations 1, 2 and 6 to 8");
        let card = euler_angles::angles(card, |angle| angle)
            .parameter(number("i1", "kg m^2", I1, "transverse inertia", "inertie transverse").positive())
            .parameter(number("i3", "kg m^2", I3, "inertia about the axis", "inertie axiale").positive())
            .parameter(number("moment1", "N m", 0.0, "applied moment along u", "moment appliqué selon u"))
            .parameter(number("moment2", "N m", 0.0, "applied moment along b", "moment appliqué selon b"))
            .parameter(number("moment3", "N m", 0.0, "applied moment along a", "moment appliqué selon a"))
            .invariant_if("energy", "J", &MOMENTS, "kinetic energy", "énergie cinétique")
            .invariant_if(
                "L_3",
                "kg m^2/s",
                &["moment3"],
                "angular momentum along the axis",
                "moment cinétique selon l'axe",
            );
        let card = momentum(card, "L_x", "angular momentum along x", "moment cinétique selon x");
        let card = momentum(card, "L_y", "angular momentum along y", "moment cinétique selon y");
        let card = momentum(card, "L_z", "angular momentum along z", "moment cinétique selon z");
        let card = momentum(card, "L", "magnitude of the angular momentum", "norme du moment cinétique");
        euler_angles::omega_and_axis(card)
            .path_view("axis_x", "axis_y")
            .time_view(&["psi", "phi"])
            .time_view(&["theta"])
            .run(2.0, 1e-4)
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let [_psi_dot, _theta_dot, phi_dot] = s.v();
        let [i1, i3, moment1, moment2, moment3] = s.p();
        let [o1, o2, o3] = omega(s);
        let omega_dot = [
            (moment1 + (i1 - i3) * o2 * o3) / i1 - o2 * phi_dot,
            (moment2 - (i1 - i3) * o1 * o3) / i1 + o1 * phi_dot,
            moment3 / i3,
        ];
        highest.copy_from_slice(&accelerations(s, omega_dot));
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let (omega, momentum) = (omega(s), momentum(s));
        out[0] = dot(momentum, omega) * 0.5;
        out[1] = momentum[2];
        out[2..5].copy_from_slice(&to_space(s, momentum));
        out[5] = dot(momentum, momentum).sqrt();
        out[6..9].copy_from_slice(&omega);
        out[9..12].copy_from_slice(&axis(s));
    }

    #[inline(always)]
    fn lagrangian<S: Scalar>(&self, s: &State<S>) -> Option<S> {
        Some(dot(momentum(s), omega(s)) * 0.5)
    }

    fn start(&self, _given: &Given, values: &Values<f64>, y: &mut [f64]) -> Result<(), String> {
        start_on_the_vertical(y, 3, values.numbers[1] / (2.0 * values.numbers[0]));
        Ok(())
    }

    fn check(&self, s: &State<f64>) -> Result<(), String> {
        let [i1, i3] = s.p();
        super::possible_inertia([i1, i1, i3])
    }
}
