//! What a measurement gives: a table with a name, for people and for programs.

use precess::scalar::Isa;
use serde_json::{Map, Value, json};
use std::fmt::{self, Write};

/// What the numbers of a column are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// So many times as fast.
    Ratio,
    /// A part of one.
    Share,
    /// A time or a rate.
    Number,
    /// A small number.
    Distance,
}

/// A column.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Name for programs.
    pub name: String,
    /// Heading for people.
    pub heading: String,
    /// What its numbers are.
    pub kind: Kind,
}

/// A row: a name, and a number for each column where there is one.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// What was measured.
    pub name: String,
    /// The numbers.
    pub cells: Vec<Option<f64>>,
}

/// A table.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Name for programs.
    pub name: &'static str,
    /// Heading for people.
    pub title: String,
    /// The columns: ratios first.
    pub columns: Vec<Column>,
    /// The rows.
    pub rows: Vec<Row>,
    /// What else there is to say.
    pub notes: Vec<String>,
}

impl Column {
    /// A column.
    pub fn new(name: impl Into<String>, heading: impl Into<String>, kind: Kind) -> Self {
        Self { name: name.into(), heading: heading.into(), kind }
    }
}

impl Table {
    /// A table without rows.
    pub fn new(name: &'static str, title: impl Into<String>, columns: Vec<Column>) -> Self {
        Self { name, title: title.into(), columns, rows: vec![], notes: vec![] }
    }

    /// A table with, for each set of registers, its ratio to plain numbers and nanoseconds.
    pub fn of_lanes(name: &'static str, title: &str, isas: &[Isa]) -> Self {
        let ratio = |isa: &Isa| Column::new(format!("{}_ratio", isa.name()), isa.name(), Kind::Ratio);
        let time =
            |isa: &Isa| Column::new(format!("{}_ns", isa.name()), format!("ns {}", isa.name()), Kind::Number);
        let columns = isas.iter().skip(1).map(ratio).chain(isas.iter().map(time)).collect();
        Self::new(name, title, columns)
    }

    /// Adds a row.
    pub fn row(&mut self, name: impl Into<String>, cells: impl IntoIterator<Item = Option<f64>>) {
        self.rows.push(Row { name: name.into(), cells: cells.into_iter().collect() });
    }

    /// Adds a row to a table [of lanes](Self::of_lanes).
    pub fn row_of_lanes(&mut self, name: &str, ns: &[f64]) {
        let ratios = ns.iter().skip(1).map(|x| ns[0] / x);
        self.row(name, ratios.chain(ns.iter().copied()).map(Some));
    }

    /// Of a table of lanes: which row the widest registers help least. A row far behind the others is code that was
    /// not compiled for them.
    pub fn note_least_gain(&mut self, isas: &[Isa]) {
        let Some(widest) = isas.len().checked_sub(2) else { return };
        let gains = self.rows.iter().filter_map(|row| Some((row.cells[widest]?, &row.name)));
        if let Some((gain, name)) = gains.min_by(|a, b| a.0.total_cmp(&b.0)) {
            let isa = isas[widest + 1].name();
            self.notes.push(format!("{isa} helps {name} least: {gain:.1} x."));
        }
    }

    /// As JSON.
    pub fn json(&self) -> Value {
        let row = |row: &Row| {
            let mut object = Map::new();
            object.insert("name".into(), json!(row.name));
            let cells = self.columns.iter().zip(&row.cells);
            object.extend(cells.map(|(column, cell)| (column.name.clone(), json!(cell))));
            Value::Object(object)
        };
        json!({
            "name": self.name,
            "title": self.title,
            "rows": self.rows.iter().map(row).collect::<Vec<_>>(),
            "notes": self.notes,
        })
    }
}

fn text(kind: Kind, x: f64) -> String {
    match kind {
        Kind::Ratio if x < 1.0 => format!("{x:.2} x"),
        Kind::Ratio => format!("{x:.1} x"),
        Kind::Share => format!("{:.0} %", x * 100.0),
        Kind::Distance => format!("{x:.1e}"),
        Kind::Number if x < 10.0 => format!("{x:.2}"),
        Kind::Number if x < 100.0 => format!("{x:.1}"),
        Kind::Number => format!("{x:.0}"),
    }
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}: {}", self.name, self.title)?;
        let cell =
            |row: &Row, k: usize| row.cells[k].map_or(String::new(), |x| text(self.columns[k].kind, x));
        let width = self.rows.iter().map(|row| row.name.chars().count()).max().unwrap_or(0);
        let widths: Vec<usize> = (0..self.columns.len())
            .map(|k| self.rows.iter().map(|row| cell(row, k).len()).max().unwrap_or(0))
            .zip(&self.columns)
            .map(|(width, column)| if width > column.heading.len() { width } else { column.heading.len() })
            .collect();
        let line = |name: &str, cells: &mut dyn Iterator<Item = String>| {
            let mut line = format!("  {name:width$}");
            for (cell, width) in cells.zip(&widths) {
                // Writing to a String cannot fail.
                let _ = write!(line, "  {cell:>width$}");
            }
            line.trim_end().to_string()
        };
        writeln!(f, "{}", line("", &mut self.columns.iter().map(|column| column.heading.clone())))?;
        for row in &self.rows {
            writeln!(f, "{}", line(&row.name, &mut (0..self.columns.len()).map(|k| cell(row, k))))?;
        }
        self.notes.iter().try_for_each(|note| writeln!(f, "  {note}"))
    }
}
