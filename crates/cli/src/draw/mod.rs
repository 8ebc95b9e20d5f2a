//! Figures as pictures: SVG through the plotting library, PNG from that same SVG.
//!
//! `kuva` draws axes, grids, ticks and curves and writes the SVG; `resvg` turns it into pixels with
//! an embedded font, so that a machine without any font shows every letter. What is ours is the
//! page: where the panels stand, which numbers an axis shows, how many points a pixel deserves.
#![allow(clippy::disallowed_methods)] // Pixels are not results: the platform's mathematics will do.

mod axes;
mod axis;
mod bounds;
mod clip;
mod header;
mod layout;
mod map;
mod number;
mod page;
mod panel;
mod path;
mod png;
mod style;
mod text;
mod thin;

#[cfg(test)]
mod tests;

pub use self::png::png;
pub use page::svg;
