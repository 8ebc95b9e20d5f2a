//! An ensemble: many members that differ in starts and parameters, and what is kept of each.

use super::reading::{as_table, entries, number_of, read, texts, word};
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

/// An ensemble.
#[derive(Clone, Debug, PartialEq)]
pub struct EnsembleSpec {
    /// Its members.
    pub source: Source,
    /// What is kept of each.
    pub keep: Kept,
}

const KEYS: [&str; 7] = ["grid", "list", "random", "file", "members", "seed", "keep"];
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
        Ok(Self { source, keep })
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
                let number = |value: &Value| match value {
                    Value::Number { x, .. } => format!("{x:?}"),
                    other => format!("{other:?}"),
                };
                let list = |values: &Vec<Value>| values.iter().map(number).collect::<Vec<_>>().join(", ");
                let lists: Vec<String> =
                    lists.iter().map(|(name, l)| format!("{name} = [{}]", list(l))).collect();
                format!("list = {{ {} }}", lists.join(", "))
            }
        };
        format!("[ensemble]\n{source}\nkeep = \"{}\"\n", self.keep.name())
    }
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
