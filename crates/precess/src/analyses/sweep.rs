//! Values of a parameter one after another, and parts of the space of states.

use crate::error::{Error, input, quoted, unknown};
use crate::plan::Plan;
use crate::scenario::Scenario;
use crate::value::{self, Value};
use precess_system::Quantity;

/// `frequency=0.2:3:200`: evenly spaced values of a parameter, both ends included.
#[derive(Clone, Debug, PartialEq)]
pub struct Sweep {
    /// Name of a numeric parameter.
    pub name: String,
    /// First value.
    pub low: Value,
    /// Last value.
    pub high: Value,
    /// How many.
    pub points: usize,
}

/// More values than this nobody waits for.
const MOST: f64 = 1e5;

impl Sweep {
    /// Reads one.
    ///
    /// # Errors
    /// One sentence, where that is none.
    pub fn parse(text: &str) -> Result<Self, Error> {
        let parts =
            text.split_once('=').map(|(name, range)| (name.trim(), range.split(':').collect::<Vec<_>>()));
        let Some((name, [low, high, points])) = parts.as_ref().map(|(n, p)| (*n, &p[..])) else {
            return input(format!("{} is no NAME=LOW:HIGH:N, such as frequency=0.2:3:200", quoted(text)));
        };
        let points = value::parse(points).and_then(|v| v.in_unit("")).map_err(|e| e.at(name))?;
        if !(points.fract() == 0.0 && (2.0..=MOST).contains(&points)) {
            return input(format!("{name}: the number of values lies between 2 and {MOST}, not at {points}"));
        }
        let read = |text: &&str| value::parse(text).map_err(|e| e.at(name));
        Ok(Self { name: name.into(), low: read(low)?, high: read(high)?, points: points as usize })
    }

    /// The parameter that is swept.
    ///
    /// # Errors
    /// Where there is no numeric one of this name.
    pub fn quantity(&self, plan: &Plan) -> Result<Quantity, Error> {
        let numeric =
            |p: &&precess_system::Parameter| matches!(p.default, precess_system::Default::Number(_));
        let known: Vec<_> = plan.card.parameters.iter().filter(numeric).map(|p| &p.quantity).collect();
        let found = known.iter().find(|q| q.name == self.name);
        found.map(|q| (*q).clone()).ok_or_else(|| {
            let what = format!("numeric parameter of {}", plan.card.id);
            unknown(&what, &self.name, known.iter().map(|q| q.name.as_str()))
        })
    }

    /// The values in the parameter's unit.
    ///
    /// # Errors
    /// Where an end has another unit.
    pub fn numbers(&self, plan: &Plan) -> Result<Vec<f64>, Error> {
        let unit = self.quantity(plan)?.unit;
        let end = |value: &Value| value.in_unit(&unit).map_err(|e| e.at(&self.name));
        let (low, high) = (end(&self.low)?, end(&self.high)?);
        let value = |k: usize| low + (high - low) * (k as f64 / (self.points - 1) as f64);
        Ok((0..self.points).map(value).collect())
    }
}

/// The plan with other values of parameters. Panels and families stay behind.
pub(crate) fn at(scenario: &Scenario, values: &[(String, f64)]) -> Result<Plan, Error> {
    let mut own = Scenario { families: vec![], figures: vec![], ..scenario.clone() };
    for (name, x) in values {
        Scenario::set(&mut own.parameters, name, Value::number(*x));
    }
    Plan::new(&own)
}

/// `x=-2:2`: a range of a number of the state.
#[derive(Clone, Debug, PartialEq)]
pub struct Window {
    /// Name of a coordinate or velocity.
    pub name: String,
    /// From.
    pub low: Value,
    /// To.
    pub high: Value,
}

impl Window {
    /// Reads one.
    ///
    /// # Errors
    /// One sentence, where that is none.
    pub fn parse(text: &str) -> Result<Self, Error> {
        let parts = text.split_once('=').and_then(|(n, r)| r.split_once(':').map(|(a, b)| (n.trim(), a, b)));
        let Some((name, low, high)) = parts else {
            return input(format!("{} is no NAME=LOW:HIGH, such as x=-2:2", quoted(text)));
        };
        let read = |text: &str| value::parse(text).map_err(|e| e.at(name));
        Ok(Self { name: name.into(), low: read(low)?, high: read(high)? })
    }

    /// The range in the quantity's unit.
    pub(crate) fn range(&self, unit: &str) -> Result<(f64, f64), Error> {
        let end = |value: &Value| value.in_unit(unit).map_err(|e| e.at(&self.name));
        let (low, high) = (end(&self.low)?, end(&self.high)?);
        if low < high { Ok((low, high)) } else { input(format!("{}: {low} is not below {high}", self.name)) }
    }
}
