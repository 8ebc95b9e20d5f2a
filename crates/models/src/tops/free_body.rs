//! A rigid body on which no force acts (Euler and Poinsot), or a given torque.
//!
//!     i1 omega1' = (i2 - i3) omega2 omega3 + torque1   and cyclically           (Euler, in body axes)
//!     q' = q (0, omega) / 2                                                      (quaternion, body to space)
//!
//! (T, section 7.1; Landau and Lifshitz, Mechanics, paragraphs 36 and 37.) Without torque the energy and the
//! angular momentum in space are constant. Turning about the axis of the middle moment of inertia is
//! unstable. Where two moments are equal this is the free symmetric top.
//!
//! The tip of omega draws the *polhode* on the body's ellipsoid of inertia (the coordinates omega1..3) and the
//! *herpolhode* on the invariable plane, which the ellipsoid rolls on (`herpolhode_x`, `herpolhode_y`; T 7.1 has the two
//! names the other way round).
//!
//! The length of the quaternion is constant too, and stays 1 but for the error of the method. Starts may be
//! given as Euler angles and their rates, R = Rz(psi) Rx(theta) Rz(phi).

use super::poinsot::poinsot;
use crate::attitude::{self, halves};
use crate::rotation::{cross, dot, invariable_plane, quaternion_rate, quotient, to_space};
use precess_scalar::Scalar;
use precess_system::{Card, Given, State, System, Values, card, number};

/// See the module.
#[derive(Clone)]
pub struct FreeBody;

const TORQUES: [&str; 3] = ["torque1", "torque2", "torque3"];

fn observables(card: Card) -> Card {
    let momentum = |card: Card, name, en, fr| card.invariant_if(name, "kg m^2/s", &TORQUES, en, fr);
    let card = card.invariant_if("energy", "J", &TORQUES, "kinetic energy", "énergie cinétique");
    let card = momentum(card, "Lx", "angular momentum along x", "moment cinétique selon x");
    let card = momentum(card, "Ly", "angular momentum along y", "moment cinétique selon y");
    let card = momentum(card, "Lz", "angular momentum along z", "moment cinétique selon z");
    let card = momentum(card, "L", "magnitude of the angular momentum", "norme du moment cinétique")
        .invariant("norm", "", "length of the quaternion", "norme du quaternion");
    attitude::angles(card)
        .signal("axis_x", "", "axis 3 in space, along x", "axe 3 dans l'espace, selon x")
        .signal("axis_y", "", "axis 3 in space, along y", "axe 3 dans l'espace, selon y")
        .signal("axis_z", "", "axis 3 in space, along z", "axe 3 dans l'espace, selon z")
        .signal("L1", "kg m^2/s", "angular momentum along axis 1", "moment cinétique selon l'axe 1")
        .signal("L2", "kg m^2/s", "angular momentum along axis 2", "moment cinétique selon l'axe 2")
        .signal("L3", "kg m^2/s", "angular momentum along axis 3", "moment cinétique selon l'axe 3")
        .signal("omega_x", "rad/s", "angular velocity along x", "vitesse angulaire selon x")
        .signal("omega_y", "rad/s", "angular velocity along y", "vitesse angulaire selon y")
        .signal("omega_z", "rad/s", "angular velocity along z", "vitesse angulaire selon z")
        .signal("herpolhode_x", "rad/s", "herpolhode, abscissa", "herpolhodie, abscisse")
        .signal("herpolhode_y", "rad/s", "herpolhode, ordinate", "herpolhodie, ordonnée")
        .invariant_if(
            "herpolhode_z",
            "rad/s",
            &TORQUES,
            "distance of the invariable plane",
            "distance du plan invariable",
        )
        .signal("triple", "J", "axis . (omega x L)", "axe . (omega x L)")
}

