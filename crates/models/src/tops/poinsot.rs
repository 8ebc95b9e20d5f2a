//! The free body in closed form (Jacobi): its angular velocity by elliptic functions, its attitude by one elliptic integral of the
//! third kind.
//!
//! Let c be the axis that the polhode goes around (of the largest moment if `L^2 > 2 E I_middle`, else of the smallest), a the other
//! outer one, b the middle one. `2 E Ic - L^2` leaves an angle xi for what lies across c, which turns like an amplitude:
//!
//!     omega_a = sqrt(W / (Ia |Ic - Ia|)) cos xi      omega_b = +-sqrt(W / (Ib |Ic - Ib|)) sin xi      W = |2 E Ic - L^2|
//!     xi = am(U)      omega_c = omega_m dn(U)      U' = +-nu omega_m      nu^2 = (Ic - Ia)(Ic - Ib) / (Ia Ib)
//!
//! About L, which rests in space, c has the Euler angles psi, theta, phi with cos theta = `Lc / L`, `tan phi = Lx / Ly`, and
//!
//!     psi' = L / Ic + L (1/Ia - 1/Ic) / (1 + s sn^2)      s = Ic |Ia - Ib| / (Ia |Ic - Ib|)
//!
//! (L. Landau and E. Lifshitz, Mechanics, paragraph 37; E. T. Whittaker, Analytical Dynamics, section 69.) `L^2 - 2 E Ia` is a sum of
//! positive terms; the other differences are products of differences of the moments.

use super::phase::Phase;
use crate::rotation::{Quaternion, Vector, cross, dot, from_euler, product, quotient};
use precess_scalar::Scalar;

/// Attitude and angular velocity (body axes) after a time.
#[inline(always)]
pub(super) fn poinsot<S: Scalar>(
    inertia: Vector<S>,
    attitude: Quaternion<S>,
    omega: Vector<S>,
    time: S,
) -> (Quaternion<S>, Vector<S>) {
    let (zero, one) = (S::from(0.0), S::from(1.0));
    let momentum: Vector<S> = std::array::from_fn(|i| inertia[i] * omega[i]);
    let turning = cross(omega, momentum);
    // About a principal axis, or any axis of a ball.
    let ball = inertia[0]
        .larger(inertia[1])
        .larger(inertia[2])
        .le(inertia[0].smaller(inertia[1]).smaller(inertia[2]));
    let steady = dot(turning, turning).le(zero) | ball;

    let axis = around(inertia, omega);
    let [ix, iy, ic] = axis.third(inertia);
    let [wx, wy, wc] = axis.third(omega);
    let (cx, cy) = ((ic - ix).abs(), (ic - iy).abs());
    // a is x where y is the middle one, which is nearer to c.
    let first = cy.le(cx);
    let pick = |x: S, y: S| [S::select(first, x, y), S::select(first, y, x)];
    let ([ia, ib], [ca, cb], [wa, wb]) = (pick(ix, iy), pick(cx, cy), pick(wx, wy));
    let between = (ia - ib).abs();
    let from_a = ic * wc * wc * ca + ib * wb * wb * between;
    let from_b = ic * wc * wc * cb - ia * wa * wa * between;
    let complement = quotient(from_b.larger(zero) * ca, from_a * cb);
    let fastest = quotient(from_a, ic * ca).sqrt() * S::select(wc.lt(zero), -one, one);
    let side = S::select((ic - ib).lt(zero), -one, one);
    let kappa = side * fastest * (cx * cy / (ix * iy)).sqrt();

    // The angle across c from a to b; where y is a it runs the other way, since (x, y, c) is right-handed.
    let (root_a, root_b) = ((ia * ca).sqrt(), (ib * cb).sqrt());
    let across = (ia * ca * wa * wa + ib * cb * wb * wb).sqrt();
    let hand = S::select(first, one, -one);
    let (cos, sin) = (quotient(root_a * wa, across), quotient(root_b * wb * hand, across));
    let half = S::select(cos.lt(zero), -one, one);
    let dn = quotient(wc, fastest.abs()).abs();
    let before = Phase::start(sin * half, cos * half, dn);
    let after = before.after(kappa * time, complement);
    let now_a = across * after.cn * half / root_a;
    let now_b = across * after.sn * half * hand / root_b;
    let [now_x, now_y] = pick(now_a, now_b);
    let now = [now_x, now_y, fastest * after.dn];

    let s = ic * between / (ia * cb);
    let size = dot(momentum, momentum).sqrt();
    let third = |phase: &Phase<S>| phase.third(s * phase.sn.squared() + one, s + one, complement);
    let grown = (third(&after) - third(&before)) / 3.0;
    let psi = size / ic * time + size * (one / ia - one / ic) * (time - s * grown / kappa);
    // By how much the direction of L across c is ahead of xi.
    let ahead = |phase: &Phase<S>| {
        let (ga, gb) = ((ia / ca).sqrt(), (ib / cb).sqrt());
        let (sn, cn) = (phase.sn, phase.cn);
        ((gb - ga) * sn * cn).atan2(ga * cn * cn + gb * sn * sn)
    };
    let turned = after.amplitude() + ahead(&after) - before.amplitude() - ahead(&before);
    let start = [ix * wx, iy * wy, ic * wc];
    let end = [ix * now[0], iy * now[1], ic * now[2]];
    let tilt = |[x, y, c]: Vector<S>| x.hypot(y).atan2(c);
    let phi = start[0].atan2(start[1]);
    let from = from_euler([zero, tilt(start), phi]);
    let to = from_euler([psi, tilt(end), phi - turned]);
    let [w, x, y, z] = product([from[0], -from[1], -from[2], -from[3]], to);
    let [x, y, z] = axis.back([x, y, z]);

    let speed = dot(omega, omega).sqrt();
    let (sin, cos) = (speed * time * 0.5).sin_cos();
    let spin = omega.map(|part| quotient(part, speed) * sin);
    let spin = [cos, spin[0], spin[1], spin[2]];
    let turn: Quaternion<S> = std::array::from_fn(|i| S::select(steady, spin[i], [w, x, y, z][i]));
    let now = axis.back(now);
    (product(attitude, turn), std::array::from_fn(|i| S::select(steady, omega[i], now[i])))
}

