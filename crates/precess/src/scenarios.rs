//! The scenarios that come with the program.

use crate::Scenario;
use include_dir::{Dir, include_dir};

static FOLDER: Dir = include_dir!("$CARGO_MANIFEST_DIR/../../scenarios");

/// File name and text of every scenario, in alphabetical order.
pub fn all() -> Vec<(&'static str, &'static str)> {
    let files = FOLDER.files().filter_map(|f| Some((f.path().to_str()?, f.contents_utf8()?)));
    let mut all: Vec<_> = files
        .filter(|(name, _)| std::path::Path::new(name).extension().is_some_and(|e| e == "toml"))
        .collect();
    all.sort_unstable();
    all
}

/// The text of the scenario of this file name, whatever the folder in front of it.
pub fn find(path: &str) -> Option<&'static str> {
    let name = path.rsplit(['/', '\\']).next()?;
    all().into_iter().find(|(n, _)| *n == name).map(|(_, text)| text)
}

/// The title of a scenario's text.
pub fn title(text: &str) -> String {
    Scenario::parse(text).map(|s| s.title).unwrap_or_default()
}
