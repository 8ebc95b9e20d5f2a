//! Names and units held against a card.

use crate::error::{Error, input, quoted, unknown};
use crate::plan::{Plan, Watch};
use crate::scenario::EventSpec;
use crate::value::{self, Value};
use precess_system::{AnySystem, Card, Default, Direction, Given, Layout, Parameter, Quantity, Values};
use std::collections::{HashMap, HashSet};

/// Parameters: the card's defaults, then what is given.
pub(crate) fn parameters(card: &Card, given: &[(String, Value)]) -> Result<Values<f64>, Error> {
    let mut values = Values::defaults(card);
    for (name, value) in given {
        let Some(index) = card.parameters.iter().position(|p| p.quantity.name == *name) else {
            let names = card.parameters.iter().map(|p| p.quantity.name.as_str());
            return Err(unknown(&format!("parameter of {}", card.id), name, names));
        };
        let parameter = &card.parameters[index];
        // Each kind of parameter is stored in its own list, in the order of the card.
        let same_kind =
            |p: &&Parameter| std::mem::discriminant(&p.default) == std::mem::discriminant(&parameter.default);
        let place = card.parameters[..index].iter().filter(same_kind).count();
        let at = |e: Error| e.at(name);
        match &parameter.default {
            Default::Number(_) => values.numbers[place] = within(&parameter.quantity, value).map_err(at)?,
            Default::List { fields, .. } => {
                values.lists[place].items = items(parameter, fields, value).map_err(at)?;
            }
            Default::Choice(options) => values.choices[place] = option(options, value).map_err(at)?,
        }
    }
    Ok(values)
}

/// A number in the unit and the range of its quantity.
fn within(quantity: &Quantity, value: &Value) -> Result<f64, Error> {
    let x = value.in_unit(&quantity.unit)?;
    let range = quantity.range;
    if range.contains(x) {
        return Ok(x);
    }
    input(match (range.open, range.high.is_finite()) {
        (true, false) => format!("must be above {}, not {x}", range.low),
        (false, false) => format!("must not be below {}, but is {x}", range.low),
        _ => format!("lies between {} and {}, not at {x}", range.low, range.high),
    })
}

fn items(parameter: &Parameter, fields: &[&str], value: &Value) -> Result<Vec<f64>, Error> {
    let Value::List(items) = value else {
        return input("a list is needed here, in brackets with ';' between its items");
    };
    if items.is_empty() {
        return input("the list is empty");
    }
    if items.len() > parameter.longest {
        return input(format!("{} items are too many: at most {}", items.len(), parameter.longest));
    }
    let mut numbers = vec![];
    for (k, item) in items.iter().enumerate() {
        let at = |e: Error| e.at(&format!("item {}", k + 1));
        match item {
            Value::List(row) if fields.len() > 1 => {
                if row.len() != fields.len() {
                    let names = fields.join("; ");
                    return Err(at(Error::Input(format!("{} numbers are needed: [{names}]", fields.len()))));
                }
                for number in row {
                    numbers.push(number.in_unit("").map_err(at)?);
                }
            }
            number if fields.len() == 1 => numbers.push(within(&parameter.quantity, number).map_err(at)?),
            _ => return Err(at(Error::Input(format!("a list is needed: [{}]", fields.join("; "))))),
        }
    }
    Ok(numbers)
}

fn option(options: &[&str], value: &Value) -> Result<usize, Error> {
    let Value::Word(word) = value else {
        return input(format!("one of the words {} is needed here", options.join(", ")));
    };
    let found = options.iter().position(|o| o == word);
    found.ok_or_else(|| unknown("choice", word, options.iter().copied()))
}

/// Layout and full state at the start: the card's defaults, then what is given.
pub(crate) fn start(
    system: &dyn AnySystem,
    card: &Card,
    values: &Values<f64>,
    given: &[(String, Value)],
) -> Result<(Layout, Vec<f64>), Error> {
    let names = Given(given.iter().map(|(name, _)| (name.clone(), 0.0)).collect());
    let layout = system.layout(values, &names);
    let quantities = || layout.quantities().chain(card.starts.iter().cloned());
    // Of a million quantities those that are named. A map; it is asked, not walked.
    let named: HashSet<&str> = given.iter().map(|(name, _)| name.as_str()).collect();
    let known: HashMap<String, Quantity> = match given {
        [] => HashMap::new(),
        _ => quantities().filter(|q| named.contains(&*q.name)).map(|q| (q.name.clone(), q)).collect(),
    };
    let mut starts = Given::default();
    for (name, value) in given {
        let Some(quantity) = known.get(name) else {
            let names: Vec<String> = quantities().map(|q| q.name).collect();
            return Err(unknown(&format!("start of {}", card.id), name, names.iter().map(String::as_str)));
        };
        starts.0.push((name.clone(), within(quantity, value).map_err(|e| e.at(name))?));
    }
    let state = system.start(values, &layout, &starts).map_err(Error::Input)?;
    Ok((layout, state))
}

/// The column of this name.
pub(crate) fn column(plan: &Plan, name: &str) -> Result<usize, Error> {
    let mut names = (0..plan.width()).map(|k| plan.column(k).name);
    names.position(|own| own == name).ok_or_else(|| {
        let columns = plan.columns();
        unknown(&format!("quantity of {}", plan.card.id), name, columns.iter().map(|q| q.name.as_str()))
    })
}

/// A direction by its name.
pub(crate) fn direction(name: &str) -> Result<Direction, Error> {
    match name {
        "rising" => Ok(Direction::Rising),
        "falling" => Ok(Direction::Falling),
        "either" => Ok(Direction::Either),
        other => Err(unknown("direction", other, ["rising", "falling", "either"])),
    }
}

/// `theta = 0`: the quantity and the value it passes through.
pub(crate) fn watch(plan: &Plan, event: &EventSpec) -> Result<Watch, Error> {
    let at = |e: Error| e.at(&format!("event {}", quoted(&event.when)));
    let Some((name, text)) = event.when.split_once('=') else {
        return input("a crossing is written as \"theta = 0\"").map_err(at);
    };
    let column = column(plan, name.trim()).map_err(at)?;
    let unit = &plan.column(column).unit;
    let value = value::parse(text).and_then(|v| v.in_unit(unit)).map_err(at)?;
    let direction = direction(event.direction.as_deref().unwrap_or("either")).map_err(at)?;
    let name = event.name.clone().unwrap_or_else(|| event.when.clone());
    Ok(Watch { name, column, value, direction, stop: event.stop })
}