impl System for FreeBody {
    fn card(&self) -> Card {
        let card = card("free_body", "Free rigid body", "Solide libre")
            .about(
                "A rigid body on which nothing acts: its angular momentum rests in space while the body rolls \
                 about it. About the middle axis of inertia it tumbles over and over.",
                "Un solide sur lequel rien n'agit : son moment cinétique reste fixe dans l'espace tandis que le \
                 corps roule autour. Autour de l'axe d'inertie moyen, il se retourne sans cesse.",
            )
            .source("T, section 7.1; Landau and Lifshitz, Mechanics, paragraphs 36 and 37");
        let card = attitude::coordinates(card, [1.0, 0.0, 0.0, 0.0], [1.0, 0.8, 1.2])
            .parameter(
                number("i1", "kg m^2", 1.0, "inertia about axis 1", "inertie selon l'axe 1").positive(),
            )
            .parameter(
                number("i2", "kg m^2", 2.0, "inertia about axis 2", "inertie selon l'axe 2").positive(),
            )
            .parameter(
                number("i3", "kg m^2", 3.0, "inertia about axis 3", "inertie selon l'axe 3").positive(),
            )
            .parameter(number("torque1", "N m", 0.0, "torque along axis 1", "moment selon l'axe 1"))
            .parameter(number("torque2", "N m", 0.0, "torque along axis 2", "moment selon l'axe 2"))
            .parameter(number("torque3", "N m", 0.0, "torque along axis 3", "moment selon l'axe 3"));
        observables(card)
            .time_view(&["omega1", "omega2", "omega3"])
            .phase_view("omega1", "omega2")
            .path_view("axis_x", "axis_y")
            .path_view("herpolhode_x", "herpolhode_y")
            .run(20.0, 0.001)
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let (attitude, [o1, o2, o3]) = halves(s);
        let [i1, i2, i3, torque1, torque2, torque3] = s.p();
        highest[..4].copy_from_slice(&quaternion_rate(attitude, [o1, o2, o3]));
        highest[4] = ((i2 - i3) * o2 * o3 + torque1) / i1;
        highest[5] = ((i3 - i1) * o3 * o1 + torque2) / i2;
        highest[6] = ((i1 - i2) * o1 * o2 + torque3) / i3;
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let (attitude, omega) = halves(s);
        let [i1, i2, i3] = s.p();
        let momentum = [i1 * omega[0], i2 * omega[1], i3 * omega[2]];
        let [qw, qx, qy, qz] = attitude.map(S::squared);
        let [zero, one] = [0.0, 1.0].map(S::from);
        let magnitude = dot(momentum, momentum).sqrt();
        let (in_space, turning) = (to_space(attitude, momentum), to_space(attitude, omega));
        let axis = [zero, zero, one];
        out[0] = dot(momentum, omega) * 0.5;
        out[1..4].copy_from_slice(&in_space);
        out[4] = magnitude;
        out[5] = (qw + qx + qy + qz).sqrt();
        attitude::observe(attitude, omega, &mut out[6..12]);
        out[12..15].copy_from_slice(&to_space(attitude, axis));
        out[15..18].copy_from_slice(&momentum);
        out[18..21].copy_from_slice(&turning);
        let normal = in_space.map(|part| quotient(part, magnitude));
        out[21..24].copy_from_slice(&invariable_plane(normal, turning));
        out[24] = dot(axis, cross(omega, momentum));
    }

    fn solvable(&self, s: &State<f64>) -> Result<(), String> {
        let [_, _, _, torque @ ..] = s.p::<6>();
        if torque == [0.0; 3] {
            return Ok(());
        }
        Err("its closed form knows no torque: set torque1, torque2 and torque3 to 0".into())
    }

    #[inline(always)]
    fn solution<S: Scalar>(&self, s: &State<S>, t: S, q: &mut [S], _v: &mut [S]) {
        let (attitude, omega) = halves(s);
        let (attitude, omega) = poinsot(s.p(), attitude, omega, t - s.t);
        q[..4].copy_from_slice(&attitude);
        q[4..7].copy_from_slice(&omega);
    }

    fn start(&self, given: &Given, _values: &Values<f64>, y: &mut [f64]) -> Result<(), String> {
        attitude::start(given, y)
    }

    fn check(&self, s: &State<f64>) -> Result<(), String> {
        let [i1, i2, i3] = s.p();
        super::possible_inertia([i1, i2, i3])
    }
}
