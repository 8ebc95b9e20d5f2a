//! Two equal pendulums, coupled by a spring.
//!
//!     theta1'' = -(g / l) sin theta1 - k (theta1 - theta2)
//!     theta2'' = -(g / l) sin theta2 + k (theta1 - theta2)
//!
//! The spring twists with the difference of the angles; k is its stiffness over m l^2. Small swings have two normal
//! modes, of the angular frequencies sqrt(g / l) and sqrt(g / l + 2 k): started alone, one pendulum hands its swing to
//! the other and takes it back at the difference of the two.

use precess_scalar::Scalar;
use precess_system::{Card, State, System, card, coordinate, number};

/// See the module.
#[derive(Clone)]
pub struct CoupledPendulums;

impl System for CoupledPendulums {
    fn card(&self) -> Card {
        card("coupled_pendulums", "Coupled pendulums", "Pendules couplés")
            .about(
                "Two pendulums joined by a weak spring hand their swing to one another and back: beats.",
                "Deux pendules joints par un ressort faible se passent leur oscillation et la reprennent : des battements.",
            )
            .source("A. Sommerfeld, Mechanics, section 20")
            .coordinate(coordinate("theta1", "rad", "angle of the first pendulum", "angle du premier pendule").start(0.3))
            .coordinate(coordinate("theta2", "rad", "angle of the second pendulum", "angle du deuxième pendule"))
            .parameter(number("l", "m", 1.0, "length", "longueur").positive())
            .parameter(number("g", "m/s^2", 9.81, "gravity", "pesanteur"))
            .parameter(number("k", "1/s^2", 0.5, "stiffness of the coupling", "raideur du couplage"))
            .invariant("energy", "1/s^2", "energy, over m l^2", "énergie, sur m l^2")
            .signal("energy1", "1/s^2", "energy of the first, over m l^2", "énergie du premier, sur m l^2")
            .signal("energy2", "1/s^2", "energy of the second, over m l^2", "énergie du deuxième, sur m l^2")
            .time_view(&["theta1", "theta2"])
            .time_view(&["energy1", "energy2"])
            .phase_view("theta1", "theta2")
            .run(60.0, 0.001)
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([theta1, theta2], [l, g, k]) = (s.q(), s.p());
        let twist = k * (theta1 - theta2);
        highest.copy_from_slice(&[-(g / l * theta1.sin()) - twist, twist - g / l * theta2.sin()]);
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let [w1, w2] = s.v();
        let ([fall1, fall2], spring) = potentials(s);
        let (first, second) = (w1.squared() * 0.5 + fall1, w2.squared() * 0.5 + fall2);
        out.copy_from_slice(&[first + second + spring, first, second]);
    }

    #[inline(always)]
    fn lagrangian<S: Scalar>(&self, s: &State<S>) -> Option<S> {
        let [w1, w2] = s.v();
        let ([fall1, fall2], spring) = potentials(s);
        Some((w1.squared() + w2.squared()) * 0.5 - fall1 - fall2 - spring)
    }
}

/// Of the two weights, from the bottom, and of the spring.
#[inline(always)]
fn potentials<S: Scalar>(s: &State<S>) -> ([S; 2], S) {
    let ([theta1, theta2], [l, g, k]) = (s.q(), s.p());
    let fall = |theta: S| g / l * (S::from(1.0) - theta.cos());
    ([fall(theta1), fall(theta2)], k * (theta1 - theta2).squared() * 0.5)
}
