//! A pendulum hung from the rim of a wheel that turns steadily.
//!
//!     theta'' = -(g / l) sin theta - (wheel alpha^2 / l) sin(theta - alpha t - phase)
//!
//! (P, exercise 6.2.) The pivot is at wheel (cos(alpha t + phase), sin(alpha t + phase)), the first axis downwards, so that
//! the equation follows from x = wheel cos(...) + l cos theta, y = wheel sin(...) + l sin theta. P prints
//! + (R alpha^2 / L) cos(theta - alpha t), which is this equation with phase = pi/2, and draws the wheel with phase = 0:
//!   its picture and its equation differ by a quarter of a turn.

use precess_scalar::Scalar;
use precess_system::{Card, State, System, Values, card, coordinate, number};

/// See the module.
#[derive(Clone)]
pub struct WheelPendulum;

impl System for WheelPendulum {
    fn card(&self) -> Card {
        card("wheel_pendulum", "Pendulum on a wheel", "Pendule accroché à une roue")
            .about(
                "A pendulum whose pivot goes round on the rim of a wheel: it swings, turns over, and for many speeds does \
                 so without a rule.",
                "Un pendule dont le pivot est emporté par une roue : il se balance, fait des tours, et pour bien des \
                 vitesses sans règle aucune.",
            )
            .source("P, exercise 6.2, figure 17 (its printed equation: phase = pi/2)")
            .coordinate(coordinate("theta", "", "angle from the downward vertical", "angle avec la verticale descendante"))
            .parameter(number("wheel", "", 1.0, "radius of the wheel", "rayon de la roue").symbol("R"))
            .parameter(number("l", "", 1.0, "length of the pendulum", "longueur du pendule").positive())
            .parameter(number("alpha", "", 0.3, "angular velocity of the wheel", "vitesse angulaire de la roue"))
            .parameter(number("g", "", 0.098, "gravity", "pesanteur"))
            .parameter(number("phase", "", 0.0, "angle of the wheel at the start", "angle de la roue au départ").symbol("\\varphi"))
            .invariant_if("energy", "", &["alpha"], "energy per mass", "énergie par unité de masse")
            .invariant_if("turning_energy", "", &["g"], "energy per mass in the frame of the wheel", "énergie par unité de masse dans le repère de la roue")
            .signal("x_pivot", "", "pivot, to the right", "pivot, vers la droite")
            .signal("y_pivot", "", "pivot, upwards", "pivot, vers le haut")
            .signal("px", "", "mass, to the right", "masse, vers la droite")
            .signal("py", "", "mass, upwards", "masse, vers le haut")
            .path_view("px", "py")
            .time_view(&["theta"])
            .phase_view("theta", "theta_dot")
            .run(200.0, 0.0002)
    }

    fn period(&self, values: &Values<f64>) -> Option<f64> {
        Some(std::f64::consts::TAU / values.numbers[2].abs())
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([theta], [wheel, l, alpha, g]) = (s.q(), s.p());
        let from_wheel = theta - turned(s);
        highest[0] = -(g / l * theta.sin()) - wheel * alpha * alpha / l * from_wheel.sin();
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let ([theta], [w], [wheel, l, alpha]) = (s.q(), s.v(), s.p());
        let (kinetic, potential) = energies(s);
        let (sin, cos) = turned(s).sin_cos();
        let (right, down) = (wheel * sin, wheel * cos);
        let (sin, cos) = theta.sin_cos();
        let turning =
            (l * (w - alpha)).squared() * 0.5 - wheel * l * alpha * alpha * (theta - turned(s)).cos();
        out.copy_from_slice(&[kinetic + potential, turning, right, -down, right + l * sin, -down - l * cos]);
    }

    #[inline(always)]
    fn lagrangian<S: Scalar>(&self, s: &State<S>) -> Option<S> {
        let (kinetic, potential) = energies(s);
        Some(kinetic - potential)
    }
}

/// The wheel's angle.
#[inline(always)]
fn turned<S: Scalar>(s: &State<S>) -> S {
    let [_wheel, _l, alpha, _g, phase] = s.p();
    alpha * s.t + phase
}

#[inline(always)]
fn energies<S: Scalar>(s: &State<S>) -> (S, S) {
    let ([theta], [w], [wheel, l, alpha, g]) = (s.q(), s.v(), s.p());
    let (rim, arm) = (wheel * alpha, l * w);
    let kinetic = (rim.squared() + arm.squared()) * 0.5 + rim * arm * (theta - turned(s)).cos();
    (kinetic, -(g * (wheel * turned(s).cos() + l * theta.cos())))
}
