//! Eigenvalues of a small real matrix: reduction to Hessenberg form, then the QR iteration with double shifts
//! (Francis 1961; Wilkinson and Reinsch, *Linear Algebra*, II/15), with our own square root and no other function.

use crate::Matrix;
use precess_scalar::Scalar;

/// A complex number.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Complex {
    /// Real part.
    pub re: f64,
    /// Imaginary part.
    pub im: f64,
}

impl Complex {
    /// Its distance from zero.
    pub fn modulus(self) -> f64 {
        Scalar::hypot(self.re, self.im)
    }
}

/// Iterations for one eigenvalue, beyond which there is none (the matrix has no numbers).
const MOST: u32 = 100;

/// All eigenvalues, the largest real part first; of a pair the one with the positive imaginary part first. `None`
/// where the iteration finds none (numbers that are not finite).
pub fn eigenvalues(matrix: &Matrix) -> Option<Vec<Complex>> {
    if !matrix.is_finite() {
        return None;
    }
    let mut h = matrix.clone();
    hessenberg(&mut h);
    let mut found = vec![];
    let (mut high, mut tries) = (h.size, 0);
    while high > 0 {
        let low = split(&mut h, high);
        match high - low {
            1 => {
                found.push(Complex { re: h.at(low, low), im: 0.0 });
                (high, tries) = (low, 0);
            }
            2 => {
                found.extend(pair(&h, low));
                (high, tries) = (low, 0);
            }
            _ if tries == MOST => return None,
            _ => {
                tries += 1;
                sweep(&mut h, low, high, tries % 10 == 0);
            }
        }
    }
    found.sort_by(|a, b| b.re.total_cmp(&a.re).then(b.im.total_cmp(&a.im)));
    Some(found)
}

/// Similar to the matrix, with zeros below the first subdiagonal (Householder).
fn hessenberg(a: &mut Matrix) {
    for k in 1..a.size.saturating_sub(1) {
        let column: Vec<f64> = (k..a.size).map(|i| a.at(i, k - 1)).collect();
        reflect(a, k, &column, 0, a.size);
    }
}

/// Applies from both sides the reflection that turns `x`, standing in rows `k..`, into its first component.
fn reflect(a: &mut Matrix, k: usize, x: &[f64], first: usize, last: usize) {
    let length = crate::frame::dot(x, x).sqrt();
    if length == 0.0 {
        return;
    }
    let mut v = x.to_vec();
    v[0] += if x[0] < 0.0 { -length } else { length };
    let square = crate::frame::dot(&v, &v);
    for j in first..a.size {
        let share = (0..v.len()).fold(0.0, |sum, i| sum + v[i] * a.at(k + i, j)) * 2.0 / square;
        (0..v.len()).for_each(|i| a.set(k + i, j, a.at(k + i, j) - share * v[i]));
    }
    for i in 0..last {
        let share = (0..v.len()).fold(0.0, |sum, j| sum + v[j] * a.at(i, k + j)) * 2.0 / square;
        (0..v.len()).for_each(|j| a.set(i, k + j, a.at(i, k + j) - share * v[j]));
    }
}

/// Where the last block that does not fall apart begins; a subdiagonal number too small to matter becomes zero.
fn split(h: &mut Matrix, high: usize) -> usize {
    for k in (1..high).rev() {
        let scale = h.at(k, k).abs() + h.at(k - 1, k - 1).abs();
        let scale =
            if scale == 0.0 { h.numbers.iter().fold(0.0, |a: f64, x| x.abs().larger(a)) } else { scale };
        if h.at(k, k - 1).abs() <= f64::EPSILON * scale {
            h.set(k, k - 1, 0.0);
            return k;
        }
    }
    0
}

/// Both eigenvalues of the 2 by 2 block at `k`.
fn pair(h: &Matrix, k: usize) -> [Complex; 2] {
    let (a, b, c, d) = (h.at(k, k), h.at(k, k + 1), h.at(k + 1, k), h.at(k + 1, k + 1));
    let (middle, half) = ((a + d) * 0.5, (a - d) * 0.5);
    let square = half * half + b * c;
    if square < 0.0 {
        let im = (-square).sqrt();
        return [Complex { re: middle, im }, Complex { re: middle, im: -im }];
    }
    // The larger one has no cancellation; the other follows from the product.
    let far = middle + if middle < 0.0 { -square.sqrt() } else { square.sqrt() };
    let near = if far == 0.0 { 0.0 } else { (a * d - b * c) / far };
    [Complex { re: far, im: 0.0 }, Complex { re: near, im: 0.0 }]
}

