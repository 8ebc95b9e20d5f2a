//! A car on its springs, driven over a corrugated road at constant speed.
//!
//!     m x'' = -k (x - f) - b (x' - f'),      f(t) = amplitude sin(2 pi speed t / wavelength)
//!
//! (P, exercise 6.3.) x is the height of the car and f that of the road under its wheel, both from their means. With
//! p = b / m and q = k / m it is the `driven_oscillator` under (k f + b f') / m.

use crate::complex::Complex;
use crate::linear;
use precess_scalar::Scalar;
use precess_system::{Card, State, System, Values, card, coordinate, number};
use std::f64::consts::TAU;

/// See the module.
#[derive(Clone)]
pub struct CarSuspension;

impl System for CarSuspension {
    fn card(&self) -> Card {
        card("car_suspension", "Car on a corrugated road", "Voiture sur une tôle ondulée")
            .about(
                "A car on springs rolls over waves of the road. Slowly it follows them, at the resonance it leaps, fast it \
                 glides above them.",
                "Une voiture sur ressorts roule sur une tôle ondulée. Lentement elle suit les ondes, à la résonance elle \
                 bondit, vite elle les survole.",
            )
            .source("P, exercise 6.3, figure 18")
            .coordinate(coordinate("x", "m", "height of the car", "hauteur de la voiture"))
            .parameter(number("m", "kg", 1.0, "mass", "masse").positive())
            .parameter(number("k", "N/m", 1.0, "stiffness", "raideur"))
            .parameter(number("b", "kg/s", 0.1, "friction of the dampers", "frottement des amortisseurs"))
            .parameter(number("amplitude", "m", 0.1, "height of the waves", "hauteur des ondes").symbol("A"))
            .parameter(number("wavelength", "m", 1.0, "length of the waves", "longueur d'onde").positive().symbol("\\lambda"))
            .parameter(number("speed", "m/s", 1.0, "speed of the car", "vitesse de la voiture").symbol("c"))
            .invariant_if("energy", "J", &["b", "amplitude"], "energy", "énergie")
            .signal("road", "m", "height of the road", "hauteur de la route")
            .signal("travel", "m", "extension of the springs", "allongement des ressorts")
            .signal("force", "N", "force on the car", "force sur la voiture")
            .time_view(&["x", "road"])
            .phase_view("x", "x_dot")
            .run(60.0, 0.001)
    }

    fn period(&self, values: &Values<f64>) -> Option<f64> {
        Some((values.numbers[4] / values.numbers[5]).abs())
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let [m] = s.p();
        highest[0] = force(s) / m;
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let ([x], [v], [m, k]) = (s.q(), s.v(), s.p());
        let (road, _) = road(s);
        let energy = (m * v.squared() + k * x.squared()) * 0.5;
        out.copy_from_slice(&[energy, road, x - road, force(s)]);
    }

    fn solvable(&self, _start: &State<f64>) -> Result<(), String> {
        Ok(())
    }

    #[inline(always)]
    fn solution<S: Scalar>(&self, start: &State<S>, t: S, q: &mut [S], v: &mut [S]) {
        let ([x], [x_dot], [m, k, b, amplitude]) = (start.q(), start.v(), start.p());
        let (time, frequency) = (t - start.t, frequency(start));
        // k f + b f' is the imaginary part of (k + i b frequency) amplitude e^(i frequency t).
        let force = Complex::new(k / m, b / m * frequency).scaled(amplitude);
        let force = force.times(Complex::imaginary(frequency * start.t).exp());
        [q[0], v[0]] = linear::driven([b / m, k / m], time, [x, x_dot], force, frequency);
    }

    #[inline(always)]
    fn lagrangian<S: Scalar>(&self, s: &State<S>) -> Option<S> {
        let ([x], [v], [m, k, b]) = (s.q(), s.v(), s.p());
        let (road, rise) = road(s);
        let still = (m * v.squared() - k * x.squared()) * 0.5;
        Some((b / m * s.t).exp() * (still + (k * road + b * rise) * x))
    }
}

/// How often the waves come, as an angular frequency.
#[inline(always)]
fn frequency<S: Scalar>(s: &State<S>) -> S {
    let [_m, _k, _b, _amplitude, wavelength, speed] = s.p();
    speed / wavelength * TAU
}

/// Height of the road, and how fast it rises.
#[inline(always)]
fn road<S: Scalar>(s: &State<S>) -> (S, S) {
    let ([_m, _k, _b, amplitude], frequency) = (s.p(), frequency(s));
    let (sin, cos) = (frequency * s.t).sin_cos();
    (amplitude * sin, amplitude * frequency * cos)
}

/// What the springs and dampers do.
#[inline(always)]
fn force<S: Scalar>(s: &State<S>) -> S {
    let ([x], [v], [_m, k, b]) = (s.q(), s.v(), s.p());
    let (road, rise) = road(s);
    -(k * (x - road)) - b * (v - rise)
}
