//! `precess gallery`: every scenario that comes with the program, drawn, with what to notice, in two languages.

use crate::args::Gallery;
use crate::draw;
use crate::failure::{Failure, reason};
use crate::output::Output;
use crate::progress::{Progress, listen};
use precess::{Error, Plan, Scenario, picture, run, scenarios};
use std::fmt::Write as _;
use std::io::{self, Write as _};
use std::path::Path;

/// A scenario of the gallery.
struct Piece {
    /// File name without its suffix.
    stem: String,
    scenario: Scenario,
    text: &'static str,
}

/// Both pages, with the file that each is and the words around the pictures.
const PAGES: [Page; 2] = [
    Page {
        language: "en",
        file: "index.html",
        other: ("index.fr.html", "fr", "En français"),
        title: "Precess: the gallery",
        about: "Every picture is a run of the program; under each stands the command that draws it.",
        source: "Source",
        scenario: "scenario",
    },
    Page {
        language: "fr",
        file: "index.fr.html",
        other: ("index.html", "en", "In English"),
        title: "Precess : la galerie",
        about: "Chaque image est un calcul du programme ; la commande qui la dessine est écrite dessous.",
        source: "Source",
        scenario: "scénario",
    },
];

struct Page {
    language: &'static str,
    file: &'static str,
    other: (&'static str, &'static str, &'static str),
    title: &'static str,
    about: &'static str,
    source: &'static str,
    scenario: &'static str,
}

/// Draws.
pub fn gallery(arguments: &Gallery) -> Result<(), Failure> {
    let pieces = chosen(&arguments.names)?;
    let folder = &arguments.output;
    std::fs::create_dir_all(folder).map_err(|e| {
        Failure::Wrong(format!("cannot make the folder '{}': {}", folder.display(), reason(&e)))
    })?;
    let mut progress = Progress::new(pieces.len() as f64, arguments.quiet, &listen());
    for (k, piece) in pieces.iter().enumerate() {
        if progress.at(k as f64).is_break() {
            return Err(Failure::Failed(format!("interrupted before {}; no page was written", piece.stem)));
        }
        draw(piece, folder, &mut progress, k as f64).map_err(|failure| match failure {
            Failure::Wrong(why) => Failure::Wrong(format!("{}: {why}", piece.stem)),
            Failure::Failed(why) => Failure::Failed(format!("{}: {why}", piece.stem)),
            listener @ Failure::NobodyListens => listener,
        })?;
    }
    progress.finish();
    for page in &PAGES {
        write(folder, page.file, page.html(&pieces).as_bytes())?;
    }
    if !arguments.quiet {
        let _ = writeln!(io::stderr(), "{} pictures: {}", pieces.len(), folder.join(PAGES[0].file).display());
    }
    Ok(())
}

/// The scenarios whose names hold one of the words, those of the first book first and in the order of its figures.
fn chosen(words: &[String]) -> Result<Vec<Piece>, Failure> {
    let wanted = |name: &str| words.is_empty() || words.iter().any(|word| name.contains(word.as_str()));
    let mut pieces = vec![];
    for (name, text) in scenarios::all().into_iter().filter(|(name, _)| wanted(name)) {
        let scenario = Scenario::parse(text).map_err(|e| e.at(name))?;
        pieces.push(Piece { stem: name.trim_end_matches(".toml").into(), scenario, text });
    }
    if pieces.is_empty() {
        let names: Vec<&str> = scenarios::all().into_iter().map(|(name, _)| name).collect();
        let word = words.first().map_or("", String::as_str);
        return Err(precess::unknown("scenario", word, names).into());
    }
    pieces.sort_by_key(|piece| rank(&piece.stem));
    Ok(pieces)
}

/// Figures come before exercises and both before the rest; numbers in a name count as numbers.
fn rank(stem: &str) -> (bool, bool, u32, String) {
    let digits: String = stem.chars().filter(char::is_ascii_digit).collect();
    let number = digits.parse().unwrap_or(0);
    (!stem.starts_with("p-"), !stem.starts_with("p-fig"), number, stem.into())
}

fn draw(piece: &Piece, folder: &Path, progress: &mut Progress, done: f64) -> Result<(), Failure> {
    let plan = Plan::new(&piece.scenario)?;
    let mut watch = |_: f64| progress.at(done);
    let outcome = run(&plan, &mut watch);
    let figure = picture(&plan, &outcome.trajectory, &mut watch)?;
    write(folder, &format!("{}.svg", piece.stem), draw::svg(&figure).as_bytes())?;
    write(folder, &format!("{}.toml", piece.stem), piece.text.as_bytes())?;
    if watch(1.0).is_break() {
        return Err(Error::Failed("interrupted; no page was written".into()).into());
    }
    Ok(())
}

fn write(folder: &Path, name: &str, bytes: &[u8]) -> Result<(), Failure> {
    Output::create(&folder.join(name))?.finish(|file| file.write_all(bytes))
}

const STYLE: &str = "body{margin:0;background:#f4f1e8;color:#23262b;font:17px/1.5 Georgia,serif}\
header,main{max-width:1080px;margin:auto;padding:1.5rem}h1{font-weight:400;margin:.2em 0}\
article{background:#fbf9f4;border:1px solid #e0dacb;border-radius:6px;margin:0 0 2.2rem;overflow:hidden}\
article img{display:block;width:100%;height:auto}article div{padding:.4rem 1.6rem 1.1rem}\
h2{font-size:1.2rem;margin:.5em 0 .2em}p{margin:.3em 0}small,code{color:#565a61;font-size:.85rem}\
a{color:#1d4e80}@media(prefers-color-scheme:dark){body{background:#1d1f22;color:#e8e4da}\
article{background:#26292d;border-color:#3a3e44}article img{background:#fbf9f4}small,code{color:#a9a69d}a{color:#8fb8e0}}";

impl Page {
    fn html(&self, pieces: &[Piece]) -> String {
        let (file, language, words) = self.other;
        let mut out = format!(
            "<!doctype html>\n<html lang=\"{}\">\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width\">\n<title>{}</title>\n<style>{STYLE}</style>\n\
             <header><h1>{}</h1><p>{}</p><p><a href=\"{file}\" hreflang=\"{language}\" lang=\"{language}\">{words}</a></p>\
             </header>\n<main>\n",
            self.language, self.title, self.title, self.about
        );
        for piece in pieces {
            self.article(&mut out, piece);
        }
        out + "</main>\n</html>\n"
    }

    fn article(&self, out: &mut String, Piece { stem, scenario, .. }: &Piece) {
        let words = &scenario.text;
        let (title, note) = match self.language {
            "fr" => (&words.title_fr, &words.note_fr),
            _ => (&scenario.title, &words.note),
        };
        let (title, note, source) = (escaped(title), escaped(note), escaped(&words.source));
        // Writing to a String cannot fail.
        let _ = writeln!(
            out,
            "<article id=\"{stem}\">\n<img src=\"{stem}.svg\" alt=\"{title}\" loading=\"lazy\">\n<div><h2>{title}</h2>\n\
             <p>{note}</p>"
        );
        if !source.is_empty() {
            let _ = writeln!(out, "<p><small>{}: {source}</small></p>", self.source);
        }
        let _ = writeln!(
            out,
            "<p><code>precess run {stem}.toml --plot {stem}.svg</code> \
             <small>(<a href=\"{stem}.toml\">{}</a>)</small></p></div>\n</article>",
            self.scenario
        );
    }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
