//! The attitude that bodies in quaternions share: coordinates, starts by Euler angles, the angles as observables.

use crate::rotation::{Quaternion, Vector, euler, from_euler, omega_from_rates};
use precess_scalar::Scalar;
use precess_system::{Card, Given, State, coordinate};

const QUATERNION: [&str; 4] = ["qw", "qx", "qy", "qz"];
const OMEGA: [&str; 3] = ["omega1", "omega2", "omega3"];
const ANGLES: [&str; 3] = ["psi", "theta", "phi"];
const RATES: [&str; 3] = ["psi_dot", "theta_dot", "phi_dot"];

/// How many coordinates attitude and angular velocity are.
pub(crate) const COORDINATES: usize = 7;
/// How many observables [`angles`] adds.
pub(crate) const OBSERVABLES: usize = 6;

/// The two halves of the state: attitude and angular velocity in body axes.
#[inline(always)]
pub(crate) fn halves<S: Scalar>(s: &State<S>) -> (Quaternion<S>, Vector<S>) {
    let [qw, qx, qy, qz, o1, o2, o3] = s.q();
    ([qw, qx, qy, qz], [o1, o2, o3])
}

/// Adds the coordinates, with their starts, and the Euler angles as further names for a start.
pub(crate) fn coordinates(card: Card, attitude: Quaternion<f64>, omega: Vector<f64>) -> Card {
    let texts = [
        ("attitude, real part", "attitude, partie réelle"),
        ("attitude, first part", "attitude, première partie"),
        ("attitude, second part", "attitude, deuxième partie"),
        ("attitude, third part", "attitude, troisième partie"),
    ];
    let card = (0..4).fold(card, |card, i| {
        let (en, fr) = texts[i];
        let part = coordinate(QUATERNION[i], "", en, fr).first_order().start(attitude[i]);
        card.coordinate(if i == 0 { part.begins_attitude() } else { part })
    });
    let card = (0..3).fold(card, |card, i| {
        let en = format!("angular velocity along axis {}", i + 1);
        let fr = format!("vitesse angulaire selon l'axe {}", i + 1);
        card.coordinate(coordinate(OMEGA[i], "rad/s", &en, &fr).first_order().start(omega[i]))
    });
    card.start("psi", "rad", "precession", "précession")
        .start("theta", "rad", "nutation", "nutation")
        .start("phi", "rad", "proper rotation", "rotation propre")
        .start("psi_dot", "rad/s", "rate of precession", "vitesse de précession")
        .start("theta_dot", "rad/s", "rate of nutation", "vitesse de nutation")
        .start("phi_dot", "rad/s", "rate of proper rotation", "vitesse de rotation propre")
}

/// Adds the Euler angles and their rates as observables.
pub(crate) fn angles(card: Card) -> Card {
    card.signal("psi", "rad", "precession", "précession")
        .signal("theta", "rad", "nutation", "nutation")
        .signal("phi", "rad", "proper rotation", "rotation propre")
        .signal("psi_dot", "rad/s", "rate of precession", "vitesse de précession")
        .signal("theta_dot", "rad/s", "rate of nutation", "vitesse de nutation")
        .signal("phi_dot", "rad/s", "rate of proper rotation", "vitesse de rotation propre")
}

/// The observables of [`angles`].
#[inline(always)]
pub(crate) fn observe<S: Scalar>(attitude: Quaternion<S>, omega: Vector<S>, out: &mut [S]) {
    let [angles, rates] = euler(attitude, omega);
    out[..3].copy_from_slice(&angles);
    out[3..OBSERVABLES].copy_from_slice(&rates);
}

/// The values given for some names, zero for the others; `None` where none is given.
fn group<const N: usize>(given: &Given, names: [&str; N]) -> Option<[f64; N]> {
    let values = names.map(|name| given.get(name));
    values.iter().any(Option::is_some).then(|| values.map(|value| value.unwrap_or(0.0)))
}

/// Sets attitude (of unit length) and angular velocity from what is given.
///
/// # Errors
/// Where either is given twice, or the attitude is no direction.
pub(crate) fn start(given: &Given, y: &mut [f64]) -> Result<(), String> {
    let angles = group(given, ANGLES);
    if angles.is_some() && group(given, QUATERNION).is_some() {
        return Err("the attitude is given twice: as a quaternion and as Euler angles".into());
    }
    let q = angles.map_or([y[0], y[1], y[2], y[3]], from_euler);
    let norm = (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]).sqrt();
    if !(norm > 0.0 && norm.is_finite()) {
        return Err("the quaternion qw, qx, qy, qz has no direction: it must not be zero".into());
    }
    let attitude = q.map(|part| part / norm);
    y[..4].copy_from_slice(&attitude);
    let Some(rates) = group(given, RATES) else { return Ok(()) };
    if group(given, OMEGA).is_some() {
        return Err(
            "the angular velocity is given twice: as omega1, omega2, omega3 and as rates of the Euler \
                    angles"
                .into(),
        );
    }
    let angles = angles.unwrap_or_else(|| euler(attitude, [0.0; 3])[0]);
    y[4..COORDINATES].copy_from_slice(&omega_from_rates(angles, rates));
    Ok(())
}
