//! As many points as the pixels can show, and no more.
//!
//! A million points in nine hundred columns would make an SVG of fifty megabytes that looks the
//! same. Three rules, each invisible at the scale of a pixel and each deterministic:
//! a curve that runs rightwards keeps the first, lowest, highest and last point of every half-pixel
//! column (so no peak is lost); a point closer than 0.3 pixel to the last one kept is left out; and
//! in very long curves a segment that lies wholly on ink of the same curve is not drawn again.

use std::collections::HashSet;

/// A point on the page.
pub type Point = (f64, f64);

/// Below this distance two points are one.
const NEAR: f64 = 0.3;
/// Columns per pixel.
const COLUMNS: f64 = 2.0;
/// Curves that keep more points than this are thinned by their ink.
const LONG: usize = 30_000;

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

/// Only the segments that touch a pixel which the curve has not yet inked.
fn fresh_ink(runs: &[Vec<Point>]) -> Vec<Vec<Point>> {
    let mut inked = HashSet::new();
    let mut kept: Vec<Vec<Point>> = Vec::new();
    for run in runs {
        if let [p] = run[..] {
            if inked.insert(pixel(p)) {
                kept.push(vec![p]);
            }
            continue;
        }
        let mut open = false;
        for w in run.windows(2) {
            let fresh = touched(w[0], w[1]).fold(false, |new, cell| inked.insert(cell) | new);
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

fn pixel(p: Point) -> (i64, i64) {
    (p.0.floor() as i64, p.1.floor() as i64)
}

/// The pixels along a segment, sampled every half pixel.
fn touched(a: Point, b: Point) -> impl Iterator<Item = (i64, i64)> {
    let steps = ((b.0 - a.0).hypot(b.1 - a.1) * 2.0).ceil().clamp(1.0, 1e5);
    (0..=steps as i64).map(move |i| {
        let s = i as f64 / steps;
        pixel((a.0 + s * (b.0 - a.0), a.1 + s * (b.1 - a.1)))
    })
}
