//! The numbers of a plan that may be moved, by name: those of the start, and numeric parameters.

use crate::error::{Error, input, unknown};
use crate::plan::Plan;
use precess_system::{Default, Values};

/// The number of this name: `l`, or `masses[0]`.
pub(crate) fn parameter<'a, S>(plan: &Plan, name: &str, values: &'a mut Values<S>) -> Option<&'a mut S> {
    let (stem, item) = match name.strip_suffix(']').and_then(|n| n.split_once('[')) {
        Some((stem, item)) => (stem, Some(item.parse::<usize>().ok()?)),
        None => (name, None),
    };
    let (mut numbers, mut lists) = (0, 0);
    for parameter in &plan.card.parameters {
        let here = parameter.quantity.name == stem;
        match (&parameter.default, item) {
            (Default::Number(_), None) if here => return values.numbers.get_mut(numbers),
            (Default::List { .. }, Some(item)) if here => {
                let list = values.lists.get_mut(lists)?;
                return if list.width == 1 { list.items.get_mut(item) } else { None };
            }
            (Default::Number(_), _) => numbers += 1,
            (Default::List { .. }, _) => lists += 1,
            (Default::Choice(_), _) => {}
        }
    }
    None
}

/// The unit of a number of the start, or of a parameter.
pub(crate) fn unit_of(plan: &Plan, name: &str) -> String {
    let stem = name.split('[').next().unwrap_or(name);
    let parameters = plan.card.parameters.iter().map(|p| &p.quantity);
    let found = parameters.chain(&plan.columns()).find(|q| q.name == stem).map(|q| q.unit.clone());
    found.unwrap_or_default()
}

/// That there is a number of this name.
pub(crate) fn exists(plan: &Plan, name: &str) -> Result<(), Error> {
    let state = plan.layout.state();
    if state.iter().any(|q| q.name == name) || parameter(plan, name, &mut plan.values.clone()).is_some() {
        return Ok(());
    }
    let numbers = plan.card.parameters.iter().filter(|p| matches!(p.default, Default::Number(_)));
    let known = state.iter().map(|q| q.name.as_str()).chain(numbers.map(|p| p.quantity.name.as_str()));
    Err(unknown(&format!("start or numeric parameter of {}", plan.card.id), name, known))
}

impl Plan {
    /// A number of the start, or a numeric parameter (`l`, `masses[0]`); NaN where there is none.
    pub fn number(&self, name: &str) -> f64 {
        match self.layout.state().iter().position(|q| q.name == name) {
            Some(k) => self.start[k],
            None => parameter(self, name, &mut self.values.clone()).map_or(f64::NAN, |x| *x),
        }
    }

    /// Moves it by so much.
    ///
    /// # Errors
    /// Where there is no such number, or the new value is out of its range.
    pub fn shift(&mut self, name: &str, by: f64) -> Result<(), Error> {
        self.set(name, self.number(name) + by)
    }

    /// Sets it.
    pub(crate) fn set(&mut self, name: &str, x: f64) -> Result<(), Error> {
        let state = self.layout.state();
        if let Some(k) = state.iter().position(|q| q.name == name) {
            self.start[k] = x;
            return if state[k].range.contains(x) { Ok(()) } else { input("out of range") };
        }
        let stem = name.split('[').next().unwrap_or(name);
        let quantity =
            self.card.parameters.iter().find(|p| p.quantity.name == stem).map(|p| p.quantity.range);
        let mut values = self.values.clone();
        match parameter(self, name, &mut values) {
            Some(place) if quantity.is_some_and(|range| range.contains(x)) => *place = x,
            _ => return input("out of range"),
        }
        self.values = values;
        self.structure = precess_system::structure(self.system, &self.values, &self.layout);
        Ok(())
    }
}
