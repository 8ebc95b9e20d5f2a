//! `precess list`: what there is.

use crate::args::What;
use crate::failure::Failure;
use precess::{catalogue, json, scenarios};
use serde_json::{Map, Value};
use std::fmt::Write;

/// Lists systems, methods or scenarios; all of them where nothing is named.
pub fn list(what: Option<What>, as_json: bool) -> Result<(), Failure> {
    let chosen = what.map_or(vec![What::Systems, What::Methods, What::Scenarios], |w| vec![w]);
    let text = if as_json { to_json(&chosen) } else { to_text(&chosen) };
    print(&text)
}

/// Writes to standard output; a reader that has gone is no failure.
pub fn print(text: &str) -> Result<(), Failure> {
    use std::io::Write;
    let written = std::io::stdout().write_all(text.as_bytes()).and_then(|()| std::io::stdout().flush());
    written.map_err(|e| Failure::of_writing("standard output", &e))
}

fn to_json(chosen: &[What]) -> String {
    let mut all = Map::new();
    for what in chosen {
        match what {
            What::Systems => all.insert("systems".into(), json::systems()),
            What::Methods => all.insert("methods".into(), json::methods()),
            What::Scenarios => all.insert("scenarios".into(), json::all_scenarios()),
        };
    }
    format!("{:#}\n", Value::Object(all))
}

fn to_text(chosen: &[What]) -> String {
    let mut text = String::new();
    for what in chosen {
        let (heading, rows): (&str, Vec<(String, String)>) = match what {
            What::Systems => {
                let cards = catalogue::systems().iter().map(|s| s.card());
                ("Systems", cards.map(|c| (c.id.into(), c.title.en)).collect())
            }
            What::Methods => {
                let cards = catalogue::methods().iter().map(|m| m.card());
                ("Methods", cards.map(|c| (c.id.into(), c.title.0.into())).collect())
            }
            What::Scenarios => {
                let files = scenarios::all().into_iter();
                ("Scenarios", files.map(|(name, text)| (name.into(), scenarios::title(text))).collect())
            }
        };
        if chosen.len() > 1 {
            let gap = if text.is_empty() { "" } else { "\n" };
            let _ = writeln!(text, "{gap}{heading}");
        }
        let indent = if chosen.len() > 1 { "  " } else { "" };
        let width = rows.iter().map(|r| r.0.len()).max().unwrap_or(0);
        for (id, title) in rows {
            let _ = writeln!(text, "{indent}{id:width$}  {title}");
        }
    }
    text
}
