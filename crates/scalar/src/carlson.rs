//! Elliptic integrals in Carlson's symmetric forms, by duplication.
//!
//! ```text
//! RF(x, y, z)    = 1/2 int_0^inf dt / sqrt((t + x)(t + y)(t + z))
//! RJ(x, y, z, p) = 3/2 int_0^inf dt / ((t + p) sqrt((t + x)(t + y)(t + z)))
//! ```
//!
//! Each step takes lambda = sqrt(xy) + sqrt(xz) + sqrt(yz), adds it to all arguments and divides by 4: they come together, by a
//! factor of 4 a step, and a series ends it. (B. C. Carlson, Numer. Algorithms 10, 13, 1995; DLMF, sections 19.26 and 19.36.)

use crate::Scalar;

/// Duplications: differences shrink by 4^20, and the series' error by the sixth power of that.
const STEPS: usize = 20;

/// RF, for arguments of zero and above of which one may vanish.
#[inline(always)]
pub fn rf<S: Scalar>(x: S, y: S, z: S) -> S {
    let mean = (x + y + z) / 3.0;
    let (mut at, mut scale, mut middle) = ([x, y, z], 1.0, mean);
    for _ in 0..STEPS {
        let lambda = together(at);
        at = at.map(|part| (part + lambda) * 0.25);
        middle = (middle + lambda) * 0.25;
        scale *= 0.25;
    }
    let [x, y] = [x, y].map(|part| (mean - part) * scale / middle);
    let z = -(x + y);
    let (e2, e3) = (x * y - z * z, x * y * z);
    let series = e2 * e2 / 24.0 - e2 / 10.0 + e3 / 14.0 - e2 * e3 * (3.0 / 44.0) + 1.0;
    series / middle.sqrt()
}

/// RJ in the circular case, `(p - x)(p - y)(p - z) >= 0`, for arguments above zero (one of x, y, z may vanish).
#[inline(always)]
pub fn rj<S: Scalar>(x: S, y: S, z: S, p: S) -> S {
    let mean = (x + y + z + p * 2.0) / 5.0;
    let delta = (p - x) * (p - y) * (p - z);
    let (mut at, mut pole, mut scale, mut middle) = ([x, y, z], p, 1.0, mean);
    let mut sum = S::from(0.0);
    for _ in 0..STEPS {
        let (roots, root) = (at.map(root), pole.sqrt());
        let d = (root + roots[0]) * (root + roots[1]) * (root + roots[2]);
        let e = delta * (scale * scale * scale) / (d * d);
        sum = sum + arctangent(e) * scale / d;
        let lambda = together(at);
        at = at.map(|part| (part + lambda) * 0.25);
        pole = (pole + lambda) * 0.25;
        middle = (middle + lambda) * 0.25;
        scale *= 0.25;
    }
    let [x, y, z] = [x, y, z].map(|part| (mean - part) * scale / middle);
    let p = -(x + y + z) * 0.5;
    let (pairs, all) = (x * y + x * z + y * z, x * y * z);
    let e2 = pairs - p * p * 3.0;
    let e3 = all + e2 * p * 2.0 + p * p * p * 4.0;
    let e4 = (all * 2.0 + e2 * p + p * p * p * 3.0) * p;
    let e5 = all * p * p;
    let series =
        e2 * e2 * (9.0 / 88.0) - e2 * (3.0 / 14.0) + e3 / 6.0 - e4 * (3.0 / 22.0) - e2 * e3 * (9.0 / 52.0)
            + e5 * (3.0 / 26.0)
            + 1.0;
    series * scale / (middle * middle.sqrt()) + sum * 6.0
}

#[inline(always)]
fn together<S: Scalar>(at: [S; 3]) -> S {
    let [x, y, z] = at.map(root);
    x * y + x * z + y * z
}

/// The square root, which a zero has without a slope.
#[inline(always)]
fn root<S: Scalar>(x: S) -> S {
    let zero = S::from(0.0);
    S::select(x.le(zero), zero, x.sqrt())
}

/// `atan(sqrt e) / sqrt e` for e of zero and above.
#[inline(always)]
fn arctangent<S: Scalar>(e: S) -> S {
    let series = (0..8).rev().fold(S::from(0.0), |sum, k| -(sum * e) + 1.0 / (2.0 * f64::from(k) + 1.0));
    let root = e.sqrt();
    S::select(e.le(S::from(1e-3)), series, root.atan2(S::from(1.0)) / root)
}
