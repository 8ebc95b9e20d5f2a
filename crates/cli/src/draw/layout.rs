//! Where everything stands: planes side by side, functions of time below each other.

use precess::figure::{Figure, Panel};

use super::axes::{Axes, axes, left_room, shape};
use super::header::Header;
use super::style::{FOOT, GUTTER, MARGIN, PAGE, PAGE_PLANE, ROW_GAP};

/// The rectangle between the axes.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    /// Left edge.
    pub x: f64,
    /// Upper edge.
    pub y: f64,
    /// Width.
    pub wide: f64,
    /// Height.
    pub high: f64,
}

/// A panel in its place.
pub struct Placed<'a> {
    /// What it shows.
    pub panel: &'a Panel,
    /// Its box.
    pub frame: Frame,
    /// Its axes.
    pub axes: Axes,
    /// Its lines above the box.
    pub header: Header,
    /// Where the title hangs.
    pub top: f64,
}

/// The page without its heading.
pub struct Sheet<'a> {
    /// Width of the page.
    pub width: f64,
    /// Lower end of the last row.
    pub bottom: f64,
    /// The panels in reading order.
    pub placed: Vec<Placed<'a>>,
}

/// Width of the page.
pub fn page_width(figure: &Figure) -> f64 {
    match &figure.panels[..] {
        [one] if one.equal_scales => PAGE_PLANE,
        _ => PAGE,
    }
}

/// Side by side as soon as a plane is among the panels, or when there are too many to stack.
fn columns(panels: &[Panel]) -> usize {
    match panels.len() {
        0 | 1 => 1,
        n if n > 8 => 3,
        n if n > 4 || panels.iter().any(|p| p.equal_scales) => 2,
        _ => 1,
    }
}

/// Height of the boxes in a row.
fn height(row: &[Panel], columns: usize, total: usize, wide: f64) -> f64 {
    let plain = match (columns, total) {
        (1, 1) => 430.0,
        (1, 2) => 230.0,
        (1, _) => 165.0,
        (2, _) => 220.0,
        _ => 170.0,
    };
    let plane = |p: &&Panel| p.equal_scales && !p.logarithmic;
    row.iter().filter(plane).map(|p| (wide * shape(p)).round()).fold(plain, f64::max)
}

/// Places all panels below `top`.
pub fn sheet(figure: &Figure, top: f64) -> Sheet<'_> {
    let (panels, width) = (&figure.panels[..], page_width(figure));
    let count = columns(panels);
    let cell = ((width - 2.0 * MARGIN - GUTTER * (count - 1) as f64) / count as f64).floor();
    let guess = cell - 52.0;
    let heights: Vec<f64> = panels.chunks(count).map(|row| height(row, count, panels.len(), guess)).collect();
    let rooms = rooms(panels, count, guess, &heights);
    let mut sheet = Sheet { width, bottom: top, placed: Vec::new() };
    for (row, &high) in panels.chunks(count).zip(&heights) {
        place_row(&mut sheet, row, cell, high, &rooms);
    }
    sheet.bottom -= if panels.is_empty() { 0.0 } else { ROW_GAP };
    sheet
}

/// Room for the numbers left of each column's boxes, so that boxes stand below each other.
fn rooms(panels: &[Panel], count: usize, wide: f64, heights: &[f64]) -> Vec<f64> {
    let mut rooms = vec![0.0f64; count];
    for (i, panel) in panels.iter().enumerate() {
        let needed = left_room(&axes(panel, wide, heights[i / count]));
        rooms[i % count] = rooms[i % count].max(needed);
    }
    rooms
}

/// One row: boxes of equal height on one line.
fn place_row<'a>(sheet: &mut Sheet<'a>, row: &'a [Panel], cell: f64, high: f64, rooms: &[f64]) {
    let top = sheet.bottom;
    let mut placed: Vec<Placed<'a>> = Vec::new();
    for (column, panel) in row.iter().enumerate() {
        let left = MARGIN + column as f64 * (cell + GUTTER);
        let (x, wide) = (left + rooms[column], cell - rooms[column]);
        let axes = axes(panel, wide, high);
        let header = Header::new(panel, &axes.y.note(), left, left + cell);
        let frame = Frame { x, y: top, wide, high };
        placed.push(Placed { panel, frame, axes, header, top });
    }
    let header = placed.iter().map(|p| p.header.height()).fold(0.0, f64::max);
    for one in &mut placed {
        one.frame.y = top + header;
    }
    sheet.placed.extend(placed);
    sheet.bottom = top + header + high + FOOT + ROW_GAP;
}
