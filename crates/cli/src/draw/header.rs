//! What stands above a box: title of the panel, label of its vertical axis, names of the curves.
//!
//! The label of the vertical axis lies flat, where it reads without turning the head; the names
//! share its line, outside the box, so that they never hide a curve.

use kuva::render::render::{Primitive, Scene, TextAnchor};
use precess::figure::{Panel, Stroke};

use super::map;
use super::path::dashes;
use super::style::{INK, INKS, LABEL, PANEL_TITLE, SOFT};
use super::text::{clean, fitting, line, width};

const TITLE_LINE: f64 = 23.0;
const LINE: f64 = 18.0;
const GAP: f64 = 7.0;
/// Length of the stroke before a name, and what is left free around the name.
const STROKE: f64 = 18.0;
const AROUND: f64 = 24.0;
/// Lines of names at most; the rest is counted.
const LINES: usize = 4;

/// How a name is shown.
#[derive(Clone, Debug, PartialEq)]
enum Sample {
    Line {
        dashes: Option<String>,
    },
    Dots,
    /// A class of a map: its colour and pattern.
    Patch,
}

/// What a colour stands for.
#[derive(Clone, Debug, PartialEq)]
struct Name {
    ink: usize,
    sample: Sample,
    text: String,
}

/// The lines above one box.
pub struct Header {
    title: String,
    label: String,
    /// Names by line; the first line stands beside the label where it fits.
    names: Vec<Vec<Name>>,
    beside: bool,
    left: f64,
    right: f64,
}

impl Header {
    /// The header of a panel between `left` and `right`, its label completed by `note`.
    pub fn new(panel: &Panel, note: &str, left: f64, right: f64) -> Self {
        let label = clean(&format!("{}{note}", panel.y_label));
        let room = right - left;
        let named = named(panel);
        let total: f64 = named.iter().map(|name| extent(&name.text)).sum();
        let beside = total + width(&label, LABEL) + AROUND <= room;
        let names = if named.is_empty() { Vec::new() } else { lines(named, room) };
        Self { title: clean(&panel.title), label, names, beside, left, right }
    }

    /// Pixels from the top of the title to the box.
    pub fn height(&self) -> f64 {
        let title = if self.title.is_empty() { 0.0 } else { TITLE_LINE };
        let bare = self.label.is_empty() && (self.names.is_empty() || !self.beside);
        let label = if bare { 0.0 } else { LINE };
        title + label + LINE * self.own_lines() as f64 + GAP
    }

    fn own_lines(&self) -> usize {
        if self.beside { 0 } else { self.names.len() }
    }

    /// Draws the lines so that the title hangs from `top` and the others stand on the box at `bottom`.
    pub fn draw(&self, scene: &mut Scene, top: f64, bottom: f64) {
        let room = self.right - self.left;
        if !self.title.is_empty() {
            let size = fitting(&self.title, PANEL_TITLE, room);
            scene.add(line(self.left, top + 14.0, &self.title, size, TextAnchor::Start, INK));
        }
        let first = bottom - GAP - LINE * self.own_lines() as f64 - 4.0;
        if !self.label.is_empty() {
            let size = fitting(&self.label, LABEL, room);
            scene.add(line(self.left, first, &self.label, size, TextAnchor::Start, SOFT));
        }
        for (i, names) in self.names.iter().enumerate() {
            let down = if self.beside { 0.0 } else { LINE * (i + 1) as f64 };
            let total: f64 = names.iter().map(|name| extent(&name.text)).sum::<f64>() - AROUND;
            let start = if self.beside { self.right - total } else { self.left };
            draw_names(scene, names, start, first + down);
        }
    }
}

/// Each name once, where there is more than one thing to tell apart.
fn named(panel: &Panel) -> Vec<Name> {
    let mut all: Vec<Name> = Vec::new();
    let curves = panel.curves.iter().enumerate().map(|(index, curve)| {
        let ink = curve.ink.unwrap_or(index);
        let broken = (curve.stroke == Stroke::Dashed).then(|| "5 4".to_owned());
        let sample = match curve.stroke {
            Stroke::Dots => Sample::Dots,
            _ => Sample::Line { dashes: broken.or_else(|| dashes(ink)) },
        };
        Name { ink, sample, text: clean(&curve.label) }
    });
    let classes = panel.map.iter().flat_map(|map| map.names.iter().enumerate());
    let classes = classes.map(|(ink, name)| Name { ink, sample: Sample::Patch, text: clean(name) });
    for name in classes.chain(curves).filter(|name| !name.text.is_empty()) {
        if !all.contains(&name) {
            all.push(name);
        }
    }
    let things = panel.curves.len() + panel.map.as_ref().map_or(0, |map| map.names.len());
    if things > 1 { all } else { Vec::new() }
}

/// Pixels of one name with its stroke and the space after it.
fn extent(name: &str) -> f64 {
    STROKE + 6.0 + width(name, LABEL) + AROUND
}

/// Names filled into lines; what exceeds the last one is counted there.
fn lines(named: Vec<Name>, room: f64) -> Vec<Vec<Name>> {
    let (count, mut used) = (named.len(), 0.0);
    let mut lines: Vec<Vec<Name>> = Vec::new();
    for name in named {
        let wide = extent(&name.text);
        let full = lines.len() == LINES;
        match lines.last_mut() {
            Some(line) if used + wide <= room + AROUND => line.push(name),
            _ if full => break,
            _ => {
                lines.push(vec![name]);
                used = 0.0;
            }
        }
        used += wide;
    }
    let shown: usize = lines.iter().map(Vec::len).sum();
    if shown < count
        && let Some(name) = lines.last_mut().and_then(|l| l.last_mut())
    {
        name.text = format!("and {} more", count - shown + 1);
    }
    lines
}

fn draw_names(scene: &mut Scene, names: &[Name], start: f64, base: f64) {
    let mut x = start;
    for name in names {
        let (y, colour) = (base - 4.0, INKS[name.ink % INKS.len()]);
        match &name.sample {
            Sample::Patch => {
                let class = i32::try_from(name.ink).unwrap_or(i32::MAX);
                map::swatch(scene, class, (x.round(), (y - 0.5 * map::SWATCH.1).round()));
            }
            Sample::Dots => scene.add(Primitive::Circle {
                cx: x.round() + STROKE - 5.0,
                cy: y,
                r: 3.0,
                fill: colour.into(),
                fill_opacity: None,
                stroke: None,
                stroke_width: None,
            }),
            Sample::Line { dashes } => scene.add(Primitive::Line {
                x1: x.round(),
                y1: y,
                x2: x.round() + STROKE,
                y2: y,
                stroke: colour.into(),
                stroke_width: 2.0,
                stroke_dasharray: dashes.clone(),
            }),
        }
        scene.add(line(x + STROKE + 6.0, base, &name.text, LABEL, TextAnchor::Start, INK));
        x += extent(&name.text);
    }
}
