//! A family of trajectories: a line of starts, a list of parameters, another method or system beside the run.

use super::Scenario;
use super::figure::stroke;
use super::reading::{as_table, entries, flag, line, texts, word};
use crate::error::{Error, input, unknown};
use crate::figure::Stroke;
use crate::value::Value;
use toml::de::DeTable;

/// More trajectories in the pictures of a run. Each list gives one value to each member; a single value holds for all.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FamilySpec {
    /// What a panel calls it by; several families may share a name.
    pub name: String,
    /// Name of each member in legends; `{theta}` stands for the member's value of theta.
    pub label: String,
    /// Another system; the run's own where absent.
    pub system: Option<String>,
    /// Parameters, on top of the run's (of the card's, under another system).
    pub parameters: Vec<(String, Vec<Value>)>,
    /// Starts, likewise.
    pub start: Vec<(String, Vec<Value>)>,
    /// Another method.
    pub method: Option<String>,
    /// Settings, on top of the run's.
    pub run: Vec<(String, Value)>,
    /// Under another system: the quantity that is drawn where a panel asks for one of the run's.
    pub names: Vec<(String, String)>,
    /// Also backwards in time from the same start.
    pub both_ways: bool,
    /// How its curves are drawn.
    pub style: Option<Stroke>,
}

/// More trajectories than this make no picture.
const MOST: usize = 10_000;

const KEYS: [&str; 9] =
    ["name", "label", "system", "parameters", "start", "run", "names", "both_ways", "style"];

impl FamilySpec {
    pub(super) fn read(table: &DeTable) -> Result<Self, Error> {
        let mut family = Self::default();
        for (key, value) in entries(table) {
            let key = key.get_ref().as_ref();
            let at = |e: Error| e.at(&format!("[[family]]: {key}"));
            match key {
                "name" => family.name = word(value).map_err(at)?,
                "label" => family.label = word(value).map_err(at)?,
                "system" => family.system = Some(word(value).map_err(at)?),
                "parameters" => family.parameters = lines(as_table(value).map_err(at)?).map_err(at)?,
                "start" => family.start = lines(as_table(value).map_err(at)?).map_err(at)?,
                "run" => {
                    for (name, value) in entries(as_table(value).map_err(at)?) {
                        match name.get_ref().as_ref() {
                            "method" => family.method = Some(word(value).map_err(at)?),
                            other => family.run.push((other.into(), super::read(value).map_err(at)?)),
                        }
                    }
                }
                "names" => family.names = texts(as_table(value).map_err(at)?).map_err(at)?,
                "both_ways" => family.both_ways = flag(value).map_err(at)?,
                "style" => family.style = Some(stroke(&word(value).map_err(at)?).map_err(at)?),
                other => return Err(unknown("key", other, KEYS).at("[[family]]")),
            }
        }
        family.size()?;
        Ok(family)
    }

    /// How many members it has.
    fn size(&self) -> Result<usize, Error> {
        let mut size = 1;
        for (name, values) in self.parameters.iter().chain(&self.start) {
            match values.len() {
                1 => {}
                n if n > MOST => {
                    return input(format!(
                        "[[family]]: {name}: {n} trajectories are too many: at most {MOST}"
                    ));
                }
                n if size == 1 => size = n,
                n if n == size => {}
                n => {
                    return input(format!(
                        "[[family]]: {name} has {n} values where another has {size}: they go together, one by one"
                    ));
                }
            }
        }
        Ok(size)
    }

    /// The members: each one's label and what it runs.
    pub(crate) fn members(&self, base: &Scenario) -> Result<Vec<(String, Scenario)>, Error> {
        let size = self.size()?;
        (0..size).map(|k| self.member(base, k)).collect()
    }

    fn member(&self, base: &Scenario, k: usize) -> Result<(String, Scenario), Error> {
        let mut own = match &self.system {
            Some(id) if *id != base.system => Scenario { run: base.run.clone(), ..Scenario::of(id) },
            _ => Scenario { label: String::new(), families: vec![], figures: vec![], ..base.clone() },
        };
        own.method.clone_from(&base.method);
        if let Some(method) = &self.method {
            own = own.by(method)?;
        }
        let mut label = self.label.clone();
        let mut set = |list: &mut Vec<(String, Value)>, given: &[(String, Vec<Value>)]| {
            for (name, values) in given {
                let value = &values[if values.len() == 1 { 0 } else { k }];
                label = label.replace(&format!("{{{name}}}"), &brief(value));
                Scenario::set(list, name, value.clone());
            }
        };
        set(&mut own.parameters, &self.parameters);
        set(&mut own.start, &self.start);
        for (name, value) in &self.run {
            Scenario::set(&mut own.run, name, value.clone());
        }
        Ok((label, own))
    }
}

/// A list, a text such as `-2:2:9` (evenly spaced, both ends included), or a single value.
fn lines(table: &DeTable) -> Result<Vec<(String, Vec<Value>)>, Error> {
    let read = |(key, value): (&toml::Spanned<std::borrow::Cow<str>>, &toml::de::DeValue)| {
        let name = key.get_ref().to_string();
        line(value, MOST).map(|values| (name.clone(), values)).map_err(|e| e.at(&name))
    };
    entries(table).into_iter().map(read).collect()
}

/// A value with four digits.
fn brief(value: &Value) -> String {
    match value {
        Value::Number { x, .. } => {
            let rounded = format!("{x:.3e}").parse().unwrap_or(*x);
            crate::value::shortest(rounded)
        }
        Value::Word(word) => word.clone(),
        Value::List(items) => format!("[{}]", items.iter().map(brief).collect::<Vec<_>>().join("; ")),
    }
}
