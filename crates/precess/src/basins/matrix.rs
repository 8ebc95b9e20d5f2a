//! Small dense matrices: linear equations, and Lyapunov's.

/// Rows.
pub(super) type Matrix = Vec<Vec<f64>>;

/// The solution of a x = b by elimination with pivots; none where the matrix is singular.
pub(super) fn solve(mut a: Matrix, mut b: Vec<f64>) -> Option<Vec<f64>> {
    let n = b.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|&i, &j| a[i][k].abs().total_cmp(&a[j][k].abs()))?;
        a.swap(k, pivot);
        b.swap(k, pivot);
        let largest = a[k].iter().fold(0.0_f64, |most, x| if x.abs() > most { x.abs() } else { most });
        let head = a[k].clone();
        let regular = head[k].abs() > 1e-14 * largest;
        if !regular {
            return None;
        }
        for i in k + 1..n {
            let factor = a[i][k] / head[k];
            for (x, h) in a[i].iter_mut().zip(&head).skip(k) {
                *x -= factor * h;
            }
            b[i] -= factor * b[k];
        }
    }
    for k in (0..n).rev() {
        let rest = (k + 1..n).fold(b[k], |sum, j| sum - a[k][j] * b[j]);
        b[k] = rest / a[k][k];
    }
    b.iter().all(|x| x.is_finite()).then_some(b)
}

/// The symmetric p that solves a linear equation of Lyapunov's kind, whose left side is `image(i, j, k, l)` times p(k, l)
/// summed, and whose right side is minus one.
fn symmetric(n: usize, image: impl Fn(usize, usize, usize, usize) -> f64) -> Option<Matrix> {
    let row = |ij: usize| (0..n * n).map(|kl| image(ij / n, ij % n, kl / n, kl % n)).collect();
    let right = (0..n * n).map(|ij| if ij / n == ij % n { -1.0 } else { 0.0 }).collect();
    let p = solve((0..n * n).map(row).collect(), right)?;
    let p = (0..n).map(|i| (0..n).map(|j| 0.5 * (p[i * n + j] + p[j * n + i])).collect()).collect();
    Some(p)
}

fn one(i: usize, j: usize) -> f64 {
    if i == j { 1.0 } else { 0.0 }
}

/// The p of a^T p + p a = -1: z.p z shrinks along z' = a z, where p is positive.
pub(super) fn of_flow(a: &Matrix) -> Option<Matrix> {
    symmetric(a.len(), |i, j, k, l| a[k][i] * one(j, l) + a[l][j] * one(i, k))
}

/// The p of m^T p m - p = -1: z.p z shrinks from z to m z, where p is positive.
pub(super) fn of_map(m: &Matrix) -> Option<Matrix> {
    symmetric(m.len(), |i, j, k, l| m[k][i] * m[l][j] - one(i, k) * one(j, l))
}

/// Whether a symmetric matrix is positive (Cholesky's factors exist).
pub(super) fn is_positive(p: &Matrix) -> bool {
    let n = p.len();
    let mut factor = vec![vec![0.0; n]; n];
    for i in 0..n {
        for j in 0..=i {
            let sum = (0..j).fold(p[i][j], |sum, k| sum - factor[i][k] * factor[j][k]);
            let positive = sum > 0.0;
            if i == j && !positive {
                return false;
            }
            factor[i][j] = if i == j { sum.sqrt() } else { sum / factor[j][j] };
        }
    }
    true
}

/// z.p z
pub(super) fn form(p: &Matrix, z: &[f64]) -> f64 {
    p.iter()
        .zip(z)
        .fold(0.0, |sum, (row, x)| sum + x * row.iter().zip(z).fold(0.0, |sum, (p, z)| sum + p * z))
}

/// The derivatives of a vector function by central differences, column by column; `unit` is the scale of each argument.
pub(super) fn jacobian(
    x: &[f64],
    unit: &[f64],
    step: f64,
    f: impl Fn(&[f64]) -> Option<Vec<f64>>,
) -> Option<Matrix> {
    let mut columns = vec![];
    for i in 0..x.len() {
        let at = |sign: f64| {
            let mut moved = x.to_vec();
            moved[i] += sign * step * unit[i];
            (moved[i], moved)
        };
        let ((right, after), (left, before)) = (at(1.0), at(-1.0));
        let (after, before) = (f(&after)?, f(&before)?);
        columns.push(after.iter().zip(&before).map(|(a, b)| (a - b) / (right - left)).collect::<Vec<f64>>());
    }
    Some((0..columns.first()?.len()).map(|i| columns.iter().map(|column| column[i]).collect()).collect())
}
