//! Any top of revolution that rolls, by T's school method (6.3): equation (9), with a choice for the rate of `I_A`.
//!
//! The contact point A moves over the body, so `I_A` changes. `contact_inertia_rate` says what is made of that:
//!
//! * `neglected`: `I_A' = 0`, T's assumption "to simplify, even if it is not physically justified";
//! * `finite_difference`: `(I_A(now) - I_A(a time tau ago)) / tau`, T's alternative (c);
//! * `exact`: its derivative.
//!
//! T's (9) also forgets that the geometric point A is no point of the body:
//!
//!     (I_A omega)' + omega_e x I_A omega = M_A - m A' x v_G        A' = r', the velocity of A over the body      (corrected)
//!
//! `moments_at_contact = as_printed` leaves the last term out; with `neglected`, which takes A to rest in the body, it is out
//! anyway. And `M_A` is `GA x m g k`, which is T's `m g d sin theta u` only where A lies on the axis.
//!
//! The surface is given by its support function `h(n) = point n3 + sqrt(across^2 (n1^2 + n2^2) + along^2 n3^2)` from G: a
//! spheroid about a point of the axis, a sphere, or a tip (point = -d, no axes). Then, in (u, b, a),
//!
//!     r = GA = (0, -across^2/w sin theta, point - along^2/w cos theta)
//!     w^2 = across^2 sin^2 theta + along^2 cos^2 theta     r' = across^2 along^2 / w^3 theta' (0, -cos theta, sin theta)
//!
//! The latter is the radius of curvature of the profile. G moves with `v_G = r x omega`, and its height is integrated though the
//! contact fixes it, as T does: `gap` is the difference. With `exact` this is the rolling tippe top of (16) to (18).

use super::contact::{omega_rate, vertical};
use super::euler_angles::{accelerations, omega, start_on_the_vertical, to_space};
use super::truncated_sphere::{ALPHA, I1, I3, MASS, RADIUS};
use crate::inertia::{Matrix, apply, diagonal, transferred};
use crate::rotation::{cross, dot, quotient};
use precess_scalar::Scalar;
use precess_system::{
    Card, Given, Layout, ObservableKind, State, System, Values, card, choice, coordinate, number,
};

/// See the module.
#[derive(Clone)]
pub struct RollingTop;

const NEGLECTED: usize = 0;
const FINITE_DIFFERENCE: usize = 1;
const EXACT: usize = 2;
const CORRECTED: usize = 0;

/// GA in (u, b, a) at an inclination, and the radius of curvature of the profile there.
#[inline(always)]
fn contact<S: Scalar>(s: &State<S>, theta: S) -> ([S; 3], S) {
    let [_m, _i1, _i3, _g, point, across, along] = s.p();
    let (sin, cos) = theta.sin_cos();
    let (across2, along2) = (across * across, along * along);
    let w = (across2 * sin * sin + along2 * cos * cos).sqrt();
    let arm = [S::from(0.0), -(quotient(across2, w) * sin), point - quotient(along2, w) * cos];
    (arm, quotient(across2 * along2, w * w * w))
}

/// The inertia about the contact point at an inclination.
#[inline(always)]
fn inertia<S: Scalar>(s: &State<S>, theta: S) -> Matrix<S> {
    let [m, i1, i3] = s.p();
    transferred(diagonal([i1, i1, i3]), m, contact(s, theta).0)
}

/// GA now and an angle before, and their difference, as a product of its sine: nothing is lost where the angle is small.
#[inline(always)]
fn apart<S: Scalar>(s: &State<S>, angle: S) -> ([S; 3], [S; 3], [S; 3]) {
    let [_psi, theta] = s.q();
    let [_m, _i1, _i3, _g, _point, across, along] = s.p();
    let (across2, along2, earlier) = (across * across, along * along, theta - angle);
    let (half_sin, half_cos) = (angle * 0.5).sin_cos();
    let (mean_sin, mean_cos) = (theta - angle * 0.5).sin_cos();
    let w = |angle: S| {
        let (sin, cos) = angle.sin_cos();
        ((across2 * sin * sin + along2 * cos * cos).sqrt(), sin, cos)
    };
    let ((w0, _, _), (w1, sin, cos)) = (w(theta), w(earlier));
    // 1/w0 - 1/w1, from w1^2 - w0^2.
    let squares = -((across2 - along2) * half_sin * half_cos * mean_sin * mean_cos * 4.0);
    let inverse = quotient(squares, w0 * w1 * (w0 + w1));
    let sines = quotient(mean_cos * half_sin * 2.0, w0) + sin * inverse;
    let cosines = cos * inverse - quotient(mean_sin * half_sin * 2.0, w0);
    let moved = [S::from(0.0), -(across2 * sines), -(along2 * cosines)];
    (contact(s, theta).0, contact(s, earlier).0, moved)
}

