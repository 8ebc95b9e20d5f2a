//! The members of an ensemble: what each of them starts with, worked out when it is asked for.

use crate::error::{Error, input, quoted, unknown};
use crate::grid::Axis;
use crate::hash::Hasher;
use crate::picture::axis as label_of;
use crate::plan::Plan;
use crate::random::Random;
use crate::scenario::{EnsembleSpec, Scenario, Source};
use crate::value::{self, Value};
use precess_system::{Default, Quantity};
use std::path::Path;

/// What a name of an ensemble stands for.
#[derive(Clone, Debug, PartialEq)]
enum Target {
    Start,
    Parameter,
}

/// The members, in order.
pub(super) struct Roll {
    /// The names that vary.
    pub names: Vec<String>,
    targets: Vec<Target>,
    values: Values,
    pub count: usize,
}

enum Values {
    Grid(Vec<Axis>),
    Columns(Vec<Vec<f64>>),
    Random { ranges: Vec<[f64; 2]>, seed: u64 },
}

impl Roll {
    /// Holds what a scenario says against its plan; files are looked for beside `folder`.
    pub fn new(plan: &Plan, spec: &EnsembleSpec, folder: &Path) -> Result<Self, Error> {
        let (names, values) = match &spec.source {
            Source::Grid(axes) => {
                let names = axes.iter().map(|(name, _)| name.clone()).collect();
                (
                    names,
                    Values::Grid(
                        axes.iter().map(|(name, text)| axis(plan, name, text)).collect::<Result<_, _>>()?,
                    ),
                )
            }
            Source::List(lists) => {
                let names = lists.iter().map(|(name, _)| name.clone()).collect();
                (names, Values::Columns(columns(plan, lists)?))
            }
            Source::Random { ranges, seed, .. } => {
                let names = ranges.iter().map(|(name, _)| name.clone()).collect();
                let ranges =
                    ranges.iter().map(|(name, text)| range(plan, name, text)).collect::<Result<_, _>>()?;
                (names, Values::Random { ranges, seed: *seed })
            }
            Source::File(name) => {
                let path = folder.join(name);
                let text = std::fs::read_to_string(&path).map_err(|e| {
                    Error::Input(format!("cannot read {}: {e}", quoted(&path.to_string_lossy())))
                })?;
                let (names, columns) = csv(&text).map_err(|e| e.at(&quoted(name)))?;
                (names, Values::Columns(columns))
            }
        };
        let names: Vec<String> = names;
        if names.is_empty() {
            return input("[ensemble] names nothing that differs from member to member");
        }
        let targets = names.iter().map(|name| Ok(quantity(plan, name)?.0)).collect::<Result<_, Error>>()?;
        if let Some(k) = (0..names.len()).find(|&k| names[..k].contains(&names[k])) {
            return input(format!("[ensemble] names {} twice", names[k]));
        }
        let count = match (&values, &spec.source) {
            (Values::Grid(axes), _) => {
                axes.iter().fold(1, |count: usize, axis| count.saturating_mul(axis.points))
            }
            (Values::Columns(columns), _) => columns.first().map_or(0, Vec::len),
            (Values::Random { .. }, Source::Random { members, .. }) => *members,
            (Values::Random { .. }, _) => 0,
        };
        if count == 0 {
            return input("[ensemble] has no members");
        }
        Ok(Self { names, targets, values, count })
    }

    /// The two axes, where the members lie on such a grid.
    pub fn grid(&self) -> Option<[&Axis; 2]> {
        match &self.values {
            Values::Grid(axes) if axes.len() == 2 => Some([&axes[0], &axes[1]]),
            _ => None,
        }
    }

    /// The values of a member, in the order of the names.
    pub fn values(&self, member: usize) -> Vec<f64> {
        match &self.values {
            Values::Grid(axes) => {
                let mut rest = member;
                let value = |axis: &Axis| {
                    let x = axis.value(rest % axis.points);
                    rest /= axis.points;
                    x
                };
                axes.iter().map(value).collect()
            }
            Values::Columns(columns) => columns.iter().map(|column| column[member]).collect(),
            Values::Random { ranges, seed } => {
                // Each member has its own part of the sequence.
                let mut random = Random::after(*seed, member as u64 * ranges.len() as u64);
                ranges.iter().map(|[low, high]| random.between(*low, *high)).collect()
            }
        }
    }

    /// A hash of the members: a file may have changed under its name.
    pub fn digest(&self) -> String {
        let mut hasher = Hasher::default();
        match &self.values {
            Values::Columns(columns) => columns.iter().flatten().for_each(|x| hasher.add(*x)),
            // The others are worked out from a few numbers, which the first and the last member show.
            _ => [0, self.count - 1].iter().flat_map(|k| self.values(*k)).for_each(|x| hasher.add(x)),
        }
        hasher.add(self.count as f64);
        hasher.hex()
    }

    /// Whether two members have the same parameters: they are then neighbours in the lanes of a block.
    pub fn alike(&self, a: &[f64], b: &[f64]) -> bool {
        let parameters =
            self.targets.iter().zip(a.iter().zip(b)).filter(|(target, _)| **target == Target::Parameter);
        parameters.into_iter().all(|(_, (a, b))| a.to_bits() == b.to_bits())
    }

