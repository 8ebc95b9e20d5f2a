//! One panel: the library draws axes, grid and curves; marks and labels are set beside them.

use kuva::TickFormat;
use kuva::plot::LinePlot;
use kuva::render::layout::{ComputedLayout, Layout};
use kuva::render::plots::Plot;
use kuva::render::render::{Primitive, Scene, TextAnchor, render_multiple};
use precess::figure::{Mark, Sign, Stroke};
use std::sync::Arc;

use super::axis::Axis;
use super::bounds::drawable;
use super::clip::clipped;
use super::layout::Placed;
use super::map;
use super::path::{path, tidied};
use super::style::{INK, INKS, LABEL, PAPER, SOFT, TICK, theme};
use super::text::{clean, fitting, line, width};
use super::thin::Point;

/// Draws the panel in its place on a page of the given size.
pub fn draw(scene: &mut Scene, placed: &Placed, page: (f64, f64)) {
    let frame = placed.frame;
    let layout = layout(placed, page);
    let computed = ComputedLayout::from_layout(&layout);
    // The library draws no axes without a plot; the curves are ours.
    for primitive in render_multiple(vec![Plot::Line(LinePlot::new())], layout).elements {
        if let Some(primitive) = tidied(primitive) {
            scene.add(primitive);
        }
    }
    if let Some(map) = &placed.panel.map {
        map::draw(scene, map, placed);
    }
    curves(scene, placed, &computed);
    marks(scene, placed, &computed);
    placed.header.draw(scene, placed.top, frame.y);
    let label = clean(&format!("{}{}", placed.panel.x_label, placed.axes.x.note()));
    let (middle, below) = (frame.x + 0.5 * frame.wide, frame.y + frame.high);
    if !label.is_empty() {
        let size = fitting(&label, LABEL, frame.wide);
        scene.add(line(middle, below + 36.0, &label, size, TextAnchor::Middle, SOFT));
    }
    if !placed.axes.filled {
        scene.add(line(middle, below - 0.5 * frame.high, "no data", LABEL, TextAnchor::Middle, SOFT));
    }
}

/// The library's layout: exact ranges, steps and margins, and our words at the ticks.
fn layout(placed: &Placed, page: (f64, f64)) -> Layout {
    let (frame, x, y) = (placed.frame, &placed.axes.x, &placed.axes.y);
    let words = |axis: &Axis| {
        let axis = axis.clone();
        TickFormat::Custom(Arc::new(move |t| axis.label(t)))
    };
    Layout::new((x.lo, x.hi), (y.lo, y.hi))
        .with_width(page.0)
        .with_height(page.1)
        .with_force_margins(frame.x, page.0 - frame.x - frame.wide)
        .with_force_margins_y(frame.y, page.1 - frame.y - frame.high)
        .with_x_axis_min(x.lo)
        .with_x_axis_max(x.hi)
        .with_y_axis_min(y.lo)
        .with_y_axis_max(y.hi)
        .with_x_tick_step(x.step)
        .with_y_tick_step(y.step)
        .with_x_tick_format(words(x))
        .with_y_tick_format(words(y))
        .with_tick_size(TICK)
        .with_tick_length(4.0)
        .with_theme(theme())
}

