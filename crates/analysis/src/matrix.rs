//! Small dense matrices, row by row: what the tangent space of a system needs, in a fixed order of operations.

use precess_scalar::Scalar;

/// A square matrix.
#[derive(Clone, Debug, PartialEq)]
pub struct Matrix {
    /// Number of rows, and of columns.
    pub size: usize,
    /// The numbers, row by row.
    pub numbers: Vec<f64>,
}

impl Matrix {
    /// Zeros.
    pub fn zeros(size: usize) -> Self {
        Self { size, numbers: vec![0.0; size * size] }
    }
    /// Ones on the diagonal.
    pub fn identity(size: usize) -> Self {
        let mut matrix = Self::zeros(size);
        (0..size).for_each(|i| matrix.set(i, i, 1.0));
        matrix
    }
    /// From vectors as columns.
    pub fn of_columns(columns: &[Vec<f64>]) -> Self {
        let mut matrix = Self::zeros(columns.len());
        for (j, column) in columns.iter().enumerate() {
            column.iter().enumerate().for_each(|(i, &x)| matrix.set(i, j, x));
        }
        matrix
    }
    /// The number in a row and a column.
    pub fn at(&self, row: usize, column: usize) -> f64 {
        self.numbers[row * self.size + column]
    }
    /// Sets a number.
    pub fn set(&mut self, row: usize, column: usize, x: f64) {
        self.numbers[row * self.size + column] = x;
    }
    /// The sum of the diagonal.
    pub fn trace(&self) -> f64 {
        (0..self.size).fold(0.0, |sum, i| sum + self.at(i, i))
    }
    /// Whether every number is finite.
    pub fn is_finite(&self) -> bool {
        self.numbers.iter().all(|x| x.is_finite())
    }

    /// The solution x of A x = b by elimination with the largest pivot; `None` where the matrix is singular to
    /// working precision.
    pub fn solve(&self, b: &[f64]) -> Option<Vec<f64>> {
        let n = self.size;
        let (mut a, mut x) = (self.clone(), b.to_vec());
        let largest = self.numbers.iter().fold(0.0, |largest: f64, x| x.abs().larger(largest));
        for k in 0..n {
            let mut pivot = k;
            for i in k + 1..n {
                if a.at(i, k).abs() > a.at(pivot, k).abs() {
                    pivot = i;
                }
            }
            let size = a.at(pivot, k).abs();
            if size <= largest * 1e-15 || size.is_nan() {
                return None;
            }
            for j in 0..n {
                let (here, there) = (a.at(k, j), a.at(pivot, j));
                a.set(k, j, there);
                a.set(pivot, j, here);
            }
            x.swap(k, pivot);
            for i in k + 1..n {
                let factor = a.at(i, k) / a.at(k, k);
                for j in k..n {
                    let reduced = a.at(i, j) - factor * a.at(k, j);
                    a.set(i, j, reduced);
                }
                x[i] -= factor * x[k];
            }
        }
        for k in (0..n).rev() {
            let known = (k + 1..n).fold(x[k], |rest, j| rest - a.at(k, j) * x[j]);
            x[k] = known / a.at(k, k);
        }
        Some(x)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::frame::dot;

    #[test]
    fn a_system_of_equations_is_solved() {
        let a = Matrix { size: 3, numbers: vec![0.0, 2.0, 1.0, 1.0, -1.0, 0.5, 3.0, 0.0, -2.0] };
        let x = a.solve(&[1.0, 2.0, 3.0]).expect("it is regular");
        for i in 0..3 {
            let row = dot(&a.numbers[3 * i..][..3], &x);
            assert!((row - (i + 1) as f64).abs() < 1e-15, "{row}");
        }
        let singular = Matrix { size: 2, numbers: vec![1.0, 2.0, 2.0, 4.0] };
        assert_eq!(singular.solve(&[1.0, 0.0]), None);
    }
}
