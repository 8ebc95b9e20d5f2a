//! A scenario: what to run, as a person writes it. `docs/scenarios.md` describes the file.

mod body;
mod ensemble;
mod family;
mod figure;
mod reading;

pub(crate) use body::taken_by as takes_body;
pub use ensemble::{Classes, EnsembleSpec, Kept, Source};
pub use family::FamilySpec;
pub(crate) use figure::STROKES;
pub use figure::{FigureKind, FigureSpec};

use crate::error::{Error, input, quoted, unknown};
use crate::value::Value;
use precess_integrate::Kind;
use reading::{as_table, entries, flag, integer, line_of, read, tables, values, word};
use toml::de::DeTable;

/// What to run. Names and units are held against the card by [`Plan`](crate::Plan).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scenario {
    /// Heading; empty for the system's own.
    pub title: String,
    /// What a reader should know of it; the run takes nothing from here.
    pub text: Words,
    /// System id.
    pub system: String,
    /// Parameters that differ from the card's defaults.
    pub parameters: Vec<(String, Value)>,
    /// Starts that differ from the card's defaults.
    pub start: Vec<(String, Value)>,
    /// Method id; the card's where absent.
    pub method: Option<String>,
    /// `dt`, `rtol`, `atol`, `until`, `every` and the method's own options, as given.
    pub run: Vec<(String, Value)>,
    /// Watched crossings.
    pub events: Vec<EventSpec>,
    /// Name of the run in the legends of its pictures.
    pub label: String,
    /// Many members, which `precess ensemble` runs.
    pub ensemble: Option<EnsembleSpec>,
    /// More trajectories in the same pictures.
    pub families: Vec<FamilySpec>,
    /// Panels of the picture; the card's views where there are none.
    pub figures: Vec<FigureSpec>,
}

/// The heading in French, what to notice, in both languages, and where it comes from; each may be empty.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Words {
    /// Heading.
    pub title_fr: String,
    /// What to notice.
    pub note: String,
    /// The same.
    pub note_fr: String,
    /// The book, paper or figure that it comes from.
    pub source: String,
}

/// A watched crossing: `when = "theta = 0"`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EventSpec {
    /// Name in the report; `when` where absent.
    pub name: Option<String>,
    /// Quantity and the value it passes through.
    pub when: String,
    /// `rising`, `falling` or `either` (the default).
    pub direction: Option<String>,
    /// The run ends here.
    pub stop: bool,
}

/// The small core of the lab's first page neither watches nor draws, and works no body out.
const WHOLE: bool = !crate::catalogue::FIRST;

/// The newest format that is understood.
const FORMAT: &str = "1";

/// What stands at the top of a file.
const KEYS: [&str; 14] = [
    "precess", "title", "title_fr", "note", "note_fr", "source", "label", "system", "start", "run", "event",
    "family", "figure", "ensemble",
];

impl Scenario {
    /// A larger file is no scenario.
    pub const LARGEST: usize = 16 << 20;

    /// A system with the card's defaults.
    pub fn of(system: &str) -> Self {
        Self { system: system.into(), ..Self::default() }
    }

    /// Reads a scenario file.
    ///
    /// # Errors
    /// One sentence with the line and the nearest known name.
    pub fn parse(text: &str) -> Result<Self, Error> {
        if text.len() > Self::LARGEST {
            return input("the file is larger than 16 MiB: that is no scenario");
        }
        let root = DeTable::parse(text).map_err(|e| {
            let line = e.span().map_or(1, |s| line_of(text, s.start));
            let why = e.message().lines().next().unwrap_or("not understood");
            Error::Input(format!("line {line}: {why}"))
        })?;
        let mut scenario = Self::default();
        let mut version = None;
        for (key, value) in entries(root.get_ref()) {
            let at = |e: Error| e.at(&format!("line {}", line_of(text, key.span().start)));
            match key.get_ref().as_ref() {
                "precess" => version = Some(integer(value).map_err(at)?),
                "title" => scenario.title = word(value).map_err(at)?,
                "title_fr" => scenario.text.title_fr = word(value).map_err(at)?,
                "note" => scenario.text.note = word(value).map_err(at)?,
                "note_fr" => scenario.text.note_fr = word(value).map_err(at)?,
                "source" => scenario.text.source = word(value).map_err(at)?,
                "label" => scenario.label = word(value).map_err(at)?,
                "system" => scenario.read_system(text, as_table(value).map_err(at)?)?,
                "start" => scenario.start = values(text, as_table(value).map_err(at)?)?,
                "run" => scenario.read_run(text, as_table(value).map_err(at)?)?,
                "event" if WHOLE => scenario.events = tables(value, EventSpec::read).map_err(at)?,
                "ensemble" if WHOLE => {
                    scenario.ensemble = Some(as_table(value).and_then(EnsembleSpec::read).map_err(at)?);
                }
                "family" if WHOLE => scenario.families = tables(value, FamilySpec::read).map_err(at)?,
                "figure" if WHOLE => scenario.figures = tables(value, FigureSpec::read).map_err(at)?,
                other => {
                    return Err(at(unknown("key", other, KEYS)));
                }
            }
        }
        match version.as_deref() {
            Some(FORMAT) => {}
            None => return input("the line 'precess = 1' is missing: it says which format this is"),
            Some(other) => {
                return input(format!(
                    "format {} is not known here, only {FORMAT}: it needs another Precess",
                    quoted(other)
                ));
            }
        }
        if scenario.system.is_empty() {
            return input("the system is missing: [system] with id = \"pendulum\", for instance");
        }
        Ok(scenario)
    }