/// The curves, thinned and cut off at the box. Joints and ends are round: a sharp turn must not throw a spike.
fn curves(scene: &mut Scene, placed: &Placed, computed: &ComputedLayout) {
    let (panel, x, y) = (placed.panel, &placed.axes.x, &placed.axes.y);
    let ranged = panel.x_range.is_some() || panel.y_range.is_some();
    for (index, curve) in panel.curves.iter().enumerate() {
        let pixel = |(&a, &b): (&f64, &f64)| {
            if drawable(panel, a, b) {
                (computed.map_x(x.local(a)), computed.map_y(y.local(b)))
            } else {
                (f64::NAN, f64::NAN)
            }
        };
        let mut points: Vec<Point> = curve.x.iter().zip(&curve.y).map(pixel).collect();
        if curve.stroke == Stroke::Dots {
            points = points.into_iter().flat_map(|p| [p, (f64::NAN, f64::NAN)]).collect();
        }
        if ranged {
            points = clipped(&points, &placed.frame);
        }
        let Some(path) = path(&points, curve.ink.unwrap_or(index), curve.stroke) else { continue };
        let round = Some(r#"stroke-linejoin="round" stroke-linecap="round""#.to_owned());
        scene.add(Primitive::GroupStart { transform: None, title: None, extra_attrs: round });
        scene.add(path);
        scene.add(Primitive::GroupEnd);
    }
}

/// Marked points, each with its text on the side where there is room; where there is none beside the other texts, the sign
/// alone.
fn marks(scene: &mut Scene, placed: &Placed, computed: &ComputedLayout) {
    let (frame, panel) = (placed.frame, placed.panel);
    let mut taken: Vec<[f64; 4]> = vec![];
    for mark in panel.marks.iter().filter(|m| drawable(panel, m.x, m.y)) {
        let cx = computed.map_x(placed.axes.x.local(mark.x));
        let cy = computed.map_y(placed.axes.y.local(mark.y));
        let across = frame.x - 0.5..=frame.x + frame.wide + 0.5;
        let up = frame.y - 0.5..=frame.y + frame.high + 0.5;
        if !(across.contains(&cx) && up.contains(&cy)) {
            continue;
        }
        sign(scene, mark, (cx, cy));
        let text = clean(&mark.label);
        if text.is_empty() {
            continue;
        }
        let wide = width(&text, TICK);
        let sides = [(8.0, -7.0), (-8.0 - wide, -7.0), (8.0, 15.0), (-8.0 - wide, 15.0)];
        let places = sides.map(|(right, down)| {
            let (x, y) = (cx + right, cy + down);
            ([x, x + wide, y - 9.0, y + 3.0], (x, y))
        });
        let free = || places.iter().filter(|(own, _)| !taken.iter().any(|other| overlap(own, other)));
        let inside =
            |own: &[f64; 4]| own[0] >= frame.x && own[1] <= frame.x + frame.wide && own[2] >= frame.y;
        let best = free().find(|(own, _)| inside(own)).or_else(|| free().next());
        if let Some(&(own, (x, y))) = best {
            taken.push(own);
            scene.add(line(x, y, &text, TICK, TextAnchor::Start, INK));
        }
    }
}

/// Whether two boxes (left, right, top, bottom) have anything in common.
fn overlap(a: &[f64; 4], b: &[f64; 4]) -> bool {
    a[0] < b[1] && b[0] < a[1] && a[2] < b[3] && b[2] < a[3]
}

/// The shape of a mark.
fn sign(scene: &mut Scene, mark: &Mark, (cx, cy): Point) {
    let ink = mark.ink.map_or(INK, |k| INKS[k % INKS.len()]);
    let mut circle = |r: f64, fill: &str, edge: &str, stroke_width: f64| {
        scene.add(Primitive::Circle {
            cx,
            cy,
            r,
            fill: fill.into(),
            fill_opacity: None,
            stroke: Some(edge.into()),
            stroke_width: Some(stroke_width),
        });
    };
    match mark.sign {
        Sign::Dot => circle(4.0, ink, PAPER, 1.5),
        Sign::Ring => circle(4.0, PAPER, ink, 1.8),
        Sign::Ball => circle(8.0, ink, PAPER, 1.5),
        Sign::Cross => {
            for side in [1.0, -1.0] {
                scene.add(Primitive::Line {
                    x1: cx - 4.5,
                    y1: cy - 4.5 * side,
                    x2: cx + 4.5,
                    y2: cy + 4.5 * side,
                    stroke: ink.into(),
                    stroke_width: 2.2,
                    stroke_dasharray: None,
                });
            }
        }
    }
}
