//! A waterwheel with infinitely many leaking buckets, under a stream that falls on its top.
//!
//! The water around the rim has the mass m(phi, t) per angle. All of it that matters to the wheel are its first
//! harmonics, m = ... + a sin phi + b cos phi (phi from the top), whose equations close:
//!
//!     theta'' = (pi g radius a - friction theta') / inertia
//!     a'      =  theta' b - leak a
//!     b'      = -theta' a - leak b + inflow
//!
//! (W. Malkus, L. Howard; S. Strogatz, *Nonlinear Dynamics and Chaos*, section 9.1.) With sigma = friction / (leak
//! inertia), rho = pi g radius inflow / (leak^2 friction) and time in units of 1 / leak these are Lorenz's equations
//! with beta = 1: theta' = leak x, a = (leak friction / (pi g radius)) y, b = inflow / leak - (the same) z. The defaults
//! are sigma = 10, rho = 28. P's `noria` has eight buckets that tip.

use precess_scalar::Scalar;
use precess_system::{Card, State, System, card, coordinate, number};
use std::f64::consts::PI;

/// See the module.
#[derive(Clone)]
pub struct MalkusWaterwheel;

impl System for MalkusWaterwheel {
    fn card(&self) -> Card {
        card("malkus_waterwheel", "Malkus's waterwheel", "Roue à eau de Malkus")
            .about(
                "Leaking buckets all around a wheel, filled at the top: it turns steadily under little water, and back and \
                 forth without a rule under much. It is Lorenz's attractor, made of water.",
                "Des godets percés tout autour d'une roue, remplis en haut : elle tourne régulièrement avec peu d'eau, et \
                 change de sens sans règle avec beaucoup. C'est l'attracteur de Lorenz, fait d'eau.",
            )
            .source("S. Strogatz, Nonlinear Dynamics and Chaos, section 9.1; beyond P, exercise 8")
            .coordinate(coordinate("theta", "rad", "angle of the wheel", "angle de la roue").start_dot(0.1))
            .coordinate(coordinate("a", "kg", "water to one side: sine harmonic", "eau d'un côté : harmonique en sinus").first_order())
            .coordinate(coordinate("b", "kg", "water at the top: cosine harmonic", "eau en haut : harmonique en cosinus").first_order())
            .parameter(number("inertia", "kg m^2", 1.0, "moment of inertia, water included", "moment d'inertie, eau comprise").positive().symbol("I"))
            .parameter(number("friction", "kg m^2/s", 10.0, "friction of the axle", "frottement de l'axe").symbol("\\nu"))
            .parameter(number("radius", "m", 1.0, "radius of the wheel", "rayon de la roue").positive().symbol("r"))
            .parameter(number("g", "m/s^2", 9.81, "gravity", "pesanteur"))
            .parameter(number("leak", "1/s", 1.0, "share of the water that leaks per time", "part de l'eau qui fuit par unité de temps").symbol("K"))
            .parameter(number("inflow", "kg/s", 280.0 / (PI * 9.81), "first harmonic of the inflow", "première harmonique du débit").symbol("q_1"))
            .signal("torque", "N m", "torque of the water", "moment de l'eau")
            .time_view(&["theta_dot"])
            .phase_view("a", "b")
            .run(60.0, 0.001)
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([_theta, a, b], [w], [inertia, friction, _, _, leak, inflow]) = (s.q(), s.v(), s.p());
        highest.copy_from_slice(&[
            (torque(s) - friction * w) / inertia,
            w * b - leak * a,
            inflow - w * a - leak * b,
        ]);
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        out[0] = torque(s);
    }
}

#[inline(always)]
fn torque<S: Scalar>(s: &State<S>) -> S {
    let ([_theta, a], [_inertia, _friction, radius, g]) = (s.q(), s.p());
    g * radius * a * PI
}
