//! The heavy symmetric top in closed form (Lagrange): the inclination by Jacobi's functions, the other two angles by elliptic
//! integrals of the third kind.
//!
//! With `I = I_A1`, `beta = 2 m g d / I`, `a = i3 omega3 / I`, `b = L_Az / I` the cosine c of the inclination rolls in a cubic:
//!
//!     c'^2 = f(c) = (1 - c^2)(e - beta c) - (b - a c)^2 = beta (c - c1)(c - c2)(c - c3)     c1 <= c <= c2 <= 1 <= c3
//!     c = c1 + (c2 - c1) sn^2(U)      U = U0 + kappa t      kappa^2 = beta (c3 - c1) / 4      k^2 = (c2 - c1) / (c3 - c1)
//!     psi' = A / (1 + c) + B / (1 - c)      phi' = omega3 - a + A / (1 + c) - B / (1 - c)      A, B = (b +- a) / 2
//!
//! (E. T. Whittaker, Analytical Dynamics, sections 71 and 72.) The cubic is taken apart about the start, x = c - c0: its coefficients are
//! then rates of the start, the product x1 x2 is that of a square, and a top that hardly nods has two roots that hardly differ,
//! not two that are subtracted. A negative beta is the same top upside down.

use super::phase::Phase;
use crate::rotation::quotient;
use precess_scalar::Scalar;
use std::f64::consts::PI;

/// The start, by what is regular on the vertical.
pub(super) struct Start<S> {
    /// 1 + cos theta and 1 - cos theta.
    pub above: S,
    pub below: S,
    /// sin theta, of either sign.
    pub sin: S,
    /// theta', psi' sin theta, and the spin. On the vertical theta' tells where the axis leaves, and psi' sin theta is zero.
    pub omega: [S; 3],
    /// 2 m g d / I and i3 omega3 / I.
    pub beta: S,
    pub a: S,
}

/// What the motion has become.
pub(super) struct Now<S> {
    /// 1 + cos theta and 1 - cos theta.
    pub above: S,
    pub below: S,
    /// theta' and psi' sin theta, for a sine above zero.
    pub omega: [S; 2],
    /// By how much psi and phi have grown.
    pub psi: S,
    pub phi: S,
}

/// Newton's steps to the largest root, from above; they halve the distance even to a double one.
const STEPS: usize = 60;

/// The motion after a time.
#[inline(always)]
pub(super) fn lagrange<S: Scalar>(start: &Start<S>, time: S) -> Now<S> {
    let (zero, one) = (S::from(0.0), S::from(1.0));
    let [o1, o2, o3] = start.omega;
    // The right way up: u = +-c.
    let turned = start.beta.lt(zero);
    let side = S::select(turned, -one, one);
    let (beta, a, u) = (start.beta.abs(), start.a * side, (start.above - start.below) * 0.5 * side);
    let above = S::select(turned, start.below, start.above);
    let below = S::select(turned, start.above, start.below);
    let (square, momentum, speed) = (o1 * o1 + o2 * o2, o2 * start.sin, -(side * start.sin * o1));
    // f = speed^2 + f1 x + f2 x^2 + beta x^3.
    let f1 = (a * momentum - u * square) * 2.0 - beta * above * below;
    let f2 = beta * u * 2.0 - square - a * a;
    let speed2 = speed * speed;
    let mut x3 = S::from(2.0) - f2 / beta;
    for _ in 0..STEPS {
        let value = ((beta * x3 + f2) * x3 + f1) * x3 + speed2;
        let slope = (beta * x3 * 3.0 + f2 * 2.0) * x3 + f1;
        x3 = x3 - S::select(slope.le(zero), zero, value / slope);
    }
    let product = -(quotient(speed2, beta * x3));
    let sum = quotient(f1 / beta - product, x3);
    let span = (sum * sum - product * 4.0).sqrt();
    let far = (sum + S::select(sum.lt(zero), -span, span)) * 0.5;
    let near = S::select(far.abs().le(zero), zero, product / far);
    let x1 = S::select(sum.lt(zero), far, near);
    let x2 = S::select(sum.lt(zero), near, far);
    let wide = x3 - x1;

    let complement = S::select(wide.le(zero), one, (x3 - x2) / wide);
    let kappa = (beta * wide).sqrt() * 0.5;
    let (sn2, cn2) = (quotient(-x1, span), S::select(span.le(zero), one, x2 / span));
    let (sn, cn) = (sn2.sqrt(), cn2.sqrt());
    let dn = S::select(wide.le(zero), one, x3 / wide).sqrt();
    let before = Phase::start(S::select(speed.lt(zero), -sn, sn), cn, dn);
    let after = before.after(kappa * time, complement);

    // 1 + u and 1 - u at both turns, the small ones by f(-1) and f(1), which are squares; and now.
    let (plus, minus) = (momentum + a * above, momentum - a * below);
    let (top, high, beyond) = (above + x2, below - x1, x3 - below);
    let low = quotient(plus * plus, beta * top * (above + x3));
    let gap = below - x2;
    let gap = S::select(gap.lt(beyond), quotient(minus * minus, beta * high * beyond), gap);
    let [(was_above, was_below), (now_above, now_below)] =
        [&before, &after].map(|phase| (low + span * phase.sn.squared(), gap + span * phase.cn.squared()));
    // The integral of 1 / (1 +- u) from the start on: its values at the lower turn, the other turn, the start, and now.
    let integral = |[low, high, from, to]: [S; 4], span: S| {
        let whole = high / low;
        let grown = after.third(to / low, whole, complement) - before.third(from / low, whole, complement);
        quotient(time - span / low * grown / (kappa * 3.0), low)
    };
    let over_above = integral([low, top, was_above, now_above], span);
    let over_below = integral([high, gap, was_below, now_below], -span);
    let over_above_now = S::select(turned, over_below, over_above);
    let over_below_now = S::select(turned, over_above, over_below);
    // What multiplies them. Where it vanishes the vertical is no barrier: the axis passes through, and both angles jump.
    let (up, down) = ((momentum + start.a * start.above) * 0.5, (momentum - start.a * start.below) * 0.5);
    let through_low = S::select(low.le(zero), after.lower_turns() - before.lower_turns(), zero);
    let through_high = S::select(gap.le(zero), after.upper_turns() - before.upper_turns(), zero);
    let through_up = S::select(turned, through_high, through_low);
    let through_down = S::select(turned, through_low, through_high);
    let share =
        |factor: S, integral: S, times: S| S::select(factor.abs().le(zero), times * PI, factor * integral);
    let up_part = share(up, over_above_now, through_up);
    let down_part = share(down, over_below_now, through_down);

    let sin = (now_above * now_below).sqrt();
    let rate = span * kappa * after.sn * after.cn * after.dn * 2.0 * side;
    let (c_above, c_below) =
        (S::select(turned, now_below, now_above), S::select(turned, now_above, now_below));
    Now {
        above: c_above,
        below: c_below,
        omega: [-(quotient(rate, sin)), quotient(up * c_below + down * c_above, sin)],
        psi: up_part + down_part,
        phi: (o3 - start.a) * time + up_part - down_part,
    }
}