/// One implicit double-shift sweep over the block `low..high`; now and then with an exceptional shift, which ends
/// cycles.
fn sweep(h: &mut Matrix, low: usize, high: usize, exceptional: bool) {
    let n = high - 1;
    let (mut sum, mut product) =
        (h.at(n - 1, n - 1) + h.at(n, n), h.at(n - 1, n - 1) * h.at(n, n) - h.at(n - 1, n) * h.at(n, n - 1));
    if exceptional {
        let size = h.at(n, n - 1).abs() + h.at(n - 1, n - 2).abs();
        (sum, product) = (1.5 * size, size * size);
    }
    let (a, b) = (h.at(low, low), h.at(low + 1, low));
    let mut x = vec![
        a * a + h.at(low, low + 1) * b - sum * a + product,
        b * (a + h.at(low + 1, low + 1) - sum),
        b * h.at(low + 2, low + 1),
    ];
    for k in low..high - 1 {
        let first = if k > low { k - 1 } else { low };
        let last = if k + 4 < high { k + 4 } else { high };
        reflect(h, k, &x, first, last);
        if k + 2 < high {
            let rows = if k + 3 < high { 3 } else { 2 };
            x = (0..rows).map(|i| h.at(k + 1 + i, k)).collect();
        }
    }
    // What the reflections left of their bulges is rounding.
    for i in low + 2..high {
        for j in low..i - 1 {
            h.set(i, j, 0.0);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(matrix: &Matrix, wanted: &[(f64, f64)], bound: f64) {
        let found = eigenvalues(matrix).expect("they exist");
        assert_eq!(found.len(), wanted.len());
        for (f, (re, im)) in found.iter().zip(wanted) {
            assert!((f.re - re).abs() < bound && (f.im - im).abs() < bound, "{found:?} {wanted:?}");
        }
    }

    #[test]
    fn a_companion_matrix_has_the_roots_of_its_polynomial() {
        // (x - 3)(x + 2)(x^2 - 2 x + 5) = x^4 - 3 x^3 + x^2 + 7 x - 30
        let numbers = vec![3.0, -1.0, -7.0, 30.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0];
        check(&Matrix { size: 4, numbers }, &[(3.0, 0.0), (1.0, 2.0), (1.0, -2.0), (-2.0, 0.0)], 1e-13);
    }

    #[test]
    fn a_full_matrix_keeps_trace_and_known_eigenvalues() {
        // A circulant matrix: eigenvalues c0 + c1 w + c2 w^2 + ... at the fifth roots of unity.
        let c = [1.0, 2.0, -0.5, 0.25, 3.0];
        let mut a = Matrix::zeros(5);
        for i in 0..5 {
            for j in 0..5 {
                a.set(i, j, c[(5 + j - i) % 5]);
            }
        }
        let mut wanted: Vec<(f64, f64)> = (0..5)
            .map(|k| {
                (0..5).fold((0.0, 0.0), |(re, im), j| {
                    let angle = std::f64::consts::TAU * (j * k % 5) as f64 / 5.0;
                    (re + c[j] * Scalar::cos(angle), im + c[j] * Scalar::sin(angle))
                })
            })
            .collect();
        wanted.sort_by(|a, b| b.0.total_cmp(&a.0).then(b.1.total_cmp(&a.1)));
        // Members of a pair may differ in the last bit of their real parts.
        let found = eigenvalues(&a).expect("they exist");
        for w in wanted {
            let near = found.iter().any(|f| (f.re - w.0).abs() < 1e-13 && (f.im - w.1).abs() < 1e-13);
            assert!(near, "{w:?} {found:?}");
        }
    }

    #[test]
    fn rotations_and_repeated_values_are_found() {
        check(&Matrix { size: 2, numbers: vec![0.0, 1.0, -4.0, 0.0] }, &[(0.0, 2.0), (0.0, -2.0)], 1e-15);
        check(&Matrix::identity(4), &[(1.0, 0.0); 4], 1e-15);
        // A cyclic permutation, on which a sweep without exceptional shifts stands still.
        let mut cycle = Matrix::zeros(4);
        (0..4).for_each(|i| cycle.set((i + 1) % 4, i, 1.0));
        check(&cycle, &[(1.0, 0.0), (0.0, 1.0), (0.0, -1.0), (-1.0, 0.0)], 1e-14);
        assert_eq!(eigenvalues(&Matrix { size: 1, numbers: vec![f64::NAN] }), None);
    }
}
