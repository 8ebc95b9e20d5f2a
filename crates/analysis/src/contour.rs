//! Level lines of a function on a grid: marching squares, the pieces joined to lines.

/// A line in the plane.
pub type Line = Vec<(f64, f64)>;

/// The lines on which the function, given at the crossings of a grid (the first coordinate running fastest), has the
/// value `level`. Where a number is not finite there is no line.
pub fn contour(xs: &[f64], ys: &[f64], values: &[f64], level: f64) -> Vec<Line> {
    let grid = Grid { xs, ys, values, level };
    let mut joins: Vec<Vec<usize>> = vec![vec![]; 2 * xs.len() * ys.len()];
    for j in 0..ys.len().saturating_sub(1) {
        for i in 0..xs.len().saturating_sub(1) {
            for (a, b) in grid.pieces(i, j) {
                joins[a].push(b);
                joins[b].push(a);
            }
        }
    }
    let mut lines = vec![];
    // Lines that end (at the border) first, then those that close.
    for ends in [true, false] {
        for start in 0..joins.len() {
            if joins[start].is_empty() || ends && joins[start].len() != 1 {
                continue;
            }
            lines.push(walk(&grid, &mut joins, start));
        }
    }
    lines
}

/// Follows a line from one edge of the grid to the next, taking away what it has passed.
fn walk(grid: &Grid, joins: &mut [Vec<usize>], start: usize) -> Line {
    let mut line = vec![grid.point(start)];
    let mut here = start;
    while let Some(next) = joins[here].pop() {
        joins[next].retain(|&other| other != here);
        line.push(grid.point(next));
        here = next;
    }
    line
}

struct Grid<'a> {
    xs: &'a [f64],
    ys: &'a [f64],
    values: &'a [f64],
    level: f64,
}

impl Grid<'_> {
    fn at(&self, i: usize, j: usize) -> f64 {
        self.values[j * self.xs.len() + i] - self.level
    }

    /// Edges have numbers: twice the number of their first corner, and one more where they go up.
    fn edge(&self, i: usize, j: usize, up: bool) -> usize {
        2 * (j * self.xs.len() + i) + usize::from(up)
    }

    /// Where the level crosses an edge.
    fn point(&self, edge: usize) -> (f64, f64) {
        let (corner, up) = (edge / 2, edge % 2);
        let (i, j) = (corner % self.xs.len(), corner / self.xs.len());
        let (k, l) = if up == 1 { (i, j + 1) } else { (i + 1, j) };
        let (a, b) = (self.at(i, j), self.at(k, l));
        let share = a / (a - b);
        let between = |from: f64, to: f64| from + (to - from) * share;
        (between(self.xs[i], self.xs[k]), between(self.ys[j], self.ys[l]))
    }

    /// The pieces of the line inside a cell, as pairs of edges.
    fn pieces(&self, i: usize, j: usize) -> Vec<(usize, usize)> {
        let corners = [self.at(i, j), self.at(i + 1, j), self.at(i + 1, j + 1), self.at(i, j + 1)];
        if !corners.iter().all(|c| c.is_finite()) {
            return vec![];
        }
        let above: Vec<bool> = corners.iter().map(|c| *c > 0.0).collect();
        let edges = [
            self.edge(i, j, false),
            self.edge(i + 1, j, true),
            self.edge(i, j + 1, false),
            self.edge(i, j, true),
        ];
        let crossed: Vec<usize> = (0..4).filter(|&k| above[k] != above[(k + 1) % 4]).collect();
        match crossed[..] {
            [a, b] => vec![(edges[a], edges[b])],
            // A saddle: the middle tells which corners belong together.
            [a, b, c, d] => {
                let middle = corners.iter().fold(0.0, |sum, c| sum + c) > 0.0;
                if middle == above[0] {
                    vec![(edges[a], edges[b]), (edges[c], edges[d])]
                } else {
                    vec![(edges[d], edges[a]), (edges[b], edges[c])]
                }
            }
            _ => vec![],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_circle_is_one_closed_line_at_its_radius() {
        let xs: Vec<f64> = (0..81).map(|i| f64::from(i) / 20.0 - 2.0).collect();
        let values: Vec<f64> = xs.iter().flat_map(|y| xs.iter().map(move |x| x * x + y * y)).collect();
        let lines = contour(&xs, &xs, &values, 1.5);
        assert_eq!(lines.len(), 1);
        assert_eq!(lines[0].first(), lines[0].last());
        for (x, y) in &lines[0] {
            assert!((x * x + y * y - 1.5).abs() < 1e-3, "{x} {y}");
        }
    }

    #[test]
    fn a_hyperbola_is_two_lines_that_end_at_the_border() {
        let xs: Vec<f64> = (0..64).map(|i| f64::from(i) / 15.75 - 2.0).collect();
        let values: Vec<f64> = xs.iter().flat_map(|y| xs.iter().map(move |x| x * x - y * y)).collect();
        let lines = contour(&xs, &xs, &values, 0.7);
        assert_eq!(lines.len(), 2);
        assert!(lines.iter().all(|line| line.len() > 60 && line.first() != line.last()));
    }
}