    fn read_system(&mut self, text: &str, table: &DeTable) -> Result<(), Error> {
        let mut body = None;
        for (key, value) in entries(table) {
            let at = |e: Error| e.at(&format!("line {}", line_of(text, key.span().start)));
            match key.get_ref().as_ref() {
                "id" => self.system = word(value).map_err(at)?,
                "parameters" => self.parameters = values(text, as_table(value).map_err(at)?)?,
                "body" if WHOLE => body = Some(as_table(value).map_err(at)?),
                other => return Err(at(unknown("key", other, ["id", "parameters", "body"]).at("[system]"))),
            }
        }
        let Some(body) = body else { return Ok(()) };
        for (name, value) in body::parameters(&self.system, text, body)? {
            if self.parameters.iter().any(|(given, _)| *given == name) {
                return input(format!("{name} is given twice: in [system.body] and as a parameter"));
            }
            self.parameters.push((name, value));
        }
        Ok(())
    }

    fn read_run(&mut self, text: &str, table: &DeTable) -> Result<(), Error> {
        for (key, value) in entries(table) {
            let at = |e: Error| e.at(&format!("line {}", line_of(text, key.span().start)));
            match key.get_ref().as_ref() {
                "method" => self.method = Some(word(value).map_err(at)?),
                other => self.run.push((other.into(), read(value).map_err(at)?)),
            }
        }
        Ok(())
    }

    /// The scenario under another method: of the settings only those that it understands are kept.
    ///
    /// # Errors
    /// Where there is no such method.
    pub fn by(&self, method: &str) -> Result<Self, Error> {
        let card = crate::catalogue::method(method)?.card();
        let mut own = self.clone();
        own.method = Some(method.into());
        own.run.retain(|(name, _)| match name.as_str() {
            "dt" => card.kind == Kind::Fixed,
            "rtol" | "atol" => card.kind == Kind::Adaptive,
            "until" | "every" => true,
            option => card.options.iter().any(|o| o.name == option),
        });
        Ok(own)
    }

    /// The scenario by `dop853`, of the settings only the end and the samples: what a comparison is held against.
    pub fn for_reference(&self) -> Self {
        let mut own = self.clone();
        own.method = Some("dop853".into());
        own.run.retain(|(name, _)| ["until", "every"].contains(&name.as_str()));
        own
    }

    /// Sets a value among named ones, in place of an earlier one.
    pub fn set(list: &mut Vec<(String, Value)>, name: &str, value: Value) {
        match list.iter_mut().find(|(n, _)| n == name) {
            Some(entry) => entry.1 = value,
            None => list.push((name.into(), value)),
        }
    }
}

impl EventSpec {
    fn read(table: &DeTable) -> Result<Self, Error> {
        let mut event = Self::default();
        for (key, value) in entries(table) {
            match key.get_ref().as_ref() {
                "name" => event.name = Some(word(value)?),
                "when" => event.when = word(value)?,
                "direction" => event.direction = Some(word(value)?),
                "stop" => event.stop = flag(value)?,
                other => {
                    return Err(unknown("key", other, ["name", "when", "direction", "stop"]).at("[[event]]"));
                }
            }
        }
        if event.when.is_empty() {
            return input("[[event]] needs a crossing to watch, such as when = \"theta = 0\"");
        }
        Ok(event)
    }
}
