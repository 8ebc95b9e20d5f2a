//! The SVG in pixels, with an embedded font, and the scenario in a text chunk.

use std::sync::Arc;

use precess::figure::Figure;
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree};

use super::page::svg;
use super::text::{database, writable};

/// Pixels per unit of the page: sharp on a dense screen and in print.
pub const SCALE: f32 = 2.0;

/// Keyword of the chunk that carries the scenario.
pub const KEYWORD: &str = "precess-scenario";

/// The figure as a PNG, twice as many pixels wide and high as the SVG has units.
///
/// # Errors
///
/// Says what the rasteriser or the encoder refused.
pub fn png(figure: &Figure) -> Result<Vec<u8>, String> {
    let options = Options { fontdb: Arc::new(database()), ..Options::default() };
    let tree = Tree::from_str(&svg(figure), &options).map_err(|e| e.to_string())?;
    let size = tree.size();
    let (wide, high) = ((size.width() * SCALE).ceil() as u32, (size.height() * SCALE).ceil() as u32);
    let mut pixels = Pixmap::new(wide, high).ok_or("the picture has no size")?;
    resvg::render(&tree, Transform::from_scale(SCALE, SCALE), &mut pixels.as_mut());
    encoded(&pixels, &figure.scenario).map_err(|e| e.to_string())
}

/// The paper is opaque, so three channels suffice.
fn encoded(pixels: &Pixmap, scenario: &str) -> Result<Vec<u8>, png::EncodingError> {
    let colours: Vec<u8> = pixels.data().chunks_exact(4).flat_map(|p| [p[0], p[1], p[2]]).collect();
    let scenario = scenario.chars().filter(|&c| writable(c)).collect();
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, pixels.width(), pixels.height());
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.add_itxt_chunk(KEYWORD.to_owned(), scenario)?;
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&colours)?;
    writer.finish()?;
    Ok(bytes)
}
