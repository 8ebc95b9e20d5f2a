//! Paper and ink: every colour and size of the drawing.

use kuva::render::theme::Theme;

/// The sheet.
pub const PAPER: &str = "#fbf9f4";
/// Titles and marks.
pub const INK: &str = "#23262b";
/// Labels of axes and ticks.
pub const SOFT: &str = "#565a61";
/// Axis lines.
pub const AXIS: &str = "#6f7278";
/// Grid lines.
pub const GRID: &str = "#e9e4d8";

/// Eight inks that stay apart for colour-blind eyes: hue and lightness both alternate.
pub const INKS: [&str; 8] =
    ["#1d4e80", "#c4512d", "#1f8a70", "#d39a1c", "#8a5a9e", "#5a9fc7", "#5a3a22", "#85878c"];

/// The same inks lighter: the second shade of a pattern.
pub const SHADES: [&str; 8] =
    ["#7c9cbd", "#e3a48f", "#83c2b1", "#ecd08c", "#c3a9cf", "#b5d6e6", "#a48f82", "#bfc0c4"];

/// What belongs to no class.
pub const UNCLASSED: &str = "#f1eee7";

/// Families a viewer may have; all nearly as narrow as the embedded face the page is measured with.
pub const FAMILY: &str = "DejaVu Sans Condensed, Helvetica Neue, Helvetica, Arial, DejaVu Sans, sans-serif";

/// Width of the page; a single plane of equal scales takes a narrower one.
pub const PAGE: f64 = 960.0;
/// Width of the page for a single plane.
pub const PAGE_PLANE: f64 = 720.0;
/// White border.
pub const MARGIN: f64 = 36.0;
/// Between two columns.
pub const GUTTER: f64 = 40.0;
/// Between two rows.
pub const ROW_GAP: f64 = 20.0;
/// Ticks, their labels and the label of the axis, below a box.
pub const FOOT: f64 = 40.0;

/// Sizes of letters.
pub const TITLE: u32 = 20;
/// Subtitle of the page.
pub const SUBTITLE: u32 = 12;
/// Title of a panel.
pub const PANEL_TITLE: u32 = 14;
/// Labels of axes and curves.
pub const LABEL: u32 = 12;
/// Numbers at the ticks.
pub const TICK: u32 = 11;

/// Width of a curve.
pub const CURVE: f64 = 1.5;
/// Width of a curve of which there are many.
pub const CURVE_THIN: f64 = 0.55;
/// Width of a curve with so many points that it would become a blot, and with still more.
pub const CURVE_DENSE: [f64; 2] = [0.8, 0.5];

/// The library's theme with these colours.
pub fn theme() -> Theme {
    Theme {
        background: PAPER.into(),
        axis_color: AXIS.into(),
        grid_color: GRID.into(),
        tick_color: AXIS.into(),
        text_color: SOFT.into(),
        font_family: Some(FAMILY.into()),
        ..Theme::light()
    }
}
