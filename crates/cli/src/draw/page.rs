//! The whole page as SVG, with the scenario that reproduces it.

use kuva::backend::svg::SvgBackend;
use kuva::render::render::{Scene, TextAnchor};
use precess::figure::Figure;

use super::layout::{page_width, sheet};
use super::panel;
use super::style::{FAMILY, INK, MARGIN, PAPER, SOFT, SUBTITLE, TITLE};
use super::text::{fitting, line, wrap, writable};

const TITLE_LINE: f64 = 27.0;
const SUBTITLE_LINE: f64 = 17.0;

/// The figure as an SVG document. Its `<metadata>` holds the scenario.
///
/// The same figure gives the same bytes. Text stays text, in a stack of common families.
pub fn svg(figure: &Figure) -> String {
    let scene = scene(figure);
    let drawn = SvgBackend::new().render_scene(&scene);
    let title = escaped(&figure.title);
    let scenario = escaped(&figure.scenario);
    let view = format!(" viewBox=\"0 0 {} {}\" role=\"img\">", scene.width, scene.height);
    let metadata = format!("<title>{title}</title><metadata id=\"precess-scenario\">{scenario}</metadata>");
    match drawn.split_once('>') {
        Some((root, rest)) => format!("{root}{view}{metadata}{rest}\n"),
        None => drawn,
    }
}

/// Everything on the page.
fn scene(figure: &Figure) -> Scene {
    let room = page_width(figure) - 2.0 * MARGIN;
    let titles = wrap(&figure.title, TITLE, room);
    let subtitles = wrap(&figure.subtitle, SUBTITLE, room);
    let head = titles.len() as f64 * TITLE_LINE + subtitles.len() as f64 * SUBTITLE_LINE;
    let top = MARGIN - 8.0 + if head > 0.0 { head + 16.0 } else { 0.0 };
    let sheet = sheet(figure, top);
    let page = (sheet.width, (sheet.bottom + MARGIN - 12.0).ceil());
    let mut scene = Scene::new(page.0, page.1);
    scene.background_color = Some(PAPER.into());
    scene.text_color = Some(SOFT.into());
    scene.font_family = Some(FAMILY.into());
    let mut y = MARGIN - 8.0;
    for text in &titles {
        y += TITLE_LINE;
        scene.add(line(MARGIN, y - 8.0, text, fitting(text, TITLE, room), TextAnchor::Start, INK));
    }
    for text in &subtitles {
        y += SUBTITLE_LINE;
        scene.add(line(MARGIN, y - 4.0, text, fitting(text, SUBTITLE, room), TextAnchor::Start, SOFT));
    }
    for placed in &sheet.placed {
        panel::draw(&mut scene, placed, page);
    }
    scene
}

/// Text inside an element: markup escaped, forbidden characters left out, line ends kept.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars().filter(|&c| writable(c)) {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '\r' => out.push_str("&#13;"),
            other => out.push(other),
        }
    }
    out
}