/// The axis that the polhode goes around: masks for 1 and 2, else 3.
struct Around<M> {
    one: M,
    two: M,
}

#[inline(always)]
fn around<S: Scalar>([i1, i2, i3]: Vector<S>, [o1, o2, o3]: Vector<S>) -> Around<S::Mask> {
    let largest = i1.larger(i2).larger(i3);
    let smallest = i1.smaller(i2).smaller(i3);
    let middle = i1.smaller(i2).larger(i1.larger(i2).smaller(i3));
    let excess = i1 * o1 * o1 * (i1 - middle) + i2 * o2 * o2 * (i2 - middle) + i3 * o3 * o3 * (i3 - middle);
    let moment = S::select(S::from(0.0).lt(excess), largest, smallest);
    let is = |i: S| i.le(moment) & moment.le(i);
    Around { one: is(i1), two: is(i2) & !is(i1) }
}

impl<M: Copy> Around<M> {
    /// The components in the right-handed axes whose third this is.
    #[inline(always)]
    fn third<S: Scalar<Mask = M>>(&self, [a, b, c]: Vector<S>) -> Vector<S> {
        let pick = |one: S, two: S, three: S| S::select(self.one, one, S::select(self.two, two, three));
        [pick(b, c, a), pick(c, a, b), pick(a, b, c)]
    }
    /// And back.
    #[inline(always)]
    fn back<S: Scalar<Mask = M>>(&self, [x, y, z]: Vector<S>) -> Vector<S> {
        let pick = |one: S, two: S, three: S| S::select(self.one, one, S::select(self.two, two, three));
        [pick(z, y, x), pick(x, z, y), pick(y, x, z)]
    }
}
