//! Two point masses on two massless rods, one hung from the other, in a vertical plane.
//!
//! With d = theta1 - theta2 the Lagrange equations are linear in the accelerations:
//!
//!     (m1 + m2) l1 a1 + m2 l2 cos d a2 = -m2 l2 theta2'^2 sin d - (m1 + m2) g sin theta1   (= f1)
//!               l1 cos d a1 +    l2 a2 =     l1 theta1'^2 sin d -             g sin theta2   (= f2)
//!
//! and are solved with the determinant l1 l2 (m1 + m2 sin^2 d), which never vanishes. Chaotic at large energies.
//! (Landau, Lifshitz, *Mechanics*, section 5, problem 1.)

use precess_scalar::Scalar;
use precess_system::{Card, State, System, card, coordinate, number};

/// See the module.
#[derive(Clone)]
pub struct DoublePendulum;

impl System for DoublePendulum {
    fn card(&self) -> Card {
        card("double_pendulum", "Double pendulum", "Pendule double")
            .about(
                "A pendulum hung from a pendulum. At large energies it is chaotic: two starts that differ by a hair part \
                 within seconds.",
                "Un pendule accroché à un pendule. À grande énergie il est chaotique : deux départs presque identiques \
                 se séparent en quelques secondes.",
            )
            .source("Landau and Lifshitz, Mechanics, section 5, problem 1")
            .coordinate(
                coordinate("theta1", "rad", "angle of the upper rod from the vertical", "angle de la tige du haut avec la verticale")
                    .start(2.0),
            )
            .coordinate(
                coordinate("theta2", "rad", "angle of the lower rod from the vertical", "angle de la tige du bas avec la verticale")
                    .start(2.0),
            )
            .parameter(number("m1", "kg", 1.0, "upper mass", "masse du haut").positive())
            .parameter(number("m2", "kg", 1.0, "lower mass", "masse du bas").positive())
            .parameter(number("l1", "m", 1.0, "length of the upper rod", "longueur de la tige du haut").positive())
            .parameter(number("l2", "m", 1.0, "length of the lower rod", "longueur de la tige du bas").positive())
            .parameter(number("g", "m/s^2", 9.81, "gravity", "pesanteur"))
            .invariant("energy", "J", "total energy", "énergie totale")
            .signal("x1", "m", "upper mass, horizontally", "masse du haut, horizontalement")
            .signal("y1", "m", "upper mass, upwards from the pivot", "masse du haut, vers le haut depuis le pivot")
            .signal("x2", "m", "lower mass, horizontally", "masse du bas, horizontalement")
            .signal("y2", "m", "lower mass, upwards from the pivot", "masse du bas, vers le haut depuis le pivot")
            .path_view("x2", "y2")
            .time_view(&["theta1", "theta2"])
            .run(20.0, 0.001)
    }

    #[inline(always)]
    fn equations<S: Scalar>(&self, s: &State<S>, highest: &mut [S]) {
        let ([theta1, theta2], [w1, w2], [m1, m2, l1, l2, g]) = (s.q(), s.v(), s.p());
        let (sin, cos) = (theta1 - theta2).sin_cos();
        let both = m1 + m2;
        let f1 = -(m2 * l2 * w2 * w2 * sin) - both * g * theta1.sin();
        let f2 = l1 * w1 * w1 * sin - g * theta2.sin();
        let effective = m1 + m2 * sin * sin;
        highest[0] = (f1 - m2 * cos * f2) / (l1 * effective);
        highest[1] = (both * f2 - cos * f1) / (l2 * effective);
    }

    #[inline(always)]
    fn observe<S: Scalar>(&self, s: &State<S>, out: &mut [S]) {
        let ([theta1, theta2], [_, _, l1, l2]) = (s.q(), s.p());
        let (kinetic, potential) = energies(s);
        let (sin1, cos1) = theta1.sin_cos();
        let (sin2, cos2) = theta2.sin_cos();
        let (x1, y1) = (l1 * sin1, -(l1 * cos1));
        out.copy_from_slice(&[kinetic + potential, x1, y1, x1 + l2 * sin2, y1 - l2 * cos2]);
    }

    #[inline(always)]
    fn lagrangian<S: Scalar>(&self, s: &State<S>) -> Option<S> {
        let (kinetic, potential) = energies(s);
        Some(kinetic - potential)
    }
}

#[inline(always)]
fn energies<S: Scalar>(s: &State<S>) -> (S, S) {
    let ([theta1, theta2], [w1, w2], [m1, m2, l1, l2, g]) = (s.q(), s.v(), s.p());
    let (v1, v2) = (l1 * w1, l2 * w2);
    let kinetic = ((m1 + m2) * v1 * v1 + m2 * v2 * v2) * 0.5 + m2 * v1 * v2 * (theta1 - theta2).cos();
    let potential = -((m1 + m2) * g * l1 * theta1.cos()) - m2 * g * l2 * theta2.cos();
    (kinetic, potential)
}
