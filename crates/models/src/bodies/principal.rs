//! Principal moments and axes of a matrix of inertia, by Jacobi's rotations (G. Golub and C. Van Loan, Matrix
//! Computations, section 8.5).

use super::{Matrix, Vector, transposed};

/// Sweeps after which nothing is left to rotate: each squares what is off the diagonal.
const SWEEPS: usize = 12;

pub(super) fn principal(mut a: Matrix) -> (Vector, Matrix) {
    let mut axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    for _ in 0..SWEEPS {
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            if a[p][q] == 0.0 {
                continue;
            }
            // The tangent of the smaller angle that makes a[p][q] vanish.
            let tau = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
            let t = tau.signum() / (tau.abs() + (1.0 + tau * tau).sqrt());
            let c = 1.0 / (1.0 + t * t).sqrt();
            let s = t * c;
            // Rows p and q, columns p and q, and the axes.
            rotate(&mut a, p, q, c, s);
            a = transposed(a);
            rotate(&mut a, p, q, c, s);
            rotate(&mut axes, p, q, c, s);
            (a[p][q], a[q][p]) = (0.0, 0.0);
        }
    }
    let mut order = [0, 1, 2];
    order.sort_by(|&i, &j| a[i][i].total_cmp(&a[j][j]));
    (order.map(|i| a[i][i]), order.map(|i| axes[i]))
}

fn rotate(rows: &mut Matrix, p: usize, q: usize, c: f64, s: f64) {
    for k in 0..3 {
        let (x, y) = (rows[p][k], rows[q][k]);
        (rows[p][k], rows[q][k]) = (c * x - s * y, s * x + c * y);
    }
}
