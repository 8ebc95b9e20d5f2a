//! Letters: the embedded face, its widths, and text that is safe to write.

use kuva::render::render::{Primitive, TextAnchor, TextSpan};
use resvg::usvg::fontdb;
use skrifa::MetadataProvider;
use skrifa::instance::{LocationRef, Size};

/// The embedded face: `DejaVu`, under its free licence. It has Greek, superscripts and dots.
pub fn face() -> &'static [u8] {
    dejavu::sans_condensed::regular()
}

/// A database with that face alone, whatever the machine has.
pub fn database() -> fontdb::Database {
    let mut database = fontdb::Database::new();
    database.load_font_data(face().to_vec());
    let name = database.faces().next().and_then(|f| f.families.first()).map(|f| f.0.clone());
    if let Some(name) = name {
        database.set_sans_serif_family(name);
    }
    database
}

/// Width in pixels of a line set in `size`.
pub fn width(text: &str, size: u32) -> f64 {
    let Ok(font) = skrifa::FontRef::new(face()) else {
        return 0.6 * f64::from(size) * text.chars().count() as f64;
    };
    let letters = font.charmap();
    let metrics = font.glyph_metrics(Size::new(size as f32), LocationRef::default());
    let advance = |c| letters.map(c).and_then(|glyph| metrics.advance_width(glyph)).map_or(0.0, f64::from);
    text.chars().map(advance).sum()
}

/// The embedded face has the letter.
#[cfg(test)]
pub fn has(c: char) -> bool {
    skrifa::FontRef::new(face()).is_ok_and(|font| font.charmap().map(c).is_some())
}

/// Without the control characters that XML forbids; line ends become spaces.
pub fn clean(text: &str) -> String {
    text.chars().map(|c| if c.is_whitespace() { ' ' } else { c }).filter(|&c| writable(c)).collect()
}

/// XML allows the character, and no control lurks in it.
pub fn writable(c: char) -> bool {
    (!c.is_control() || c == '\n' || c == '\t' || c == '\r') && !matches!(c, '\u{fffe}' | '\u{ffff}')
}

/// The largest size up to `size`, and not below 8, at which the text fits.
pub fn fitting(text: &str, size: u32, room: f64) -> u32 {
    (8..=size).rev().find(|&s| width(text, s) <= room).unwrap_or(8)
}

/// The words of a text in lines of at most `room` pixels.
pub fn wrap(text: &str, size: u32, room: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in clean(text).split(' ').filter(|w| !w.is_empty()) {
        match lines.last_mut() {
            Some(line) if width(&format!("{line} {word}"), size) <= room => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// A line of text as the library's primitive. The rich kind takes every letter as it is, where the
/// plain kind reads mathematics between dollar signs.
pub fn line(x: f64, y: f64, text: &str, size: u32, anchor: TextAnchor, colour: &str) -> Primitive {
    let span = TextSpan {
        text: clean(text),
        bold: false,
        italic: false,
        underline: false,
        code: false,
        math: false,
    };
    Primitive::RichText {
        x: quarter(x),
        y: quarter(y),
        spans: vec![span],
        size,
        anchor,
        color: Some(colour.into()),
    }
}

/// Quarters of a pixel: exact in binary, so that they are written short.
pub fn quarter(v: f64) -> f64 {
    (v * 4.0).round() / 4.0
}
