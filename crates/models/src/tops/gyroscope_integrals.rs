//! The gyroscope by its integrals (T, section 6.4): three constants leave one equation of the first order an angle.
//!
//! With M = `L_A3` = i3 omega3, L = `L_Az` and `I = i1 + m d^2`,
//!
//!     psi'   = H(theta) = (L - M cos theta) / (I sin^2 theta)                                          (19)
//!     phi'   = omega3 - cos theta H(theta)                                                             (20)
//!     theta' = +-sqrt((2E - V(theta)) / I)    V = i3 omega3^2 + 2 m g d cos theta + I H^2 sin^2 theta  (21, corrected)
//!
//! T prints V without `sin^2 theta` (`formula_21 = as_printed`). The constants follow from the rates at the start, which are
//! no part of the state. In partial fractions H has no difference of large numbers, and is regular on the vertical:
//!
//!     H = ((L + M) / (4 cos^2(theta/2)) + (L - M) / (4 sin^2(theta/2))) / I
//!
//! **Where theta' turns.** Its root is zero there, so (21) alone would rest for ever, as it does from a start with theta' = 0
//! (the very example of 6.1, since sgn 0 = 0). By default it is differentiated once more, `theta'' = -V'(theta) / (2 I)`, and
//! theta' is integrated from it behind the scenes: no sign to choose, no place to stick. With `algorithm = as_printed` theta'
//! is the root, and its sign changes at the event where V passes 2E.

use super::euler_angles::{angles, over_sine};
use super::gyroscope_card::{self, inertia, observe_at};
use crate::rotation::quotient;
use precess_scalar::Scalar;
use precess_system::{
    Card, Coordinate, Direction, Given, Layout, ObservableKind, State, System, Values, card, choice,
};

/// See the module.
#[derive(Clone)]
pub struct GyroscopeIntegrals;

/// Modes: the rates at the start, L + M, L - M, 2E, theta', the sign of theta'.
const MODES: usize = 8;
const HELD: usize = 3;
/// Where the sign stands in the full state, behind the three angles.
const SIGN: usize = 3 + MODES - 1;

/// Of `algorithm` and of `formula_21`.
const SMOOTH: usize = 0;
const CORRECTED: usize = 0;

/// What depends on theta alone.
struct Reduced<S> {
    /// H, the rate of precession.
    h: S,
    /// H sin theta, the angular velocity along b, and its derivative by theta.
    omega2: S,
    omega2_slope: S,
    /// H's derivative by theta.
    h_slope: S,
}

#[inline(always)]
fn reduced<S: Scalar>(s: &State<S>) -> Reduced<S> {
    let ([_psi, theta], [_, _, _, sum, difference]) = (s.q(), s.m());
    let [i_a1, ..] = inertia(s);
    let (sin, cos) = (theta * 0.5).sin_cos();
    // Where one of the two constants is zero the vertical is no barrier.
    let (up, down) = (quotient(sum * 0.25, cos * cos) / i_a1, quotient(difference * 0.25, sin * sin) / i_a1);
    Reduced {
        h: up + down,
        omega2: (up + down) * sin * cos * 2.0,
        omega2_slope: up - down,
        h_slope: over_sine(up * sin, cos) - over_sine(down * cos, sin),
    }
}

#[inline(always)]
fn omega3<S: Scalar>(s: &State<S>) -> S {
    let [_, _, _, sum, difference] = s.m();
    let [_, _, i3] = s.p();
    (sum - difference) * 0.5 / i3
}

/// `2E - V(theta)` and half of V's derivative, over I, with V as the choice has it.
#[inline(always)]
fn well<S: Scalar>(s: &State<S>) -> (S, S) {
    let ([_psi, theta], [m, _i1, i3, d, g], [i_a1, ..]) = (s.q(), s.p(), inertia(s));
    let (Reduced { h, omega2, omega2_slope, h_slope }, omega3) = (reduced(s), omega3(s));
    let [_, _, _, _, _, energy] = s.m();
    let (sin, cos) = theta.sin_cos();
    let weight = m * g * d / i_a1;
    let (rotation, slope) = if s.choice(1) == CORRECTED {
        (omega2 * omega2, omega2 * omega2_slope)
    } else {
        (h * h, h * h_slope)
    };
    let left = (energy - i3 * omega3 * omega3) / i_a1 - weight * cos * 2.0 - rotation;
    (left, slope - weight * sin)
}

/// theta', as the choice has it.
#[inline(always)]
fn theta_dot<S: Scalar>(s: &State<S>) -> S {
    let [.., smooth, sign] = s.m::<MODES>();
    if s.choice(0) == SMOOTH { smooth } else { sign * well(s).0.abs().sqrt() }
}