/// The derivative of the components of GA in (u, b, a).
#[inline(always)]
fn arm_rate<S: Scalar>(s: &State<S>) -> [S; 3] {
    let ([_psi, theta], [_psi_dot, theta_dot]) = (s.q(), s.v());
    let (sin, cos) = theta.sin_cos();
    let rolled = contact(s, theta).1 * theta_dot;
    [S::from(0.0), -(rolled * cos), rolled * sin]
}

/// `I_A'` applied to omega, as the choice has it.
#[inline(always)]
fn inertia_rate<S: Scalar>(s: &State<S>, omega: [S; 3]) -> [S; 3] {
    let ([_psi, theta], [_psi_dot, theta_dot]) = (s.q(), s.v());
    let m = s.p::<1>()[0];
    match s.choice(0) {
        NEGLECTED => [S::from(0.0); 3],
        FINITE_DIFFERENCE => {
            let tau = s.p::<8>()[7];
            let (now, before, moved) = apart(s, theta_dot * tau);
            // r r^T of both: their difference, as products of `moved`.
            let sum: [S; 3] = std::array::from_fn(|i| now[i] + before[i]);
            let (square, along, turned) = (dot(moved, sum), dot(now, omega), dot(moved, omega));
            let change = |i: usize| square * omega[i] - moved[i] * along - before[i] * turned;
            std::array::from_fn(|i| m * change(i) / tau)
        }
        _ => {
            let (arm, rate) = (contact(s, theta).0, arm_rate(s));
            let (square, along, turned) = (dot(arm, rate) * 2.0, dot(arm, omega), dot(rate, omega));
            std::array::from_fn(|i| m * (square * omega[i] - rate[i] * along - arm[i] * turned))
        }
    }
}

/// `m A' x v_G`, the term that (9) lacks.
#[inline(always)]
fn moving_contact<S: Scalar>(s: &State<S>, omega: [S; 3]) -> [S; 3] {
    let ([_psi, theta], [_psi_dot, _theta_dot, phi_dot]) = (s.q(), s.v());
    let (zero, m) = (S::from(0.0), s.p::<1>()[0]);
    let arm = contact(s, theta).0;
    // In the body's own axes, which turn by phi' against (u, b, a).
    let (rate, turned) = (arm_rate(s), cross([zero, zero, phi_dot], arm));
    let over_body: [S; 3] = std::array::from_fn(|i| rate[i] - turned[i]);
    cross(over_body, cross(arm, omega)).map(|part| m * part)
}

/// Kinetic and potential energy (zero at the height of the table).
#[inline(always)]
fn energies<S: Scalar>(s: &State<S>) -> (S, S) {
    let ([_psi, theta], [m, i1, i3, g]) = (s.q(), s.p());
    let (omega, arm) = (omega(s), contact(s, theta).0);
    let v = cross(arm, omega);
    let kinetic = (m * dot(v, v) + dot([i1, i1, i3], omega.map(S::squared))) * 0.5;
    (kinetic, -(m * g * dot(arm, vertical(s))))
}

fn parameters(card: Card) -> Card {
    card.parameter(number("m", "kg", MASS, "mass", "masse").positive())
        .parameter(
            number("i1", "kg m^2", I1, "transverse inertia at G", "inertie transverse en G").positive(),
        )
        .parameter(number("i3", "kg m^2", I3, "inertia about the axis", "inertie axiale").positive())
        .parameter(number("g", "m/s^2", 9.81, "gravity", "pesanteur"))
        .parameter(number(
            "point",
            "m",
            RADIUS * ALPHA,
            "from G along the axis to the tip or centre",
            "de G à la pointe ou au centre, selon l'axe",
        ))
        .parameter(
            number(
                "across",
                "m",
                RADIUS,
                "semi-axis of the spheroid across",
                "demi-axe transverse du sphéroïde",
            )
            .not_negative(),
        )
        .parameter(
            number("along", "m", RADIUS, "its semi-axis along the axis", "son demi-axe selon l'axe")
                .not_negative(),
        )
        .parameter(
            number("tau", "s", 1e-3, "time of the finite difference", "durée de la différence finie")
                .positive(),
        )
        .parameter(choice(
            "contact_inertia_rate",
            &["neglected", "finite_difference", "exact"],
            "what is made of the rate of I_A",
            "ce que l'on fait de la dérivée de I_A",
        ))
        .parameter(choice(
            "moments_at_contact",
            &["corrected", "as_printed"],
            "the term m A' x v_G, which the printed (9) lacks",
            "le terme m A' x v_G, absent de l'équation (9) imprimée",
        ))
}

