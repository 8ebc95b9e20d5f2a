//! What a map of basins says in a few numbers.

use precess_scalar::Scalar;

/// A number with its standard error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The number.
    pub value: f64,
    /// Its standard error.
    pub error: f64,
}

/// The side of the boxes of the entropy, in points.
const BOX: usize = 5;

/// The share of the points with this label; the error is that of as many independent points, which a grid beats.
pub fn fraction(labels: &[i32], label: i32) -> Estimate {
    let n = labels.len() as f64;
    let value = labels.iter().filter(|l| **l == label).count() as f64 / n;
    Estimate { value, error: (value * (1.0 - value) / n).sqrt() }
}

/// Basin entropy (A. Daza, A. Wagemakers, B. Georgeot, D. Guery-Odelin, M. A. F. Sanjuan, Sci. Rep. 6, 31416, 2016):
/// the Gibbs entropy of the labels in boxes of 5 x 5 points, averaged over all boxes, and over those of the boundary. Above
/// ln 2 on the boundary it is fractal. Undecided points are left out. None where no box is whole, or none on the boundary.
pub fn entropy(labels: &[i32], columns: usize) -> [Option<Estimate>; 2] {
    let rows = labels.len() / columns;
    let mut all = vec![];
    for top in (0..rows / BOX).map(|k| k * BOX) {
        for left in (0..columns / BOX).map(|k| k * BOX) {
            let inside = (0..BOX * BOX).map(|k| labels[(top + k / BOX) * columns + left + k % BOX]);
            let mut inside: Vec<i32> = inside.filter(|label| *label != -1).collect();
            inside.sort_unstable();
            let count = inside.len() as f64;
            let shares = inside.chunk_by(|a, b| a == b).map(|same| same.len() as f64 / count);
            all.push(shares.fold(0.0, |sum, share| sum - share * Scalar::ln(share)));
        }
    }
    let boundary: Vec<f64> = all.iter().copied().filter(|s| *s > 0.0).collect();
    [mean(&all), mean(&boundary)]
}

fn mean(numbers: &[f64]) -> Option<Estimate> {
    let n = numbers.len() as f64;
    if n < 2.0 {
        return None;
    }
    let value = numbers.iter().sum::<f64>() / n;
    let square = numbers.iter().fold(0.0, |sum, x| sum + (x - value) * (x - value));
    Some(Estimate { value, error: (square / (n - 1.0) / n).sqrt() })
}

/// The uncertainty exponent (C. Grebogi, S. W. `McDonald`, E. Ott, J. A. Yorke, Phys. Lett. 99A, 415, 1983): the share of
/// points with another label at a distance e along either axis grows like e to this power, the dimension of the plane less
/// that of the boundary. From a line through the logarithms at 1, 2, 4, ... points, weighted by their counts; none
/// where the labels are too uniform or the map too small.
pub fn uncertainty(labels: &[i32], columns: usize) -> Option<Estimate> {
    let rows = labels.len() / columns;
    let distances: Vec<usize> =
        (0..usize::BITS).map(|k| 1 << k).take_while(|d| d * 8 <= rows && d * 8 <= columns).collect();
    let margin = *distances.last()?;
    let at = |row: usize, column: usize| labels[row * columns + column];
    let mut points = vec![];
    for d in distances {
        let (mut uncertain, mut tried) = (0, 0);
        // The same points at every distance: those that have all their neighbours.
        for row in margin..rows - margin {
            for column in margin..columns - margin {
                let own = at(row, column);
                let around =
                    [at(row, column - d), at(row, column + d), at(row - d, column), at(row + d, column)];
                if own != -1 && !around.contains(&-1) {
                    tried += 1;
                    uncertain += usize::from(around.iter().any(|other| *other != own));
                }
            }
        }
        if uncertain > 0 && uncertain < tried {
            let share = uncertain as f64 / tried as f64;
            points.push((Scalar::ln(d as f64), Scalar::ln(share), uncertain as f64));
        }
    }
    line(&points)
}

/// The slope of a weighted line through at least three points.
fn line(points: &[(f64, f64, f64)]) -> Option<Estimate> {
    if points.len() < 3 {
        return None;
    }
    let sum = |f: &dyn Fn(&(f64, f64, f64)) -> f64| points.iter().map(f).sum::<f64>();
    let weight = sum(&|p| p.2);
    let (x, y) = (sum(&|p| p.2 * p.0) / weight, sum(&|p| p.2 * p.1) / weight);
    let width = sum(&|p| p.2 * (p.0 - x) * (p.0 - x));
    let value = sum(&|p| p.2 * (p.0 - x) * (p.1 - y)) / width;
    let rest = sum(&|p| p.2 * (p.1 - y - value * (p.0 - x)) * (p.1 - y - value * (p.0 - x)));
    Some(Estimate { value, error: (rest / (points.len() - 2) as f64 / width).sqrt() })
}
