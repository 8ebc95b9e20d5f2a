//! Members sorted by where a quantity ends, and the map of their classes.

use super::members::label;
use super::{Checkpoint, Survey};
use crate::error::{Error, input, unknown};
use crate::figure::{Figure, Map, Panel};
use crate::grid::Axis;
use crate::picture::{axis, readable, subtitle};
use crate::plan::Plan;
use crate::scenario::{Classes, Kept};
use crate::value::shortest;
use precess_system::Field;

/// Where the quantity stands.
enum Of {
    /// In this column of a row.
    Column(usize),
    /// Among the observables, at the state that begins in this column.
    Observable { number: usize, state: usize },
}

/// Classes held against a plan.
pub(super) struct Sorter {
    of: Of,
    edges: Vec<f64>,
    /// One more than edges.
    names: Vec<String>,
    /// Name and unit of the quantity.
    label: String,
}

impl Sorter {
    /// `columns` are those of a row without the class.
    pub fn new(plan: &Plan, classes: &Classes, keep: Kept, columns: &[String]) -> Result<Self, Error> {
        let at = |e: Error| e.at("[ensemble]: classes");
        if keep == Kept::Section {
            return input("a member has many rows with keep = \"section\", so it has no class").map_err(at);
        }
        let (own, observables) = (plan.columns(), &plan.layout.observables);
        let column = columns.iter().position(|name| *name == classes.of);
        let number = observables.iter().position(|o| o.quantity.name == classes.of);
        let state = columns.iter().position(|name| *name == own[1].name);
        let of = match (column, number, state) {
            (Some(column), ..) => Of::Column(column),
            (None, Some(number), Some(state)) => Of::Observable { number, state },
            _ => {
                let observed =
                    observables.iter().filter(|_| state.is_some()).map(|o| o.quantity.name.as_str());
                let names = columns.iter().map(String::as_str).chain(observed);
                return Err(at(unknown("quantity", &classes.of, names)));
            }
        };
        // What varies stands under another name, and so do the extremes.
        let bare = |end: &str| classes.of.strip_suffix(end).unwrap_or(&classes.of).to_string();
        let names = [classes.of.clone(), bare("_min"), bare("_max"), classes.of.replacen("start_", "", 1)];
        let known = own.iter().find(|q| names.contains(&q.name));
        let unit = known.map_or("", |q| q.unit.as_str());
        let label = known.map_or_else(|| readable(&classes.of), axis);
        let edges: Vec<f64> =
            classes.at.iter().map(|value| value.in_unit(unit)).collect::<Result<_, _>>().map_err(at)?;
        if edges.windows(2).any(|pair| pair[0] >= pair[1]) {
            return input("the values between classes must rise").map_err(at);
        }
        let names = if classes.names.is_empty() { named(&edges, unit) } else { classes.names.clone() };
        Ok(Self { of, edges, names, label })
    }

    /// The class of a row: how many of the values its quantity has reached; -1 where there is no number.
    pub fn class(&self, plan: &Plan, field: &dyn Field<f64>, row: &[f64]) -> f64 {
        let x = match self.of {
            Of::Column(column) => row[column],
            Of::Observable { number, state } => {
                // Modes rest at their start where there are any, as in the extremes.
                let mut full = plan.start.clone();
                let width = plan.layout.shape().state();
                full[..width].copy_from_slice(&row[state..state + width]);
                let mut observed = vec![0.0; plan.layout.observables.len()];
                field.observe(plan.until, &full, &mut observed);
                observed[number]
            }
        };
        if x.is_nan() { -1.0 } else { self.edges.iter().filter(|edge| **edge <= x).count() as f64 }
    }
}

/// `below 1 s`, `1 to 2 s`, `above 2 s`.
fn named(edges: &[f64], unit: &str) -> Vec<String> {
    let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
    let (first, last) = (shortest(edges[0]), shortest(edges[edges.len() - 1]));
    let between =
        edges.windows(2).map(|pair| format!("{} to {}{unit}", shortest(pair[0]), shortest(pair[1])));
    let below = std::iter::once(format!("below {first}{unit}"));
    below.chain(between).chain([format!("above {last}{unit}")]).collect()
}

impl Survey {
    /// Its classes, and the two axes of its grid.
    fn sorted(&self) -> Result<(&Sorter, [&Axis; 2]), Error> {
        match (&self.sorter, self.roll.grid()) {
            (None, _) => input(
                "[ensemble]: a map needs classes, such as { of = \"theta\", at = [\"30 deg\", \"150 deg\"] }",
            ),
            (_, None) => input("[ensemble]: a map needs a grid of two names"),
            (Some(sorter), Some(axes)) => Ok((sorter, axes)),
        }
    }

    /// Whether the ensemble has a map.
    ///
    /// # Errors
    /// One sentence: what it lacks.
    pub fn has_map(&self) -> Result<(), Error> {
        self.sorted().map(|_| ())
    }

    /// The classes over the grid.
    ///
    /// # Errors
    /// Where the members lie on no grid of two names, or have no classes, or the checkpoint cannot be read.
    pub fn map(&self, checkpoint: &mut Checkpoint) -> Result<Panel, Error> {
        let (sorter, [x, y]) = self.sorted()?;
        let mut classes = Vec::with_capacity(self.members());
        self.rows(checkpoint, &mut |row| classes.push(row[row.len() - 1] as i32))?;
        Ok(Panel {
            title: sorter.label.clone(),
            x_label: label(&self.plan, &x.name)?,
            y_label: label(&self.plan, &y.name)?,
            map: Some(Map {
                x: (x.low, x.high),
                y: (y.low, y.high),
                columns: x.points,
                classes,
                names: sorter.names.clone(),
            }),
            ..Panel::default()
        })
    }

    /// The map as a picture.
    ///
    /// # Errors
    /// As for [`Survey::map`].
    pub fn figure(&self, checkpoint: &mut Checkpoint) -> Result<Figure, Error> {
        Ok(Figure {
            title: self.plan.title.clone(),
            subtitle: subtitle(&self.plan),
            panels: vec![self.map(checkpoint)?],
            scenario: self.toml(),
        })
    }
}
