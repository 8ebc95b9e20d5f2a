//! Classes on a grid: a coloured cell about each point, with a pattern that tells the classes apart without colour.

use kuva::render::render::{PathData, Primitive, Scene};
use precess::figure::Map;
use std::fmt::Write;

use super::layout::Placed;
use super::style::{INKS, SHADES, UNCLASSED};

/// Pixels after which a pattern comes again.
const PATTERN: f64 = 8.0;
/// A cell larger than this, in pixels, is drawn in parts.
const FINE: f64 = 2.0;
/// Size of a sample of a class.
pub const SWATCH: (f64, f64) = (18.0, 12.0);

/// Draws the cells: a path for each colour, so that neighbours have no seam between them.
pub fn draw(scene: &mut Scene, map: &Map, placed: &Placed) {
    let rows = map.classes.len().checked_div(map.columns).unwrap_or(0);
    if rows == 0 {
        return;
    }
    let (frame, axes) = (placed.frame, &placed.axes);
    let across = |v: f64| {
        let share = (axes.x.local(v) - axes.x.lo) / (axes.x.hi - axes.x.lo);
        frame.x + frame.wide * share.clamp(0.0, 1.0)
    };
    let up = |v: f64| {
        let share = (axes.y.local(v) - axes.y.lo) / (axes.y.hi - axes.y.lo);
        frame.y + frame.high * (1.0 - share.clamp(0.0, 1.0))
    };
    // A large cell is cut into small ones, so that its pattern is as fine as elsewhere.
    let [left, right, ..] = extent(map);
    let cell = ((across(right) - across(left)) / map.columns as f64).abs().max(0.05);
    let parts = (cell / FINE).round().max(1.0) as usize;
    let period = (PATTERN * parts as f64 / cell).round().max(4.0) as usize;
    let xs: Vec<f64> = edges(map.x, map.columns, parts).into_iter().map(across).collect();
    let ys: Vec<f64> = edges(map.y, rows, parts).into_iter().map(up).collect();
    paint(scene, &xs, &ys, period, |i, j| map.classes[j / parts * map.columns + i / parts]);
}

/// A sample of a class: its colour and its pattern, from the upper left corner, [`SWATCH`] wide and high.
pub fn swatch(scene: &mut Scene, class: i32, (x, y): (f64, f64)) {
    let lines = |from: f64, size: f64| -> Vec<f64> {
        (0..=(size / FINE) as usize).map(|k| from + FINE * k as f64).collect()
    };
    paint(scene, &lines(x, SWATCH.0), &lines(y, SWATCH.1), (PATTERN / FINE) as usize, |_, _| class);
}

/// Paints cells between lines, each in the colour of its class.
fn paint(scene: &mut Scene, xs: &[f64], ys: &[f64], period: usize, class: impl Fn(usize, usize) -> i32) {
    let (columns, rows) = (xs.len() - 1, ys.len() - 1);
    let mut paths: Vec<(String, String)> = Vec::new();
    for j in 0..rows {
        let colours: Vec<&str> = (0..columns).map(|i| colour(class(i, j), i, j, period)).collect();
        let mut i = 0;
        while i < columns {
            let end = (i..columns).find(|&k| colours[k] != colours[i]).unwrap_or(columns);
            let known = paths.iter().position(|(c, _)| c == colours[i]).unwrap_or_else(|| {
                paths.push((colours[i].into(), String::new()));
                paths.len() - 1
            });
            let (x, y, w, h) = (xs[i], ys[j], xs[end] - xs[i], ys[j + 1] - ys[j]);
            let _ = write!(paths[known].1, "M{x:.2} {y:.2}h{w:.2}v{h:.2}h{:.2}z", -w);
            i = end;
        }
    }
    let crisp = Some(r#"shape-rendering="crispEdges""#.to_owned());
    scene.add(Primitive::GroupStart { transform: None, title: None, extra_attrs: crisp });
    for (colour, d) in paths {
        scene.add(Primitive::Path(Box::new(PathData {
            d,
            fill: Some(colour.as_str().into()),
            stroke: "none".into(),
            stroke_width: 0.0,
            opacity: None,
            stroke_dasharray: None,
        })));
    }
    scene.add(Primitive::GroupEnd);
}

/// Where the parts of cells begin and end; a cell goes half a spacing to either side of its point.
fn edges((low, high): (f64, f64), points: usize, parts: usize) -> Vec<f64> {
    let spacing = if points < 2 { 1.0 } else { (high - low) / (points - 1) as f64 };
    (0..=points * parts).map(|k| low + (k as f64 / parts as f64 - 0.5) * spacing).collect()
}

/// The ranges that the cells of a map cover.
pub fn extent(map: &Map) -> [f64; 4] {
    let rows = map.classes.len() / map.columns.max(1);
    let half = |(low, high): (f64, f64), n: usize| {
        let half = if n < 2 { 0.5 } else { 0.5 * (high - low) / (n - 1) as f64 };
        [low - half, high + half]
    };
    let ([a, b], [c, d]) = (half(map.x, map.columns), half(map.y, rows));
    [a, b, c, d]
}

/// The colour of a cell: its class's, in two shades that make the class's pattern.
fn colour(class: i32, i: usize, j: usize, period: usize) -> &'static str {
    let Ok(class) = usize::try_from(class) else { return UNCLASSED };
    let (i, j, half) = (i % period, j % period, period / 2);
    let marked = match class % 5 {
        0 => false,
        1 => (i + j) % period < half / 2 + 1,
        2 => i < half && j < half,
        3 => j < half / 2 + 1,
        _ => (i + period - j) % period < half / 2 + 1,
    };
    let list = if marked { &SHADES } else { &INKS };
    list[class % INKS.len()]
}
