//! Systems of linear equations: Gauss's elimination with the largest pivot of each column, lane by lane.

use precess_scalar::Scalar;

/// A square matrix, factorised in place; row after row.
pub(crate) struct Lu<S: Scalar> {
    size: usize,
    a: Vec<S>,
    /// Whether two rows changed places, in the order in which that was asked.
    swaps: Vec<S::Mask>,
}

impl<S: Scalar> Lu<S> {
    /// Room for a matrix of so many rows.
    pub fn new(size: usize) -> Self {
        Self { size, a: vec![S::from(0.0); size * size], swaps: vec![] }
    }

    /// The entries, to be filled in before [`factorise`](Self::factorise).
    #[inline(always)]
    pub fn entries(&mut self) -> &mut [S] {
        &mut self.a
    }

    /// Factorises the entries. A singular matrix gives solutions that are not finite.
    #[inline(always)]
    pub fn factorise(&mut self) {
        let n = self.size;
        self.swaps.clear();
        for k in 0..n {
            for row in k + 1..n {
                let (upper, lower) = self.a.split_at_mut(row * n);
                let (upper, lower) = (&mut upper[k * n..][..n], &mut lower[..n]);
                let swap = lower[k].abs().gt(upper[k].abs());
                for (a, b) in upper.iter_mut().zip(lower) {
                    exchange(swap, a, b);
                }
                self.swaps.push(swap);
            }
            for row in k + 1..n {
                let (upper, lower) = self.a.split_at_mut(row * n);
                let (pivot, lower) = (&upper[k * n..][..n], &mut lower[..n]);
                let factor = lower[k] / pivot[k];
                lower[k] = factor;
                for column in k + 1..n {
                    lower[column] = lower[column] - factor * pivot[column];
                }
            }
        }
    }

    /// Solves for the right-hand side `b`, in place.
    #[inline(always)]
    pub fn solve(&self, b: &mut [S]) {
        let n = self.size;
        let mut swaps = self.swaps.iter();
        // The factors of a column moved with their rows in later columns, so all exchanges come first.
        for k in 0..n {
            let (upper, lower) = b.split_at_mut(k + 1);
            for (lower, swap) in lower.iter_mut().zip(&mut swaps) {
                exchange(*swap, &mut upper[k], lower);
            }
        }
        for row in 1..n {
            for column in 0..row {
                b[row] = b[row] - self.a[row * n + column] * b[column];
            }
        }
        for row in (0..n).rev() {
            for column in row + 1..n {
                b[row] = b[row] - self.a[row * n + column] * b[column];
            }
            b[row] = b[row] / self.a[row * n + row];
        }
    }
}

#[inline(always)]
fn exchange<S: Scalar>(swap: S::Mask, a: &mut S, b: &mut S) {
    (*a, *b) = (S::select(swap, *b, *a), S::select(swap, *a, *b));
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Matrices that need their rows exchanged, against a product.
    #[test]
    fn solves_what_it_multiplies() {
        let mut seed = 1_u64;
        let mut random = || {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
        };
        for size in [1, 2, 3, 7, 12] {
            let mut a: Vec<f64> = (0..size * size).map(|_| random()).collect();
            a[0] = if size > 1 { 0.0 } else { 2.0 };
            let x: Vec<f64> = (0..size).map(|_| random()).collect();
            let mut b: Vec<f64> =
                (0..size).map(|i| (0..size).map(|j| a[i * size + j] * x[j]).sum()).collect();
            let mut lu = Lu::new(size);
            lu.entries().copy_from_slice(&a);
            lu.factorise();
            lu.solve(&mut b);
            for (x, found) in x.iter().zip(&b) {
                assert!((x - found).abs() < 1e-12, "{size}: {found} instead of {x}");
            }
        }
    }
}
