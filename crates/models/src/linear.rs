//! Linear oscillators in closed form, free and driven.
//!
//!     x'' + p x' + q x = Im(force e^(i f t))
//!
//! With the roots a, b of z^2 + p z + q and c = i f, the kick from rest moves it by the divided difference of e^(z t)
//! over a and b, and the force from rest by the one over a, b and c (their Laplace transforms are 1 / ((z - a)(z - b))
//! and 1 / ((z - a)(z - b)(z - c))). Written so, critical damping (a = b) and resonance (a = c) are no cases of their own:
//! only the way to compute a divided difference without loss changes where its nodes are close.

use crate::complex::Complex;
use precess_scalar::Scalar;

/// x and x' after a time, from x and x', without a force.
#[inline(always)]
pub(crate) fn free<S: Scalar>([p, q]: [S; 2], time: S, [x, v]: [S; 2]) -> [S; 2] {
    let [a, b] = roots(p, q);
    let kick = over_two(a, b, time).re;
    let mean = (a.scaled(time).exp().re + b.scaled(time).exp().re) * 0.5;
    let half = p * 0.5 * kick;
    [x * (mean + half) + v * kick, v * (mean - half) - q * x * kick]
}

/// x and x' after a time from rest, under a force that starts as Im(force).
#[inline(always)]
pub(crate) fn driven<S: Scalar>([p, q]: [S; 2], time: S, force: Complex<S>, frequency: S) -> [S; 2] {
    let [a, b] = roots(p, q);
    let c = Complex::imaginary(frequency);
    let place = over_three([a, b, c], time);
    let speed = over_two(a, b, time).plus(c.times(place));
    [force.times(place).im, force.times(speed).im]
}

/// The roots of z^2 + p z + q.
#[inline(always)]
fn roots<S: Scalar>(p: S, q: S) -> [Complex<S>; 2] {
    let (zero, centre) = (S::from(0.0), -(p * 0.5));
    let discriminant = centre * centre - q;
    let real = zero.lt(discriminant);
    let half = discriminant.abs().sqrt();
    // The larger root first: the other one, as their difference, would lose its digits.
    let large = S::select(p.lt(zero), centre + half, centre - half);
    let a = Complex::new(centre, half);
    let b = Complex::new(centre, -half);
    [Complex::select(real, Complex::real(large), a), Complex::select(real, Complex::real(q / large), b)]
}

/// The divided difference of e^(z t) over a and b: (e^(a t) - e^(b t)) / (a - b), and t e^(a t) where they meet.
#[inline(always)]
fn over_two<S: Scalar>(a: Complex<S>, b: Complex<S>, time: S) -> Complex<S> {
    let half = time * 0.5;
    let (centre, apart) = (a.plus(b).scaled(half), a.minus(b).scaled(half));
    let close = centre.exp().times(sinh_over(apart)).scaled(time);
    let far = a.scaled(time).exp().minus(b.scaled(time).exp()).over(a.minus(b));
    Complex::select(apart.re.abs().lt(S::from(1.0)), close, far)
}

/// sinh(z) / z.
#[inline(always)]
fn sinh_over<S: Scalar>(z: Complex<S>) -> Complex<S> {
    let (sin, cos) = z.im.sin_cos();
    let sinh = Complex::new(z.re.sinh() * cos, z.re.cosh() * sin);
    let tiny = (z.re.abs() + z.im.abs()).lt(S::from(1e-20));
    Complex::select(tiny, Complex::real(S::from(1.0)), sinh.over(z))
}

/// The divided difference of e^(z t) over three nodes: by the two that are farthest apart, or, where all are close, by
/// its series.
#[inline(always)]
fn over_three<S: Scalar>([a, b, c]: [Complex<S>; 3], time: S) -> Complex<S> {
    let (by_roots, by_drive) = (a.minus(b), a.minus(c));
    let [ab, ac, bc] = [over_two(a, b, time), over_two(a, c, time), over_two(b, c, time)];
    let roots_apart = by_drive.square().lt(by_roots.square());
    let far = Complex::select(roots_apart, ac.minus(bc).over(by_roots), ab.minus(bc).over(by_drive));
    let spread = (by_roots.square() + by_drive.square()) * time * time;
    Complex::select(spread.lt(S::from(0.01)), series([a, b, c], time), far)
}

/// e^(m t) t^2 (h_0 / 2! + h_1 / 3! + h_2 / 4! + ...), with m the mean of the nodes and h_k the complete symmetric
/// polynomials of their distances from it, in 1/t: h_k = -e_2 h_(k-2) + e_3 h_(k-3).
#[inline(always)]
fn series<S: Scalar>(nodes: [Complex<S>; 3], time: S) -> Complex<S> {
    const TERMS: u32 = 9;
    let third = S::from(1.0) / 3.0;
    let centre = nodes[0].plus(nodes[1]).plus(nodes[2]).scaled(third);
    let [a, b, c] = nodes.map(|node| node.minus(centre).scaled(time));
    let e2 = a.times(b).plus(b.times(c)).plus(c.times(a));
    let e3 = a.times(b).times(c);
    let zero = Complex::real(S::from(0.0));
    let mut h = [zero, zero, Complex::real(S::from(1.0))];
    let (mut sum, mut factorial) = (zero, 2.0);
    for k in 0..TERMS {
        sum = sum.plus(h[2].scaled(S::from(1.0 / factorial)));
        factorial *= f64::from(k + 3);
        h = [h[1], h[2], e3.times(h[0]).minus(e2.times(h[1]))];
    }
    centre.scaled(time).exp().times(sum).scaled(time * time)
}
