//! Laws of friction: the force (and the moment about the normal) per unit of normal force.
//!
//!     coulomb_smooth   k = -mu u / sqrt(u^2 + epsilon^2)
//!     viscous          k = -mu u / speed
//!     drilling         k = -mu u / (w + 8/(3 pi) a |s|),   d = -(3 pi/16) mu a^2 s / (a |s| + (15 pi/16) w)
//!     coulomb          k = -mu u / |u|, and where u = 0 as much as sticking needs, up to mu
//!
//! with u the slip, s the spin about the normal, a the radius of a Hertzian contact spot and w = sqrt(u^2 + epsilon^2): the
//! two-term approximation of Contensou (1963) and Zhuravlev (1998), exact for small and for large s a / u.
//!
//! The exact law is not smooth where the slip passes through zero, so that is an event (`regimes.rs`). On the way there
//! a direction d, kept since the last event, tells which side of zero the slip is on: -mu u / (|u| sign(u.d)) goes
//! smoothly through zero, and a method keeps its order up to the event.

use precess_scalar::Scalar;
use std::f64::consts::PI;

/// The options of the parameter `friction`, in order.
pub(super) const LAWS: &[&str; 4] = &["coulomb_smooth", "viscous", "drilling", "coulomb"];
const VISCOUS: usize = 1;
const DRILLING: usize = 2;
pub(super) const COULOMB: usize = 3;

/// Parameters of the friction.
#[derive(Clone, Copy)]
pub(super) struct Friction<S> {
    pub law: usize,
    pub mu: S,
    pub epsilon: S,
    pub speed: S,
    pub spot: S,
}

/// Force in the table's plane, and moment about the normal, per unit of normal force.
pub(super) struct Grip<S> {
    pub k: [S; 2],
    pub drill: S,
}

impl<S: Scalar> Friction<S> {
    /// The grip at a slip and a spin about the normal, by the smooth laws.
    #[inline(always)]
    pub fn grip(&self, [ux, uy]: [S; 2], spin: S) -> Grip<S> {
        let zero = S::from(0.0);
        let square = ux * ux + uy * uy;
        let along = |part: S| Grip { k: [-(part * ux), -(part * uy)], drill: zero };
        match self.law {
            VISCOUS => along(self.mu / self.speed),
            DRILLING => {
                let (smooth, turning) =
                    ((square + self.epsilon * self.epsilon).sqrt(), self.spot * spin.abs());
                let drill = self.mu * self.spot * self.spot * spin * (3.0 * PI / 16.0);
                let drill = -(drill / (turning + smooth * (15.0 * PI / 16.0)));
                Grip { drill, ..along(self.mu / (smooth + turning * (8.0 / (3.0 * PI)))) }
            }
            _ => along(self.mu / (square + self.epsilon * self.epsilon).sqrt()),
        }
    }

    /// The exact law, on the side of zero that `d` tells; along `d` where nothing slips.
    #[inline(always)]
    pub fn dry(&self, [ux, uy]: [S; 2], [dx, dy]: [S; 2]) -> Grip<S> {
        let zero = S::from(0.0);
        let size = (ux * ux + uy * uy).sqrt();
        let still = size.le(zero);
        let size = S::select((ux * dx + uy * dy).lt(zero), -size, size);
        let [x, y] = [S::select(still, dx, ux / size), S::select(still, dy, uy / size)];
        Grip { k: [-(self.mu * x), -(self.mu * y)], drill: zero }
    }
}
