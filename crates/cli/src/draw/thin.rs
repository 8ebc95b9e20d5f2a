//! As many points as the pixels can show, and no more.
//!
//! A million points in nine hundred columns would make an SVG of fifty megabytes that looks the
//! same. Three rules, each invisible at the scale of a pixel and each deterministic:
//! a curve that runs rightwards keeps the first, lowest, highest and last point of every half-pixel
//! column (so no peak is lost); a point closer than 0.3 pixel to the last one kept is left out; and
//! in very long curves a segment that lies wholly on ink of the same curve is not drawn again.

/// A point on the page.
pub type Point = (f64, f64);

/// Below this distance two points are one.
const NEAR: f64 = 0.3;
/// Columns per pixel.
const COLUMNS: f64 = 2.0;
/// Curves that keep more points than this are thinned by their ink.
const LONG: usize = 30_000;
/// Cells per pixel in which that ink is noted.
const CELLS: f64 = 2.0;

/// Pieces of a curve between interruptions, thinned.
pub fn thinned(points: &[Point]) -> Vec<Vec<Point>> {
    let runs = runs(points);
    let thin = |run: Vec<Point>| distant(&if rightwards(&run) { columns(&run) } else { run });
    let runs: Vec<_> = runs.into_iter().map(thin).collect();
    if runs.iter().map(Vec::len).sum::<usize>() > LONG { fresh_ink(&runs) } else { runs }
}

/// The pieces between points that are not finite.
fn runs(points: &[Point]) -> Vec<Vec<Point>> {
    let whole = |p: &Point| p.0.is_finite() && p.1.is_finite();
    points.split(|p| !whole(p)).filter(|run| !run.is_empty()).map(<[Point]>::to_vec).collect()
}

fn rightwards(run: &[Point]) -> bool {
    run.windows(2).all(|w| w[1].0 >= w[0].0)
}

/// First, lowest, highest and last of every column, in their order.
fn columns(run: &[Point]) -> Vec<Point> {
    let column = |p: &Point| (p.0 * COLUMNS).floor();
    let mut kept = Vec::new();
    for group in run.chunk_by(|a, b| column(a) == column(b)) {
        let by_height = |i: &usize, j: &usize| group[*i].1.total_cmp(&group[*j].1);
        let low = (0..group.len()).min_by(by_height).unwrap_or(0);
        let high = (0..group.len()).max_by(by_height).unwrap_or(0);
        let mut chosen = [0, low.min(high), low.max(high), group.len() - 1].to_vec();
        chosen.dedup();
        kept.extend(chosen.into_iter().map(|i| group[i]));
    }
    kept
}

/// Without the points that lie on the last one kept; the end stays.
fn distant(run: &[Point]) -> Vec<Point> {
    let mut kept: Vec<Point> = Vec::new();
    for (i, &p) in run.iter().enumerate() {
        let far = kept.last().is_none_or(|q| (p.0 - q.0).hypot(p.1 - q.1) >= NEAR);
        if far || (i + 1 == run.len() && kept.last() != Some(&p)) {
            kept.push(p);
        }
    }
    kept
}

/// Only the segments that touch a cell which the curve has not yet inked.
fn fresh_ink(runs: &[Vec<Point>]) -> Vec<Vec<Point>> {
    let mut ink = Ink::new(runs);
    let mut kept: Vec<Vec<Point>> = Vec::new();
    for run in runs {
        if let [p] = run[..] {
            if ink.touch(p, p) {
                kept.push(vec![p]);
            }
            continue;
        }
        let mut open = false;
        for w in run.windows(2) {
            let fresh = ink.touch(w[0], w[1]);
            match kept.last_mut() {
                Some(piece) if fresh && open => piece.push(w[1]),
                _ if fresh => kept.push(vec![w[0], w[1]]),
                _ => {}
            }
            open = fresh;
        }
    }
    kept
}

/// Which half-pixel cells of the curve's own rectangle carry ink.
struct Ink {
    left: f64,
    top: f64,
    wide: usize,
    high: usize,
    cells: Vec<bool>,
}

impl Ink {
    fn new(runs: &[Vec<Point>]) -> Self {
        let points = || runs.iter().flatten();
        let left = points().map(|p| p.0).fold(f64::INFINITY, f64::min);
        let top = points().map(|p| p.1).fold(f64::INFINITY, f64::min);
        let right = points().map(|p| p.0).fold(left, f64::max);
        let bottom = points().map(|p| p.1).fold(top, f64::max);
        let cells = |from: f64, to: f64| ((to - from) * CELLS).clamp(0.0, 1e4) as usize + 1;
        let (wide, high) = (cells(left, right), cells(top, bottom));
        Self { left, top, wide, high, cells: vec![false; wide * high] }
    }

    /// Inks the cells along a segment, sampled twice in each; true if one of them was bare.
    fn touch(&mut self, a: Point, b: Point) -> bool {
        let steps = ((b.0 - a.0).hypot(b.1 - a.1) * 2.0 * CELLS).ceil().clamp(1.0, 1e5);
        let mut fresh = false;
        for i in 0..=steps as usize {
            let s = i as f64 / steps;
            let column = ((a.0 + s * (b.0 - a.0) - self.left) * CELLS) as usize;
            let row = ((a.1 + s * (b.1 - a.1) - self.top) * CELLS) as usize;
            let cell = &mut self.cells[row.min(self.high - 1) * self.wide + column.min(self.wide - 1)];
            fresh |= !*cell;
            *cell = true;
        }
        fresh
    }
}
