//! The card that the three formulations of T's simple gyroscope share, and what they observe.

use super::euler_angles::{axis, omega};
use super::lagrange::{Start, lagrange};
use crate::rotation::dot;
use precess_scalar::Scalar;
use precess_system::{Card, State, Values, number};
use std::f64::consts::PI;

/// T's cone (6.1): density, height and radius; its mass and inertia (3.3).
const DENSITY: f64 = 100.0;
const HEIGHT: f64 = 0.15;
const RADIUS: f64 = 0.05;
pub(super) const MASS: f64 = PI * DENSITY * RADIUS * RADIUS * HEIGHT / 3.0;
pub(super) const I1: f64 = 3.0 * MASS / 20.0 * (RADIUS * RADIUS + HEIGHT * HEIGHT / 4.0);
pub(super) const I3: f64 = 3.0 * MASS / 10.0 * RADIUS * RADIUS;
pub(super) const D: f64 = 3.0 * HEIGHT / 4.0;

const MOMENTS: [&str; 3] = ["moment1", "moment2", "moment3"];

/// Mass, inertia, arm, gravity.
pub(super) fn body(card: Card) -> Card {
    card.parameter(number("m", "kg", MASS, "mass", "masse").positive())
        .parameter(
            number("i1", "kg m^2", I1, "transverse inertia at G", "inertie transverse en G").positive(),
        )
        .parameter(number("i3", "kg m^2", I3, "inertia about the axis", "inertie axiale").positive())
        .parameter(number("d", "m", D, "distance from A to G", "distance de A à G"))
        .parameter(number("g", "m/s^2", 9.81, "gravity", "pesanteur"))
}

/// The applied moment (T, equations 10 to 12).
pub(super) fn moments(card: Card) -> Card {
    card.parameter(number("moment1", "N m", 0.0, "applied moment along u", "moment appliqué selon u"))
        .parameter(number("moment2", "N m", 0.0, "applied moment along b", "moment appliqué selon b"))
        .parameter(number("moment3", "N m", 0.0, "applied moment along a", "moment appliqué selon a"))
}

/// Invariants and signals, with an applied moment or without.
pub(super) fn observables(card: Card, applied: bool) -> Card {
    let when = |names: &'static [&'static str]| if applied { names } else { &[] };
    let card = card
        .invariant_if("energy", "J", when(&MOMENTS), "total energy", "énergie totale")
        .invariant_if(
            "L_A3",
            "kg m^2/s",
            when(&MOMENTS[2..]),
            "angular momentum at A along the axis",
            "moment cinétique en A selon l'axe",
        )
        .invariant_if(
            "L_Az",
            "kg m^2/s",
            when(&MOMENTS[1..]),
            "angular momentum at A along the vertical",
            "moment cinétique en A selon la verticale",
        )
        .signal("kinetic", "J", "kinetic energy", "énergie cinétique")
        .signal("potential", "J", "potential energy", "énergie potentielle");
    super::euler_angles::omega_and_axis(card)
        .signal("L_A", "kg m^2/s", "angular momentum at A", "moment cinétique en A")
        .signal("L_G", "kg m^2/s", "angular momentum at G", "moment cinétique en G")
        .signal("effective_potential", "J", "effective potential V(theta)", "potentiel effectif V(theta)")
        .signal("nutation_energy", "J", "energy of the nutation", "énergie de la nutation")
}

/// Moments of inertia about A, in (u, b, a).
#[inline(always)]
pub(super) fn inertia<S: Scalar>(s: &State<S>) -> [S; 3] {
    let [m, i1, i3, d] = s.p();
    let i_a1 = i1 + m * d * d;
    [i_a1, i_a1, i3]
}

/// Kinetic and potential energy (zero with G at the height of A).
#[inline(always)]
pub(super) fn energies<S: Scalar>(s: &State<S>) -> (S, S) {
    let ([_psi, theta], [m, _i1, _i3, d, g]) = (s.q(), s.p());
    (dot(inertia(s), omega(s).map(S::squared)) * 0.5, m * g * d * theta.cos())
}

/// The observables of a state that has the rates of the angles.
#[inline(always)]
pub(super) fn observe<S: Scalar>(s: &State<S>, out: &mut [S]) {
    let [m, i1, i3, d, g] = s.p();
    observe_at(s, inertia(s), omega(s), [m, i1, i3, d, g], out);
}