impl System for RollingTop {
    fn card(&self) -> Card {
        let second = |name, en, fr| coordinate(name, "rad", en, fr);
        let first = |name, en, fr| coordinate(name, "m", en, fr).first_order();
        let height = RADIUS - RADIUS * ALPHA * Scalar::cos(0.4);
        let card = card("rolling_top", "Any rolling top", "Toupie quelconque roulante")
            .about(
                "The course's general method for a top that rolls, with the rate of the inertia at the contact neglected, \
                 differenced or exact: how much a convenient assumption costs.",
                "La méthode générale du cours pour une toupie qui roule, où la dérivée de l'inertie au contact est \
                 négligée, approchée ou exacte : ce que coûte une hypothèse commode.",
            )
            .source("T, sections 4.2 and 6.3, equation 9")
            .coordinate(second("psi", "precession", "précession").start_dot(20.0))
            .coordinate(second("theta", "nutation", "nutation").start(0.4))
            .coordinate(second("phi", "proper rotation", "rotation propre").start_dot(120.0))
            .coordinate(first("gx", "centre of mass, abscissa", "centre de masse, abscisse"))
            .coordinate(first("gy", "centre of mass, ordinate", "centre de masse, ordonnée"))
            .coordinate(first("gz", "height of the centre of mass", "hauteur du centre de masse").start(height));
        parameters(card)
            .signal("energy", "J", "total energy", "énergie totale")
            .signal("jellett", "kg m^3/s", "Jellett's quantity, -L.GA", "quantité de Jellett, -L.GA")
            .signal(
                "L_Az",
                "kg m^2/s",
                "angular momentum at A along the vertical",
                "moment cinétique en A selon la verticale",
            )
            .signal(
                "L_A3",
                "kg m^2/s",
                "angular momentum at A along the axis",
                "moment cinétique en A selon l'axe",
            )
            .signal("triple", "J", "axis . (omega x L_A)", "axe . (omega x L_A)")
            .signal("gap", "m", "height of the lowest point", "hauteur du point le plus bas")
            .signal("kinetic", "J", "kinetic energy", "énergie cinétique")
            .signal("potential", "J", "potential energy", "énergie potentielle")
            .signal("omega3", "rad/s", "angular velocity along the axis", "vitesse angulaire selon l'axe")
            .signal("contact_x", "m", "contact point, abscissa", "point de contact, abscisse")
            .signal("contact_y", "m", "contact point, ordinate", "point de contact, ordonnée")
            .time_view(&["energy"])
            .time_view(&["jellett"])
            .path_view("contact_x", "contact_y")
            .time_view(&["theta"])
            .run(2.0, 1e-4)
    }

    /// The energy is constant with the exact rate and the corrected moments alone, Jellett's quantity then on a sphere.
    fn layout(&self, values: &Values<f64>, _given: &Given) -> Layout {
        let mut layout = Layout::of(&self.card());
        if values.choices == [EXACT, CORRECTED] {
            let spherical = values.numbers[5] == values.numbers[6];
            for observable in &mut layout.observables[..if spherical { 2 } else { 1 }] {
                observable.kind = ObservableKind::Invariant { when_zero: vec![] };
            }
        }
        layout
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([_psi, theta], [m, _i1, _i3, g]) = (s.q(), s.p());
        let (omega, arm) = (omega(s), contact(s, theta).0);
        let moment = cross(arm, vertical(s)).map(|part| m * g * part);
        let mut rest = inertia_rate(s, omega);
        if s.choice(0) != NEGLECTED && s.choice(1) == CORRECTED {
            let lacking = moving_contact(s, omega);
            rest = std::array::from_fn(|i| rest[i] + lacking[i]);
        }
        let omega_dot = omega_rate(s, inertia(s, theta), omega, moment, rest);
        highest[..3].copy_from_slice(&accelerations(s, omega_dot));
        highest[3..6].copy_from_slice(&to_space(s, cross(arm, omega)));
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let ([_psi, theta, _phi, gx, gy, gz], [_m, i1, i3]) = (s.q(), s.p());
        let (omega, arm) = (omega(s), contact(s, theta).0);
        let at_g = [i1 * omega[0], i1 * omega[1], i3 * omega[2]];
        let at_a = apply(inertia(s, theta), omega);
        let [zero, one] = [0.0, 1.0].map(S::from);
        let (kinetic, potential) = energies(s);
        let [x, y, z] = to_space(s, arm);
        out[0] = kinetic + potential;
        out[1] = -dot(at_g, arm);
        out[2] = dot(at_a, vertical(s));
        out[3] = at_a[2];
        out[4] = dot([zero, zero, one], cross(omega, at_a));
        out[5] = gz + z;
        out[6..9].copy_from_slice(&[kinetic, potential, omega[2]]);
        out[9..].copy_from_slice(&[gx + x, gy + y]);
    }

    fn start(&self, given: &Given, values: &Values<f64>, y: &mut [f64]) -> Result<(), String> {
        let s = State { t: 0.0, coordinates: &y[..6], velocities: &y[6..], modes: &[], values };
        let (arm, curvature) = contact(&s, y[1]);
        let height = -dot(arm, vertical(&s));
        let [m, i1, i3] = *values.numbers.first_chunk().expect("the card's parameters");
        let share = (i3 + m * height * curvature) / (2.0 * (i1 + m * height * height));
        if given.get("gz").is_none() {
            y[5] = height;
        }
        start_on_the_vertical(y, 6, share);
        Ok(())
    }

    fn check(&self, s: &State<f64>) -> Result<(), String> {
        let [_m, i1, i3] = s.p();
        super::possible_inertia([i1, i1, i3])
    }
}
