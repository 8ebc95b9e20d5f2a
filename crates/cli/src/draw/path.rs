//! Curves as short thinned paths; and what the library drew, tidied: lines sit on the pixels.

use kuva::render::render::{PathData, Primitive};
use precess::figure::Stroke;

use super::style::{CURVE, CURVE_DENSE, CURVE_THIN, INKS};
use super::text::quarter;
use super::thin::{Point, thinned};

/// Points that a curve of full width, and of the next one, may have after thinning.
const DENSE: [usize; 2] = [12_000, 40_000];

/// A curve through pixels; `None` where there is nothing of it.
pub fn path(points: &[Point], ink: usize, stroke: Stroke) -> Option<Primitive> {
    let runs = thinned(points);
    let count: usize = runs.iter().map(Vec::len).sum();
    let dots = runs.iter().all(|run| run.len() == 1);
    let stroke_width = match stroke {
        _ if dots => dot(count),
        Stroke::Thin => CURVE_THIN,
        _ => width(count),
    };
    let stroke_dasharray = if stroke == Stroke::Dashed { Some("5 4".to_owned()) } else { dashes(ink) };
    let (d, stroke) = (described(&runs), INKS[ink % INKS.len()].into());
    let path = PathData { d, fill: None, stroke, stroke_width, opacity: None, stroke_dasharray };
    (count > 0).then(|| Primitive::Path(Box::new(path)))
}

/// The inks come round again in dashes.
pub fn dashes(ink: usize) -> Option<String> {
    match ink / INKS.len() {
        0 => None,
        1 => Some("6 3".to_owned()),
        _ => Some("2 3".to_owned()),
    }
}

/// One primitive of an empty panel as it goes onto the page; clips fall away, for there is nothing to cut.
pub fn tidied(primitive: Primitive) -> Option<Primitive> {
    match primitive {
        Primitive::Line { x1, y1, x2, y2, stroke, stroke_width, stroke_dasharray } => {
            let [x1, y1, x2, y2] = [x1, y1, x2, y2].map(centre);
            Some(Primitive::Line { x1, y1, x2, y2, stroke, stroke_width, stroke_dasharray })
        }
        Primitive::Text { x, y, content, size, anchor, rotate, bold, color } => {
            let (x, y) = (quarter(x), quarter(y));
            Some(Primitive::Text { x, y, content, size, anchor, rotate, bold, color })
        }
        Primitive::ClipStart { .. } | Primitive::ClipEnd | Primitive::PolyLine { .. } => None,
        other => Some(other),
    }
}

/// The width of a curve with so many points.
fn width(count: usize) -> f64 {
    let [dense, denser] = DENSE.map(|limit| count > limit);
    if denser {
        CURVE_DENSE[1]
    } else if dense {
        CURVE_DENSE[0]
    } else {
        CURVE
    }
}

/// The diameter of the dots when no two points are joined, as in a section.
fn dot(count: usize) -> f64 {
    match count {
        0..=60 => 5.0,
        61..=3000 => 2.2,
        3001..=20_000 => 1.6,
        _ => 1.1,
    }
}

/// The middle of a pixel, where a line of one pixel is sharp.
fn centre(v: f64) -> f64 {
    v.floor() + 0.5
}

/// SVG path data with two decimals; a lone point becomes a dot under its round caps.
fn described(runs: &[Vec<Point>]) -> String {
    let mut d = String::new();
    for run in runs {
        for (i, &(x, y)) in run.iter().enumerate() {
            d.push(if i == 0 { 'M' } else { 'L' });
            push(&mut d, x);
            d.push(' ');
            push(&mut d, y);
        }
        if run.len() == 1 {
            d.push_str("h.01");
        }
    }
    d
}

/// Appends hundredths, without idle zeros.
fn push(d: &mut String, v: f64) {
    let text = format!("{v:.2}");
    d.push_str(text.trim_end_matches('0').trim_end_matches('.'));
}
