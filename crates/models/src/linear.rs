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
    let nodes = roots(p, q).map(|node| node.scaled(time));
    let [a, b] = powers(nodes);
    let kick = over_two(nodes, [a, b]).re * time;
    let mean = (a.re + b.re) * 0.5;
    let half = p * 0.5 * kick;
    [x * (mean + half) + v * kick, v * (mean - half) - q * x * kick]
}

/// x and x' after a time from x and x', under a force that starts as Im(force).
#[inline(always)]
pub(crate) fn driven<S: Scalar>(
    [p, q]: [S; 2],
    time: S,
    [x, v]: [S; 2],
    force: Complex<S>,
    frequency: S,
) -> [S; 2] {
    let [a, b] = roots(p, q);
    let nodes = [a, b, Complex::imaginary(frequency)].map(|node| node.scaled(time));
    let exps = powers(nodes);
    // The pairs (a, b), (b, c), (c, a).
    let mut pairs = [Complex::real(S::from(0.0)); 3];
    for (k, pair) in pairs.iter_mut().enumerate() {
        let next = (k + 1) % 3;
        *pair = over_two([nodes[k], nodes[next]], [exps[k], exps[next]]);
    }
    let kick = pairs[0].scaled(time);
    let place = over_three(nodes, pairs).scaled(time * time);
    let speed = kick.plus(place.times(Complex::imaginary(frequency)));
    let mean = (exps[0].re + exps[1].re) * 0.5;
    let half = p * 0.5 * kick.re;
    [
        x * (mean + half) + v * kick.re + force.times(place).im,
        v * (mean - half) - q * x * kick.re + force.times(speed).im,
    ]
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

/// e^z for each; in a loop, which stays one piece of code.
#[inline(always)]
fn powers<S: Scalar, const N: usize>(nodes: [Complex<S>; N]) -> [Complex<S>; N] {
    let mut exps = nodes;
    for exp in &mut exps {
        *exp = exp.exp();
    }
    exps
}

/// The divided difference of e^z over two nodes, from its values there: (e^a - e^b) / (a - b), and e^a where they meet.
#[inline(always)]
fn over_two<S: Scalar>([a, b]: [Complex<S>; 2], exps: [Complex<S>; 2]) -> Complex<S> {
    let half = S::from(0.5);
    let apart = a.minus(b).scaled(half);
    let close = a.plus(b).scaled(half).exp().times(sinh_over(apart));
    let far = exps[0].minus(exps[1]).over(a.minus(b));
    Complex::select(apart.re.abs().lt(S::from(1.0)), close, far)
}

/// sinh(z) / z, where the real part of z lies between -1 and 1.
#[inline(always)]
fn sinh_over<S: Scalar>(z: Complex<S>) -> Complex<S> {
    const TERMS: u32 = 14;
    let one = S::from(1.0);
    let square = z.re * z.re;
    let (mut sinh, mut cosh) = (one, one);
    for k in (1..=TERMS).rev() {
        let n = f64::from(2 * k);
        sinh = one + square * sinh / (n * (n + 1.0));
        cosh = one + square * cosh / (n * (n - 1.0));
    }
    let (sin, cos) = z.im.sin_cos();
    let sinh = Complex::new(z.re * sinh * cos, cosh * sin);
    let tiny = (z.re.abs() + z.im.abs()).lt(S::from(1e-20));
    Complex::select(tiny, Complex::real(one), sinh.over(z))
}

/// The divided difference of e^z over three nodes, from those of the pairs (a, b), (b, c), (c, a): by the two nodes that
/// are farther apart, or, where all are close, by its series.
#[inline(always)]
fn over_three<S: Scalar>(nodes: [Complex<S>; 3], [ab, bc, ca]: [Complex<S>; 3]) -> Complex<S> {
    let [a, b, c] = nodes;
    let (by_roots, by_drive) = (a.minus(b), a.minus(c));
    let roots_apart = by_drive.square().lt(by_roots.square());
    let far = Complex::select(roots_apart, ca.minus(bc).over(by_roots), ab.minus(bc).over(by_drive));
    let spread = by_roots.square() + by_drive.square();
    Complex::select(spread.lt(S::from(0.01)), series(nodes), far)
}

/// e^m (h_0 / 2! + h_1 / 3! + h_2 / 4! + ...), with m the mean of the nodes and h_k the complete symmetric polynomials of
/// their distances from it: h_k = -e_2 h_(k-2) + e_3 h_(k-3).
#[inline(always)]
fn series<S: Scalar>(nodes: [Complex<S>; 3]) -> Complex<S> {
    const TERMS: u32 = 9;
    let third = S::from(1.0) / 3.0;
    let centre = nodes[0].plus(nodes[1]).plus(nodes[2]).scaled(third);
    let [a, b, c] = nodes.map(|node| node.minus(centre));
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
    centre.exp().times(sum)
}
