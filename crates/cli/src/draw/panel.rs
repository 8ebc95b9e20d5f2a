//! One panel: the library draws axes, grid and curves; marks and labels are set beside them.

use kuva::TickFormat;
use kuva::plot::LinePlot;
use kuva::plot::line::LineStyle;
use kuva::render::layout::{ComputedLayout, Layout};
use kuva::render::plots::Plot;
use kuva::render::render::{Primitive, Scene, TextAnchor, render_multiple};
use std::sync::Arc;

use super::axis::Axis;
use super::bounds::drawable;
use super::layout::Placed;
use super::path::tidied;
use super::style::{INK, INKS, LABEL, PAPER, SOFT, TICK, theme};
use super::text::{clean, fitting, line, width};

/// Draws the panel in its place on a page of the given size.
pub fn draw(scene: &mut Scene, placed: &Placed, page: (f64, f64)) {
    let frame = placed.frame;
    let layout = layout(placed, page);
    let computed = ComputedLayout::from_layout(&layout);
    // Joints and ends of curves are round: a sharp turn must not throw a spike.
    let round = Some(r#"stroke-linejoin="round" stroke-linecap="round""#.to_owned());
    for primitive in render_multiple(plots(placed), layout).elements {
        let curve = matches!(primitive, Primitive::PolyLine { .. });
        let Some(primitive) = tidied(primitive) else { continue };
        if curve {
            scene.add(Primitive::GroupStart { transform: None, title: None, extra_attrs: round.clone() });
        }
        scene.add(primitive);
        if curve {
            scene.add(Primitive::GroupEnd);
        }
    }
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

/// The curves in local numbers; at least one, for the library draws no axes without.
fn plots(placed: &Placed) -> Vec<Plot> {
    let (panel, x, y) = (placed.panel, &placed.axes.x, &placed.axes.y);
    let mut plots: Vec<Plot> = Vec::new();
    for (index, curve) in panel.curves.iter().enumerate() {
        let local = |(&a, &b): (&f64, &f64)| {
            if drawable(panel, a, b) { (x.local(a), y.local(b)) } else { (f64::NAN, f64::NAN) }
        };
        let mut points: Vec<(f64, f64)> = curve.x.iter().zip(&curve.y).map(local).collect();
        if let [single] = points[..] {
            points.push(single); // The library leaves a lone point out.
        }
        let line = LinePlot::new().with_data(points).with_color(INKS[index % INKS.len()]);
        let style = dashes(index).map_or(LineStyle::Solid, LineStyle::Custom);
        plots.push(Plot::Line(line.with_line_style(style)));
    }
    if plots.is_empty() {
        plots.push(Plot::Line(LinePlot::new()));
    }
    plots
}

/// The inks come round again in dashes.
pub fn dashes(index: usize) -> Option<String> {
    match index / INKS.len() {
        0 => None,
        1 => Some("6 3".to_owned()),
        _ => Some("2 3".to_owned()),
    }
}

/// Marked points, each a ringed dot with its text on the side where there is room.
fn marks(scene: &mut Scene, placed: &Placed, computed: &ComputedLayout) {
    let (frame, panel) = (placed.frame, placed.panel);
    for mark in panel.marks.iter().filter(|m| drawable(panel, m.x, m.y)) {
        let cx = computed.map_x(placed.axes.x.local(mark.x));
        let cy = computed.map_y(placed.axes.y.local(mark.y));
        scene.add(Primitive::Circle {
            cx,
            cy,
            r: 4.0,
            fill: INK.into(),
            fill_opacity: None,
            stroke: Some(PAPER.into()),
            stroke_width: Some(1.5),
        });
        let text = clean(&mark.label);
        if text.is_empty() {
            continue;
        }
        let outward = cx + 8.0 + width(&text, TICK) > frame.x + frame.wide;
        let (x, anchor) = if outward { (cx - 8.0, TextAnchor::End) } else { (cx + 8.0, TextAnchor::Start) };
        let y = if cy - 16.0 < frame.y { cy + 15.0 } else { cy - 7.0 };
        scene.add(line(x, y, &text, TICK, anchor, INK));
    }
}
