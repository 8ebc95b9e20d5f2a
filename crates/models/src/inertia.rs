//! Matrices of inertia: transfer to another point, and the equations they stand in.

use crate::rotation::{Vector, dot};
use precess_scalar::Scalar;

/// A matrix, row by row.
pub(crate) type Matrix<S> = [Vector<S>; 3];

/// A matrix with these numbers on its diagonal.
#[inline(always)]
pub(crate) fn diagonal<S: Scalar>([a, b, c]: Vector<S>) -> Matrix<S> {
    let zero = S::from(0.0);
    [[a, zero, zero], [zero, b, zero], [zero, zero, c]]
}

/// Matrix times vector.
#[inline(always)]
pub(crate) fn apply<S: Scalar>(matrix: Matrix<S>, v: Vector<S>) -> Vector<S> {
    // No closure: what the standard library calls back may stay a call, which lanes' instructions do not reach.
    [dot(matrix[0], v), dot(matrix[1], v), dot(matrix[2], v)]
}

/// Huygens and Steiner: what mass `m` adds at a point whose vector to G (or from it) is `arm` (T, section 3.2),
/// `m (arm . arm 1 - arm arm^T)`.
#[inline(always)]
pub(crate) fn transferred<S: Scalar>(about_g: Matrix<S>, m: S, arm: Vector<S>) -> Matrix<S> {
    let square = dot(arm, arm);
    let mut moved = about_g;
    for i in 0..3 {
        for j in 0..3 {
            let product = arm[i] * arm[j];
            moved[i][j] = moved[i][j] + m * (if i == j { square - product } else { -product });
        }
    }
    moved
}

/// The solution x of `matrix x = b` for a symmetric positive matrix, by elimination.
///
/// T's annex D gives the inverse by cofactors. Where `I_A` is stretched (a thin body far from A) that loses as many digits
/// as the stretch has; elimination leaves an error that is small against `matrix x`, and so keeps the energy.
#[inline(always)]
pub(crate) fn solve<S: Scalar>(matrix: Matrix<S>, b: Vector<S>) -> Vector<S> {
    let [[a00, a01, a02], [_, a11, a12], [_, _, a22]] = matrix;
    let (l1, l2) = (a01 / a00, a02 / a00);
    let (d1, below) = (a11 - l1 * a01, a12 - l1 * a02);
    let l3 = below / d1;
    let d2 = a22 - l2 * a02 - l3 * below;
    let b1 = b[1] - l1 * b[0];
    let z = (b[2] - l2 * b[0] - l3 * b1) / d2;
    let y = b1 / d1 - l3 * z;
    [b[0] / a00 - l1 * y - l2 * z, y, z]
}