impl System for GyroscopeIntegrals {
    fn card(&self) -> Card {
        let card = card("gyroscope_integrals", "Gyroscope by its integrals", "Gyroscope par ses intégrales")
            .about(
                "The simple gyroscope once more: three constants of the motion leave one equation of the first order an \
                 angle, and theta rolls like a ball in a well. The printed algorithm sticks where theta turns.",
                "Encore le gyroscope simple : trois constantes du mouvement ne laissent qu'une équation du premier ordre par \
                 angle, et theta roule comme une bille dans un puits. L'algorithme imprimé se bloque là où theta rebrousse \
                 chemin.",
            )
            .source("T, section 6.4, equations 19 to 21");
        let card = angles(card, Coordinate::first_order)
            .modes(MODES)
            .held("psi_dot", "rad/s", 0.0, "rate of precession", "vitesse de précession")
            .held("theta_dot", "rad/s", 0.0, "rate of nutation", "vitesse de nutation")
            .held("phi_dot", "rad/s", 60.0, "rate of proper rotation", "vitesse de rotation propre");
        let card = gyroscope_card::body(card)
            .parameter(choice(
                "algorithm",
                &["smooth", "as_printed"],
                "how theta' finds its sign",
                "comment theta' trouve son signe",
            ))
            .parameter(choice(
                "formula_21",
                &["corrected", "as_printed"],
                "V with or without sin^2 theta in its last term",
                "V avec ou sans sin^2 theta dans son dernier terme",
            ));
        let mut card = gyroscope_card::observables(card, false);
        // Both angular momenta follow from the constants alone.
        card.observables[1].kind = ObservableKind::Signal;
        card.observables[2].kind = ObservableKind::Signal;
        card.path_view("axis_x", "axis_y")
            .time_view(&["theta"])
            .time_view(&["effective_potential", "energy"])
            .run(2.0, 1e-4)
    }

    /// The printed algorithm has an event; without it, and with the right V, the energy is kept.
    fn layout(&self, values: &Values<f64>, _given: &Given) -> Layout {
        let [algorithm, formula] = *values.choices.first_chunk().expect("the card's choices");
        let card = self.card();
        let mut layout = Layout::of(&if algorithm == SMOOTH {
            card
        } else {
            card.event(
                "turning",
                Direction::Falling,
                "V reaches 2E: the printed algorithm changes the sign of theta'",
                "V atteint 2E : l'algorithme imprimé change le signe de theta'",
            )
        });
        if [algorithm, formula] != [SMOOTH, CORRECTED] {
            layout.observables[0].kind = ObservableKind::Signal;
        }
        layout
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let [_psi, theta] = s.q();
        let Reduced { h, .. } = reduced(s);
        highest.copy_from_slice(&[h, theta_dot(s), omega3(s) - theta.cos() * h]);
    }

    #[inline(always)]
    fn mode_rates<S: Scalar>(&self, s: &State<S>, rates: &mut [S]) {
        rates.fill(S::from(0.0));
        if s.choice(0) == SMOOTH {
            rates[MODES - 2] = -well(s).1;
        }
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let [m, i1, i3, d, g] = s.p();
        let omega = [theta_dot(s), reduced(s).omega2, omega3(s)];
        observe_at(s, inertia(s), omega, [m, i1, i3, d, g], out);
    }

    #[inline(always)]
    fn crossings<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        if s.choice(0) != SMOOTH {
            out[0] = well(s).0;
        }
    }

    #[inline(always)]
    fn jump<S: Scalar>(&self, _event: usize, _s: &State<S>, y: &mut [S]) {
        y[SIGN] = -y[SIGN];
    }

    /// The constants from the rates at the start.
    fn start_modes(&self, s: &State<f64>, modes: &mut [f64]) {
        let ([_psi, theta], [m, _i1, i3, d, g], [i_a1, ..]) = (s.q(), s.p(), inertia(s));
        let [psi_dot, theta_dot, phi_dot] = *modes.first_chunk::<HELD>().expect("the rates at the start");
        // A sine below this is on the vertical: that of pi, rounded, is 1.2e-16.
        let on_the_vertical = |x: f64| if x.abs() < 1e-12 { 0.0 } else { x };
        let (sin, cos) = (on_the_vertical(Scalar::sin(theta)), Scalar::cos(theta));
        let (half_sin, half_cos) = Scalar::sin_cos(theta * 0.5);
        let (half_sin, half_cos) = (on_the_vertical(half_sin), on_the_vertical(half_cos));
        let spin = i3 * (psi_dot * cos + phi_dot);
        // On the vertical psi' has no share in the constants.
        let across = i_a1 * psi_dot * sin * sin;
        let omega2 = psi_dot * sin;
        modes[3] = across + 2.0 * spin * half_cos * half_cos;
        modes[4] = across - 2.0 * spin * half_sin * half_sin;
        modes[5] = i_a1 * (theta_dot * theta_dot + omega2 * omega2)
            + spin * (psi_dot * cos + phi_dot)
            + 2.0 * m * g * d * cos;
        modes[6] = theta_dot;
        modes[7] = if theta_dot == 0.0 { 0.0 } else { theta_dot.signum() };
    }

    fn check(&self, s: &State<f64>) -> Result<(), String> {
        let [_m, i1, i3] = s.p();
        super::possible_inertia([i1, i1, i3])
    }
}