/// The observables from the angular velocity in (u, b, a).
#[inline(always)]
pub(super) fn observe_at<S: Scalar>(
    s: &State<S>,
    inertia: [S; 3],
    omega: [S; 3],
    [m, i1, i3, d, g]: [S; 5],
    out: &mut [S],
) {
    let [_psi, theta] = s.q();
    let (sin, cos) = theta.sin_cos();
    let [o1, o2, o3] = omega;
    let at_a: [S; 3] = std::array::from_fn(|i| inertia[i] * omega[i]);
    let at_g = [i1 * o1, i1 * o2, i3 * o3];
    let (kinetic, potential) = (dot(at_a, omega) * 0.5, m * g * d * cos);
    // T's (21): 2E = I_A1 theta'^2 + V(theta); here half of V, an energy.
    let nutation = inertia[0] * o1 * o1 * 0.5;
    out[..3].copy_from_slice(&[kinetic + potential, at_a[2], at_a[1] * sin + at_a[2] * cos]);
    out[3..8].copy_from_slice(&[kinetic, potential, o1, o2, o3]);
    out[8..11].copy_from_slice(&axis(s));
    out[11] = dot(at_a, at_a).sqrt();
    out[12] = dot(at_g, at_g).sqrt();
    out[13] = (at_a[1] * o2 + at_a[2] * o3) * 0.5 + potential;
    out[14] = nutation;
}

/// The share of omega3 that precesses where the axis passes through the vertical, i3 / (2 `I_A1`).
pub(super) fn share_on_the_vertical(values: &Values<f64>) -> f64 {
    let [m, i1, i3, d] = *values.numbers.first_chunk().expect("the card begins with the body");
    i3 / (2.0 * (i1 + m * d * d))
}

/// Whether the motion has the closed form of [`lagrange`], in Euler angles.
///
/// # Errors
/// One sentence: why not.
pub(super) fn solvable(s: &State<f64>) -> Result<(), String> {
    let [m, _i1, _i3, d, g, moments @ ..] = s.p::<8>();
    if moments != [0.0; 3] {
        return Err("its closed form knows no applied moment: set moment1, moment2 and moment3 to 0".into());
    }
    if m * g * d == 0.0 {
        return Err("without weight it is a free body: free_body has that motion in closed form".into());
    }
    let [up, down] = barriers(&start(s));
    if up == 0.0 || down == 0.0 {
        return Err(
            "its axis may pass through the vertical, where Euler angles jump: heavy_top has that motion in \
                    closed form"
                .into(),
        );
    }
    Ok(())
}

/// (`L_Az` +- `L_A3`) / `I_A1`, which keep the axis off the vertical.
fn barriers(start: &Start<f64>) -> [f64; 2] {
    let momentum = start.omega[1] * start.sin;
    [momentum + start.a * start.above, momentum - start.a * start.below]
}

#[inline(always)]
fn start<S: Scalar>(s: &State<S>) -> Start<S> {
    let ([_psi, theta], [m, _i1, i3, d, g]) = (s.q(), s.p());
    let ((half_sin, half_cos), sin) = ((theta * 0.5).sin_cos(), theta.sin());
    let (omega, [i_a1, ..]) = (omega(s), inertia(s));
    Start {
        above: half_cos * half_cos * 2.0,
        below: half_sin * half_sin * 2.0,
        sin,
        omega,
        beta: m * g * d * 2.0 / i_a1,
        a: i3 * omega[2] / i_a1,
    }
}

/// Angles and rates at time t.
#[inline(always)]
pub(super) fn solution<S: Scalar>(s: &State<S>, t: S, q: &mut [S], v: &mut [S]) {
    let [psi, theta, phi] = s.q();
    let start = start(s);
    let now = lagrange(&start, t - s.t);
    // Angles grow past pi where the sine is below zero.
    let side = S::select(start.sin.lt(S::from(0.0)), S::from(-1.0), S::from(1.0));
    let angle = |above: S, below: S| below.sqrt().atan2(above.sqrt()) * 2.0;
    let (sin, cos) = ((now.above * now.below).sqrt(), (now.above - now.below) * 0.5);
    let opened = angle(now.above, now.below) - angle(start.above, start.below);
    let psi_dot = now.omega[1] / sin;
    q.copy_from_slice(&[psi + now.psi, theta + side * opened, phi + now.phi]);
    v.copy_from_slice(&[psi_dot, side * now.omega[0], start.omega[2] - cos * psi_dot]);
}
