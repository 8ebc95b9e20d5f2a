//! Curves cut off where the box ends (Liang and Barsky 1984).

use super::layout::Frame;
use super::thin::Point;

/// The parts of a curve inside the box, with a gap where it leaves and comes back.
pub fn clipped(points: &[Point], frame: &Frame) -> Vec<Point> {
    let mut kept: Vec<Point> = Vec::new();
    let inside = |p: &Point| {
        p.0 >= frame.x && p.0 <= frame.x + frame.wide && p.1 >= frame.y && p.1 <= frame.y + frame.high
    };
    if let [point] = points {
        return if inside(point) { vec![*point] } else { kept };
    }
    for pair in points.windows(2) {
        match segment(pair[0], pair[1], frame) {
            Some((from, to)) => {
                if kept.last() != Some(&from) {
                    kept.extend([(f64::NAN, f64::NAN), from]);
                }
                kept.push(to);
            }
            // A lone point between two gaps is one all the same.
            None if inside(&pair[0]) && kept.last() != Some(&pair[0]) => {
                kept.extend([(f64::NAN, f64::NAN), pair[0]]);
            }
            None => {}
        }
    }
    kept
}

/// The part of a segment inside the box.
fn segment(a: Point, b: Point, frame: &Frame) -> Option<(Point, Point)> {
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    if !(dx.is_finite() && dy.is_finite()) {
        return None;
    }
    let (mut enters, mut leaves) = (0.0_f64, 1.0_f64);
    let sides = [
        (-dx, a.0 - frame.x),
        (dx, frame.x + frame.wide - a.0),
        (-dy, a.1 - frame.y),
        (dy, frame.y + frame.high - a.1),
    ];
    for (towards, room) in sides {
        if towards == 0.0 {
            if room < 0.0 {
                return None;
            }
        } else if towards < 0.0 {
            enters = enters.max(room / towards);
        } else {
            leaves = leaves.min(room / towards);
        }
    }
    let at = |s: f64| match s {
        0.0 => a,
        1.0 => b,
        s => (a.0 + s * dx, a.1 + s * dy),
    };
    (enters <= leaves).then(|| (at(enters), at(leaves)))
}
