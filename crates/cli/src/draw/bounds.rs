//! The range of the data that a panel shows.

use precess::figure::Panel;

use super::axis::LARGEST;
use super::map;

/// The smallest box around the points that can be drawn, `[x_lo, x_hi, y_lo, y_hi]`; a range that the panel asks for
/// takes the place of what its points need.
pub fn bounds(panel: &Panel) -> Option<[f64; 4]> {
    let curves = panel.curves.iter().flat_map(|c| c.x.iter().copied().zip(c.y.iter().copied()));
    let marks = panel.marks.iter().map(|m| (m.x, m.y));
    let corners = panel.map.iter().flat_map(|m| {
        let [a, b, c, d] = map::extent(m);
        [(a, c), (b, d)]
    });
    let within = |x: f64, range: Option<(f64, f64)>| range.is_none_or(|(low, high)| low <= x && x <= high);
    let asked = |&(x, y): &(f64, f64)| within(x, panel.x_range) && within(y, panel.y_range);
    let shown = curves.chain(marks).chain(corners).filter(|&(x, y)| drawable(panel, x, y)).filter(asked);
    let found = shown.fold(None, |seen, (x, y)| {
        let [a, b, c, d] = seen.unwrap_or([x, x, y, y]);
        Some([a.min(x), b.max(x), c.min(y), d.max(y)])
    });
    match (found, panel.x_range, panel.y_range) {
        (None, Some((a, b)), Some((c, d))) => Some([a, b, c, d]),
        (None, ..) => None,
        (Some([a, b, c, d]), x, y) => {
            let ((a, b), (c, d)) = (x.unwrap_or((a, b)), y.unwrap_or((c, d)));
            Some([a, b, c, d])
        }
    }
}

/// The point can appear in the panel.
pub fn drawable(panel: &Panel, x: f64, y: f64) -> bool {
    let usable = |v: f64| v.is_finite() && v.abs() <= LARGEST;
    usable(x) && usable(y) && (!panel.logarithmic || y > 0.0)
}

/// Every curve runs to the right: a function of time, whose axis needs no room at its ends.
pub fn runs_rightwards(panel: &Panel) -> bool {
    let rightwards = |xs: &[f64]| xs.iter().filter(|x| x.is_finite()).is_sorted();
    !panel.curves.is_empty() && panel.curves.iter().all(|c| rightwards(&c.x))
}

/// Below this, a number is zero for the eye and a difference is none.
const SMALLEST: f64 = 1e-300;

/// Zero for what is too small to be told from it.
pub fn flushed(v: f64) -> f64 {
    if v.abs() < SMALLEST { 0.0 } else { v }
}

/// A range with some air; a single value gets room on both sides, in proportion to itself.
pub fn airy(lo: f64, hi: f64, air: f64) -> (f64, f64) {
    let (lo, hi) = (flushed(lo), flushed(hi));
    let span = hi - lo;
    let room = if span > SMALLEST {
        air * span
    } else if lo == 0.0 {
        1.0
    } else {
        0.1 * lo.abs()
    };
    (lo - room, hi + room)
}

/// Both ranges widened about their middles until one unit takes as many pixels on either axis.
pub fn equalised(x: (f64, f64), y: (f64, f64), width: f64, height: f64) -> [f64; 4] {
    // A unit that the coordinates themselves cannot resolve would leave an axis without extent.
    let coarse = [x.0, x.1, y.0, y.1].into_iter().fold(0.0f64, |a, v| a.max(v.abs())) * 1e-14;
    let unit = ((x.1 - x.0) / width).max((y.1 - y.0) / height).max(coarse);
    let around = |(lo, hi): (f64, f64), pixels: f64| {
        let (middle, half) = (lo + 0.5 * (hi - lo), 0.5 * unit * pixels);
        (middle - half, middle + half)
    };
    let (x, y) = (around(x, width), around(y, height));
    [x.0, x.1, y.0, y.1]
}