    /// The scenario with the parameters of a member.
    pub fn scenario(&self, scenario: &Scenario, values: &[f64]) -> Scenario {
        let mut own = scenario.clone();
        for ((name, target), x) in self.names.iter().zip(&self.targets).zip(values) {
            if *target == Target::Parameter {
                Scenario::set(&mut own.parameters, name, Value::number(*x));
            }
        }
        own
    }

    /// The names of starts, and their values of a member.
    pub fn starts<'a>(&'a self, values: &'a [f64]) -> impl Iterator<Item = (&'a str, f64)> {
        let all = self.names.iter().zip(&self.targets).zip(values);
        all.filter(|((_, target), _)| **target == Target::Start).map(|((name, _), x)| (name.as_str(), *x))
    }
}

/// Name and unit of what varies.
pub(super) fn label(plan: &Plan, name: &str) -> Result<String, Error> {
    Ok(label_of(&quantity(plan, name)?.1))
}

/// The quantity of a name: a start, or a parameter that is a number.
fn quantity(plan: &Plan, name: &str) -> Result<(Target, Quantity), Error> {
    let starts: Vec<Quantity> =
        plan.layout.state().into_iter().chain(plan.card.starts.iter().cloned()).collect();
    if let Some(start) = starts.iter().find(|q| q.name == name) {
        return Ok((Target::Start, start.clone()));
    }
    let numbers = plan.card.parameters.iter().filter(|p| matches!(p.default, Default::Number(_)));
    let numbers: Vec<Quantity> = numbers.map(|p| p.quantity.clone()).collect();
    if let Some(parameter) = numbers.iter().find(|q| q.name == name) {
        return Ok((Target::Parameter, parameter.clone()));
    }
    let names = starts.iter().chain(&numbers).map(|q| q.name.as_str());
    Err(unknown(&format!("start or parameter of {}", plan.card.id), name, names).at("[ensemble]"))
}

/// Numbers between colons, in the unit of a quantity.
fn numbers(plan: &Plan, name: &str, parts: &[&str]) -> Result<Vec<f64>, Error> {
    let (_, quantity) = quantity(plan, name)?;
    let number = |text: &&str| {
        let x = value::parse(text.trim()).and_then(|v| v.in_unit(&quantity.unit))?;
        within(&quantity, x)
    };
    parts.iter().map(number).collect::<Result<_, _>>().map_err(|e| e.at(&format!("[ensemble]: {name}")))
}

fn within(quantity: &Quantity, x: f64) -> Result<f64, Error> {
    if quantity.range.contains(x) { Ok(x) } else { input(format!("{} cannot be {x}", quantity.name)) }
}

fn axis(plan: &Plan, name: &str, text: &str) -> Result<Axis, Error> {
    let parts: Vec<&str> = text.split(':').collect();
    let points = parts.get(2).and_then(|n| n.trim().parse().ok());
    let (3, Some(points)) = (parts.len(), points) else {
        return input(format!(
            "[ensemble]: {name}: a grid is written as \"LOW:HIGH:N\", not {}",
            quoted(text)
        ));
    };
    let ends = numbers(plan, name, &parts[..2])?;
    Ok(Axis { name: name.into(), low: ends[0], high: ends[1], points })
}

fn range(plan: &Plan, name: &str, text: &str) -> Result<[f64; 2], Error> {
    let parts: Vec<&str> = text.split(':').collect();
    if parts.len() != 2 {
        return input(format!(
            "[ensemble]: {name}: a range is written as \"LOW:HIGH\", not {}",
            quoted(text)
        ));
    }
    let ends = numbers(plan, name, &parts)?;
    Ok([ends[0], ends[1]])
}

fn columns(plan: &Plan, lists: &[(String, Vec<Value>)]) -> Result<Vec<Vec<f64>>, Error> {
    let mut columns: Vec<Vec<f64>> = vec![];
    for (name, values) in lists {
        let (_, quantity) = quantity(plan, name)?;
        if columns.first().is_some_and(|first| first.len() != values.len()) {
            let (first, own) = (columns[0].len(), values.len());
            return input(format!("[ensemble]: {name} has {own} values, {} has {first}", lists[0].0));
        }
        let number = |(k, value): (usize, &Value)| {
            let x = value.in_unit(&quantity.unit).and_then(|x| within(&quantity, x));
            x.map_err(|e| e.at(&format!("[ensemble]: {name}: value {}", k + 1)))
        };
        columns.push(values.iter().enumerate().map(number).collect::<Result<_, _>>()?);
    }
    Ok(columns)
}

/// Names and columns of a CSV file.
fn csv(text: &str) -> Result<(Vec<String>, Vec<Vec<f64>>), Error> {
    let mut lines = text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty());
    let Some((_, first)) = lines.next() else { return input("the file is empty") };
    let names: Vec<String> = first.split(',').map(|name| name.trim().trim_matches('"').to_string()).collect();
    let mut columns = vec![vec![]; names.len()];
    for (row, line) in lines {
        let cells: Vec<&str> = line.split(',').collect();
        if cells.len() != names.len() {
            return input(format!(
                "row {} has {} values, the first row {} names",
                row + 1,
                cells.len(),
                names.len()
            ));
        }
        for ((cell, name), column) in cells.iter().zip(&names).zip(&mut columns) {
            match cell.trim().parse::<f64>() {
                Ok(x) if x.is_finite() => column.push(x),
                _ => {
                    return input(format!(
                        "row {}, column {name}: {} is not a finite number",
                        row + 1,
                        quoted(cell.trim())
                    ));
                }
            }
        }
    }
    Ok((names, columns))
}
