//! Jacobi's elliptic functions, by the arithmetic-geometric mean.
//!
//! With a = 1, b = k' and both means taken again and again, a and b meet in pi / (2 K), and each step back from there is
//! Gauss's transformation. It is written for the ratio of cn to sn, as in Bulirsch's algorithm (Numer. Math. 7, 78, 1965):
//!
//! ```text
//! c = a cn / sn:    c_(n-1) = c_n dn_n,     dn_(n-1) = (b_(n-1) + c_n^2 / a_n) / (a_(n-1) + c_n^2 / a_n)
//! ```
//!
//! Nothing is subtracted, so cn and dn keep all their digits where they vanish, also when k is nearly 1.

use crate::Scalar;

/// The three functions at a point.
#[derive(Clone, Copy, Debug)]
pub struct Jacobi<S> {
    /// sn, the sine of the amplitude.
    pub sn: S,
    /// cn, its cosine.
    pub cn: S,
    /// dn, the slope of the amplitude.
    pub dn: S,
    /// The mean slope of the amplitude, pi / (2 K); zero where k = 1.
    pub mean: S,
}

/// Means taken: enough for k' above 1e-60, in double-double, too.
const LEVELS: usize = 12;

/// The functions of `u` for the modulus k whose complement `k'^2 = 1 - k^2` is given, between 0 and 1.
#[inline(always)]
pub fn jacobi<S: Scalar>(u: S, complement: S) -> Jacobi<S> {
    let one = S::from(1.0);
    let mut a = [one; LEVELS + 1];
    let mut b = [complement.sqrt(); LEVELS + 1];
    for n in 0..LEVELS {
        a[n + 1] = (a[n] + b[n]) * 0.5;
        b[n + 1] = (a[n] * b[n]).sqrt();
    }
    let mean = a[LEVELS];
    let (sin, cos) = (mean * u).sin_cos();
    // c = x / sin: finite where the sine vanishes.
    let (mut x, mut dn) = (mean * cos, one);
    let square = sin * sin;
    for n in (0..LEVELS).rev() {
        let ratio = x * x / a[n + 1];
        x = x * dn;
        dn = (b[n] * square + ratio) / (a[n] * square + ratio);
    }
    let length = (x * x + square).sqrt();
    // k = 1: the means never meet, and the functions are hyperbolic.
    let straight = complement.le(S::from(0.0));
    let sech = one / u.cosh();
    Jacobi {
        sn: S::select(straight, u.tanh(), sin / length),
        cn: S::select(straight, sech, x / length),
        dn: S::select(straight, sech, dn),
        mean: S::select(straight, S::from(0.0), mean),
    }
}
