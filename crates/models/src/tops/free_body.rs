//! A rigid body on which no force acts (Euler and Poinsot), or a given torque.
//!
//!     i1 omega1' = (i2 - i3) omega2 omega3 + torque1   and cyclically           (Euler, in body axes)
//!     q' = q (0, omega) / 2                                                      (quaternion, body to space)
//!
//! (T, section 7.1; Landau and Lifshitz, Mechanics, paragraphs 36 and 37.) Without torque the energy and the
//! angular momentum in space are constant. Turning about the axis of the middle moment of inertia is
//! unstable. Where two moments are equal this is the free symmetric top.
//!
//! The length of the quaternion is constant too, and stays 1 but for the error of the method. Starts may be
//! given as Euler angles and their rates, R = Rz(psi) Rx(theta) Rz(phi).

use crate::rotation::{dot, euler, from_euler, omega_from_rates, quaternion_rate, to_space};
use precess_scalar::Scalar;
use precess_system::{Card, Coordinate, Given, State, System, Values, card, coordinate, number};

/// See the module.
#[derive(Clone)]
pub struct FreeBody;

const TORQUES: [&str; 3] = ["torque1", "torque2", "torque3"];
const QUATERNION: [&str; 4] = ["qw", "qx", "qy", "qz"];
const OMEGA: [&str; 3] = ["omega1", "omega2", "omega3"];
const ANGLES: [&str; 3] = ["psi", "theta", "phi"];
const RATES: [&str; 3] = ["psi_dot", "theta_dot", "phi_dot"];

/// The two halves of the state: attitude and angular velocity in body axes.
#[inline(always)]
fn halves<S: Scalar>(s: &State<S>) -> ([S; 4], [S; 3]) {
    let [qw, qx, qy, qz, o1, o2, o3] = s.q();
    ([qw, qx, qy, qz], [o1, o2, o3])
}

/// The values given for some names, zero for the others; `None` where none is given.
fn group<const N: usize>(given: &Given, names: [&str; N]) -> Option<[f64; N]> {
    let values = names.map(|name| given.get(name));
    values.iter().any(Option::is_some).then(|| values.map(|value| value.unwrap_or(0.0)))
}

fn coordinates(card: Card) -> Card {
    let part = |name, en, fr| coordinate(name, "", en, fr).first_order();
    let turn =
        |name, start, en, fr| -> Coordinate { coordinate(name, "rad/s", en, fr).first_order().start(start) };
    card.coordinate(part("qw", "attitude, real part", "attitude, partie réelle").start(1.0))
        .coordinate(part("qx", "attitude, first part", "attitude, première partie"))
        .coordinate(part("qy", "attitude, second part", "attitude, deuxième partie"))
        .coordinate(part("qz", "attitude, third part", "attitude, troisième partie"))
        .coordinate(turn("omega1", 1.0, "angular velocity along axis 1", "vitesse angulaire selon l'axe 1"))
        .coordinate(turn("omega2", 0.8, "angular velocity along axis 2", "vitesse angulaire selon l'axe 2"))
        .coordinate(turn("omega3", 1.2, "angular velocity along axis 3", "vitesse angulaire selon l'axe 3"))
        .start("psi", "rad", "precession", "précession")
        .start("theta", "rad", "nutation", "nutation")
        .start("phi", "rad", "proper rotation", "rotation propre")
        .start("psi_dot", "rad/s", "rate of precession", "vitesse de précession")
        .start("theta_dot", "rad/s", "rate of nutation", "vitesse de nutation")
        .start("phi_dot", "rad/s", "rate of proper rotation", "vitesse de rotation propre")
}

fn observables(card: Card) -> Card {
    let momentum = |card: Card, name, en, fr| card.invariant_if(name, "kg m^2/s", &TORQUES, en, fr);
    let card = card.invariant_if("energy", "J", &TORQUES, "kinetic energy", "énergie cinétique");
    let card = momentum(card, "Lx", "angular momentum along x", "moment cinétique selon x");
    let card = momentum(card, "Ly", "angular momentum along y", "moment cinétique selon y");
    let card = momentum(card, "Lz", "angular momentum along z", "moment cinétique selon z");
    let card = momentum(card, "L", "magnitude of the angular momentum", "norme du moment cinétique");
    card.invariant("norm", "", "length of the quaternion", "norme du quaternion")
        .signal("psi", "rad", "precession", "précession")
        .signal("theta", "rad", "nutation", "nutation")
        .signal("phi", "rad", "proper rotation", "rotation propre")
        .signal("psi_dot", "rad/s", "rate of precession", "vitesse de précession")
        .signal("theta_dot", "rad/s", "rate of nutation", "vitesse de nutation")
        .signal("phi_dot", "rad/s", "rate of proper rotation", "vitesse de rotation propre")
        .signal("axis_x", "", "axis 3 in space, along x", "axe 3 dans l'espace, selon x")
        .signal("axis_y", "", "axis 3 in space, along y", "axe 3 dans l'espace, selon y")
        .signal("axis_z", "", "axis 3 in space, along z", "axe 3 dans l'espace, selon z")
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
        let card = coordinates(card)
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
        let [angles, rates] = euler(attitude, omega);
        out[0] = dot(momentum, omega) * 0.5;
        out[1..4].copy_from_slice(&to_space(attitude, momentum));
        out[4] = dot(momentum, momentum).sqrt();
        out[5] = (qw + qx + qy + qz).sqrt();
        out[6..9].copy_from_slice(&angles);
        out[9..12].copy_from_slice(&rates);
        out[12..].copy_from_slice(&to_space(attitude, [zero, zero, one]));
    }

    fn start(&self, given: &Given, _values: &Values<f64>, y: &mut [f64]) -> Result<(), String> {
        let angles = group(given, ANGLES);
        if angles.is_some() && group(given, QUATERNION).is_some() {
            return Err("the attitude is given twice: as a quaternion and as Euler angles".into());
        }
        let q = match angles {
            Some(angles) => from_euler(angles),
            None => [y[0], y[1], y[2], y[3]],
        };
        let norm = (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]).sqrt();
        if !(norm > 0.0 && norm.is_finite()) {
            return Err("the quaternion qw, qx, qy, qz has no direction: it must not be zero".into());
        }
        y[..4].copy_from_slice(&q.map(|part| part / norm));
        let Some(rates) = group(given, RATES) else { return Ok(()) };
        if group(given, OMEGA).is_some() {
            return Err(
                "the angular velocity is given twice: as omega1, omega2, omega3 and as rates of the \
                        Euler angles"
                    .into(),
            );
        }
        let attitude = [y[0], y[1], y[2], y[3]];
        let angles = angles.unwrap_or_else(|| euler(attitude, [0.0; 3])[0]);
        y[4..7].copy_from_slice(&omega_from_rates(angles, rates));
        Ok(())
    }

    fn check(&self, s: &State<f64>) -> Result<(), String> {
        let [i1, i2, i3] = s.p();
        for (a, b, c, name) in [(i1, i2, i3, "i1"), (i2, i3, i1, "i2"), (i3, i1, i2, "i3")] {
            // A flat body has equality, which rounding may just miss.
            if a > (b + c) * (1.0 + 1e-12) {
                return Err(format!(
                    "no body has these moments of inertia: {name} = {a} exceeds the sum {} of the two others",
                    b + c
                ));
            }
        }
        Ok(())
    }
}
