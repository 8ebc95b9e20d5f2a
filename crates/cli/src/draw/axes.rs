//! The two axes of a panel, for a box of given size.

use precess::figure::Panel;

use super::axis::Axis;
use super::bounds::{airy, bounds, equalised, flushed, runs_rightwards};
use super::style::TICK;
use super::text::width;

/// Pixels that one interval of a horizontal axis should about have.
const PITCH: f64 = 64.0;
/// And those of a plane.
const PITCH_PLANE: f64 = 50.0;

/// The axes of a panel.
#[derive(Clone, Debug)]
pub struct Axes {
    /// Horizontal.
    pub x: Axis,
    /// Vertical.
    pub y: Axis,
    /// There is at least one point to show.
    pub filled: bool,
}

/// Ranges, ticks and steps of a panel in a box of `wide` by `high` pixels.
pub fn axes(panel: &Panel, wide: f64, high: f64) -> Axes {
    let found = bounds(panel);
    if panel.equal_scales && !panel.logarithmic {
        return plane(panel, found, wide, high);
    }
    let [a, b, c, d] = found.unwrap_or([0.0, 1.0, if panel.logarithmic { 1.0 } else { 0.0 }, 1.0]);
    let exact = panel.x_range.is_some() || runs_rightwards(panel) || panel.map.is_some();
    let (a, b) = airy(a, b, if exact { 0.0 } else { 0.04 });
    let mut x = Axis::linear(a, b, wide / PITCH);
    x.spread(wide, |s| width(s, TICK));
    let y = if panel.logarithmic {
        Axis::decades(c, d, (high / 26.0).max(2.0))
    } else {
        let exact = panel.y_range.is_some() || panel.map.is_some();
        let (c, d) = airy(c, d, if exact { 0.0 } else { 0.07 });
        Axis::linear(c, d, high / (28.0 + high / 25.0))
    };
    Axes { x, y, filled: found.is_some() }
}

/// Equal scales: both ranges grow to the shape of the box, and the grid is of squares.
fn plane(panel: &Panel, found: Option<[f64; 4]>, wide: f64, high: f64) -> Axes {
    let [x, y] = extents(panel, found);
    let [a, b, c, d] = equalised(x, y, wide, high);
    let mut x = Axis::linear(a, b, wide / PITCH_PLANE);
    x.spread(wide, |s| width(s, TICK));
    let mut y = Axis::linear(c, d, high / PITCH_PLANE);
    if x.note().is_empty() && y.note().is_empty() {
        y.step = y.local(x.value(x.step));
    }
    Axes { x, y, filled: found.is_some() }
}

/// The ranges of a plane, with air; a line or a point gets a neighbourhood.
fn extents(panel: &Panel, found: Option<[f64; 4]>) -> [(f64, f64); 2] {
    let [a, b, c, d] = found.unwrap_or([-1.0, 1.0, -1.0, 1.0]).map(flushed);
    if b > a || d > c {
        let exact = panel.map.is_some() || panel.x_range.is_some() && panel.y_range.is_some();
        let air = if exact { 0.0 } else { 0.06 * (b - a).max(d - c) };
        return [(a - air, b + air), (c - air, d + air)];
    }
    [airy(a, b, 0.0), airy(c, d, 0.0)]
}

/// Height over width of the data of a plane, within what suits a page.
pub fn shape(panel: &Panel) -> f64 {
    let [x, y] = extents(panel, bounds(panel));
    let shape = (y.1 - y.0) / (x.1 - x.0);
    if shape.is_finite() { shape.clamp(0.5, 1.0) } else { 1.0 }
}

/// Room that the numbers left of the vertical axis take.
pub fn left_room(axes: &Axes) -> f64 {
    axes.y.ticks().iter().map(|&t| width(&axes.y.label(t), TICK)).fold(0.0, f64::max).ceil() + 12.0
}
