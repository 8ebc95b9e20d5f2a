//! An ensemble: many members that differ in starts and parameters, and what is kept of each.

use super::reading::{as_table, entries, number_of, read, several, texts, word, words};
use crate::error::{Error, input, quoted, unknown};
use crate::value::Value;
use toml::de::{DeTable, DeValue};

/// Where the members of an ensemble come from.
#[derive(Clone, Debug, PartialEq)]
pub enum Source {
    /// Every combination of evenly spaced values, `LOW:HIGH:N` for each name; the first name runs fastest.
    Grid(Vec<(String, String)>),
    /// A list of values for each name; the k-th member takes the k-th of each.
    List(Vec<(String, Vec<Value>)>),
    /// Independent evenly distributed values, `LOW:HIGH` for each name.
    Random {
        /// The ranges.
        ranges: Vec<(String, String)>,
        /// How many members.
        members: usize,
        /// Of the sequence; the same seed gives the same members for ever.
        seed: u64,
    },
    /// The rows of a CSV file with the names in its first row.
    File(String),
}

/// What is kept of a member.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Kept {
    /// The state at the end.
    #[default]
    Last,
    /// The smallest and the largest value of each quantity at the samples.
    Extremes,
    /// Time and state of the first watched crossing.
    Passage,
    /// Time and state of every watched crossing.
    Section,
}

/// What sorts the members: between which of some values a quantity ends.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Classes {
    /// A column that is kept, or an observable of the state that is kept.
    pub of: String,
    /// The values, rising.
    pub at: Vec<Value>,
    /// A name for each class, one more than values; made from the values where empty.
    pub names: Vec<String>,
}

/// An ensemble.
#[derive(Clone, Debug, PartialEq)]
pub struct EnsembleSpec {
    /// Its members.
    pub source: Source,
    /// What is kept of each.
    pub keep: Kept,
    /// How they are sorted.
    pub classes: Option<Classes>,
}

const KEYS: [&str; 8] = ["grid", "list", "random", "file", "members", "seed", "keep", "classes"];
const KEEP: [(&str, Kept); 4] = [
    ("last", Kept::Last),
    ("extremes", Kept::Extremes),
    ("passage", Kept::Passage),
    ("section", Kept::Section),
];
/// More members than this take years.
const MOST: usize = 1_000_000_000;

impl Kept {
    /// Its name in a scenario.
    pub fn name(self) -> &'static str {
        KEEP.iter().find(|(_, keep)| *keep == self).map_or("", |(name, _)| name)
    }
}

impl EnsembleSpec {
    pub(super) fn read(table: &DeTable) -> Result<Self, Error> {
        let (mut sources, mut keep, mut members, mut seed) = (vec![], Kept::default(), None, None);
        let mut classes = None;
        for (key, value) in entries(table) {
            let key = key.get_ref().as_ref();
            let at = |e: Error| e.at(&format!("[ensemble]: {key}"));
            match key {
                "grid" => sources.push(Source::Grid(as_table(value).and_then(texts).map_err(at)?)),
                "list" => sources.push(Source::List(as_table(value).and_then(lists).map_err(at)?)),
                "random" => {
                    let ranges = as_table(value).and_then(texts).map_err(at)?;
                    sources.push(Source::Random { ranges, members: 0, seed: 0 });
                }
                "file" => sources.push(Source::File(word(value).map_err(at)?)),
                "members" => members = Some(number_of(value, MOST).map_err(at)?),
                "seed" => seed = Some(number_of(value, usize::MAX >> 1).map_err(at)? as u64),
                "keep" => {
                    let name = word(value).map_err(at)?;
                    let known = KEEP.iter().find(|(known, _)| *known == name).map(|(_, keep)| *keep);
                    keep = known.ok_or_else(|| at(unknown("choice", &name, KEEP.map(|(name, _)| name))))?;
                }
                "classes" => classes = Some(as_table(value).and_then(sorted).map_err(at)?),
                other => return Err(unknown("key", other, KEYS).at("[ensemble]")),
            }
        }
        let count = sources.len();
        let (Some(mut source), 1) = (sources.pop(), count) else {
            return input(format!(
                "[ensemble] takes its members from one of grid, list, random and file, not from {count}"
            ));
        };
        match (&mut source, members) {
            (Source::Random { members, seed: own, .. }, Some(given)) => {
                (*members, *own) = (given, seed.unwrap_or(0));
            }
            (Source::Random { .. }, None) => return input("[ensemble]: random needs a number of members"),
            (_, Some(_)) => return input("[ensemble]: members is for random ones alone"),
            (_, None) if seed.is_some() => return input("[ensemble]: seed is for random members alone"),
            (_, None) => {}
        }
        Ok(Self { source, keep, classes })
    }

    /// As it stands in a scenario; values in SI units.
    pub fn toml(&self) -> String {
        let words = |pairs: &[(String, String)]| {
            let pairs: Vec<String> = pairs.iter().map(|(name, text)| format!("{name} = {text:?}")).collect();
            format!("{{ {} }}", pairs.join(", "))
        };
        let source = match &self.source {
            Source::Grid(axes) => format!("grid = {}", words(axes)),
            Source::File(name) => format!("file = {name:?}"),
            Source::Random { ranges, members, seed } => {
                format!("random = {}\nmembers = {members}\nseed = {seed}", words(ranges))
            }
            Source::List(lists) => {
                let lists: Vec<String> =
                    lists.iter().map(|(name, l)| format!("{name} = {}", listed(l))).collect();
                format!("list = {{ {} }}", lists.join(", "))
            }
        };
        let classes = self.classes.as_ref().map_or(String::new(), |classes| {
            let Classes { of, at, names } = classes;
            format!("classes = {{ of = {of:?}, at = {}, names = {names:?} }}\n", listed(at))
        });
        format!("[ensemble]\n{source}\nkeep = \"{}\"\n{classes}", self.keep.name())
    }
}

/// Values as a list in TOML, in SI units.
fn listed(values: &[Value]) -> String {
    let number = |value: &Value| match value {
        Value::Number { x, .. } => format!("{x:?}"),
        other => format!("{other:?}"),
    };
    format!("[{}]", values.iter().map(number).collect::<Vec<_>>().join(", "))
}

/// The classes of a table.
fn sorted(table: &DeTable) -> Result<Classes, Error> {
    let mut classes = Classes::default();
    for (key, value) in entries(table) {
        match key.get_ref().as_ref() {
            "of" => classes.of = word(value)?,
            "at" => classes.at = several(read(value)?),
            "names" => classes.names = words(value)?,
            other => return Err(unknown("key", other, ["of", "at", "names"])),
        }
    }
    let (edges, names) = (classes.at.len(), classes.names.len());
    if classes.of.is_empty() || edges == 0 {
        return input("classes are written as { of = \"theta\", at = [\"30 deg\", \"150 deg\"] }");
    }
    if names > 0 && names != edges + 1 {
        return input(format!("{edges} values make {} classes, not {names}", edges + 1));
    }
    Ok(classes)
}

/// A list of values for each name.
fn lists(table: &DeTable) -> Result<Vec<(String, Vec<Value>)>, Error> {
    let list = |value: &DeValue| match read(value)? {
        Value::List(items) => Ok(items),
        _ => input("a list of values is needed here"),
    };
    let lists = entries(table).into_iter().map(|(name, value)| {
        let name = name.get_ref().to_string();
        Ok((name.clone(), list(value).map_err(|e| e.at(&quoted(&name)))?))
    });
    lists.collect()
}
