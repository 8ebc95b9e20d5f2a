//! Starts on a grid: every combination of values of a few named quantities.

use crate::error::{Error, input, quoted, unknown};
use crate::plan::Plan;
use crate::value;
use precess_system::Quantity;

/// Evenly spaced starts of one quantity, both ends included.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// Name of an initial value.
    pub name: String,
    /// First value.
    pub low: f64,
    /// Last value.
    pub high: f64,
    /// How many.
    pub points: usize,
}

impl Axis {
    /// The k-th value.
    pub fn value(&self, k: usize) -> f64 {
        if self.points < 2 {
            return self.low;
        }
        self.low + (self.high - self.low) * (k as f64 / (self.points - 1) as f64)
    }
}

impl Axis {
    /// From `x=-2:2:200`: name, first and last value (with units, if need be), number of points.
    ///
    /// # Errors
    /// Where the text is no axis, or the name no initial value of the plan.
    pub fn parse(plan: &Plan, text: &str) -> Result<Self, Error> {
        let at = |e: Error| e.at(&format!("grid {}", quoted(text)));
        let wrong = || input("a grid is written as NAME=LOW:HIGH:N, such as x=-2:2:200").map_err(at);
        let Some((name, range)) = text.split_once('=') else { return wrong() };
        let parts: Vec<&str> = range.split(':').collect();
        let [low, high, points] = parts[..] else { return wrong() };
        let unit = &quantities(plan, [name.trim()]).map_err(at)?[0].unit;
        let number = |text: &str| value::parse(text.trim()).and_then(|v| v.in_unit(unit)).map_err(at);
        let Ok(points) = points.trim().parse() else {
            return input(format!("{} is no number of points", quoted(points.trim()))).map_err(at);
        };
        Ok(Self { name: name.trim().into(), low: number(low)?, high: number(high)?, points })
    }
}

/// More starts than this do not fit a machine's memory.
const MOST: usize = 100_000_000;

/// The initial values that a plan may be given, and the error where one has no such name.
fn quantities<'a>(plan: &Plan, names: impl IntoIterator<Item = &'a str>) -> Result<Vec<Quantity>, Error> {
    let all: Vec<Quantity> =
        plan.layout.state().into_iter().chain(plan.card.starts.iter().cloned()).collect();
    let named = names.into_iter().map(|name| {
        all.iter().find(|q| q.name == name).cloned().ok_or_else(|| {
            unknown(&format!("start of {}", plan.card.id), name, all.iter().map(|q| q.name.as_str()))
        })
    });
    named.collect()
}

fn within(quantity: &Quantity, x: f64) -> Result<(), Error> {
    if quantity.range.contains(x) { Ok(()) } else { input(format!("{} cannot start at {x}", quantity.name)) }
}

/// Full states at the start, one after another: the plan's own with rows of values in place of the named ones.
///
/// # Errors
/// Where a name is no initial value, or a start makes no sense.
pub fn starts(
    plan: &Plan,
    names: &[&str],
    rows: &mut dyn Iterator<Item = Vec<f64>>,
) -> Result<Vec<f64>, Error> {
    let quantities = quantities(plan, names.iter().copied())?;
    let mut given = plan.given();
    let mut places = vec![];
    for name in names {
        let place = given.0.iter().position(|(known, _)| known == name).unwrap_or_else(|| {
            // None of the state's own (an angle of a body given by its quaternion): it goes behind them.
            given.0.push(((*name).into(), 0.0));
            given.0.len() - 1
        });
        places.push(place);
    }
    let mut starts = vec![];
    for values in rows {
        for ((quantity, &place), x) in quantities.iter().zip(&places).zip(values) {
            within(quantity, x)?;
            given.0[place].1 = x;
        }
        starts.extend(plan.system.start(&plan.values, &plan.layout, &given).map_err(Error::Input)?);
    }
    Ok(starts)
}

/// Every combination of values, the first side running fastest.
pub fn combinations(sides: &[Vec<f64>]) -> impl Iterator<Item = Vec<f64>> + '_ {
    (0..sides.iter().map(Vec::len).product()).map(move |mut rest: usize| {
        let pick = |side: &Vec<f64>| {
            let x = side[rest % side.len()];
            rest /= side.len();
            x
        };
        sides.iter().map(pick).collect()
    })
}

/// The [`starts`] on a grid. The first axis runs fastest.
///
/// # Errors
/// Where a name is no initial value, an axis has no points or too many, or a start makes no sense.
pub fn grid(plan: &Plan, axes: &[Axis]) -> Result<Vec<f64>, Error> {
    let mut members = 1_usize;
    for axis in axes {
        let quantity = &quantities(plan, [axis.name.as_str()])?[0];
        if axis.points == 0 {
            return input(format!("the grid along {} has no points", axis.name));
        }
        within(quantity, axis.low)?;
        within(quantity, axis.high)?;
        members = members.saturating_mul(axis.points);
    }
    if members > MOST {
        return input(format!("{members} starts are too many: at most {MOST}"));
    }
    let names: Vec<&str> = axes.iter().map(|axis| axis.name.as_str()).collect();
    let sides: Vec<Vec<f64>> =
        axes.iter().map(|axis| (0..axis.points).map(|k| axis.value(k)).collect()).collect();
    starts(plan, &names, &mut combinations(&sides))
}
