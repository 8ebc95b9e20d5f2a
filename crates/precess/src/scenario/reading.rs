//! TOML as a person wrote it, with a sentence for what is something else.

use crate::error::{Error, input, quoted};
use crate::value::{self, Value};
use std::borrow::Cow;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// The entries of a table in the order of the file, so that the first mistake is the one reported.
pub(super) fn entries<'a, 'i>(table: &'a DeTable<'i>) -> Vec<(&'a Spanned<Cow<'i, str>>, &'a DeValue<'i>)> {
    let mut entries: Vec<_> = table.iter().map(|(key, value)| (key, value.get_ref())).collect();
    entries.sort_by_key(|(key, _)| key.span().start);
    entries
}

pub(super) fn line_of(text: &str, offset: usize) -> usize {
    text.as_bytes().iter().take(offset).filter(|b| **b == b'\n').count() + 1
}
pub(super) fn kind<T>(wanted: &str, value: &DeValue) -> Result<T, Error> {
    input(format!("{wanted} is needed here, not {}", value.type_str()))
}
pub(super) fn as_table<'a, 'i>(value: &'a DeValue<'i>) -> Result<&'a DeTable<'i>, Error> {
    value.as_table().map_or_else(|| kind("a table", value), Ok)
}
pub(super) fn tables<T>(
    value: &DeValue,
    read: impl Fn(&DeTable) -> Result<T, Error>,
) -> Result<Vec<T>, Error> {
    let Some(items) = value.as_array() else { return kind("a list of tables ([[...]])", value) };
    items.iter().map(|item| read(as_table(item.get_ref())?)).collect()
}
pub(super) fn word(value: &DeValue) -> Result<String, Error> {
    value.as_str().map_or_else(|| kind("a text in quotes", value), |s| Ok(s.to_string()))
}
pub(super) fn flag(value: &DeValue) -> Result<bool, Error> {
    value.as_bool().map_or_else(|| kind("true or false", value), Ok)
}
pub(super) fn integer(value: &DeValue) -> Result<String, Error> {
    value.as_integer().map_or_else(|| kind("a whole number", value), |n| Ok(n.as_str().to_string()))
}
pub(super) fn values(text: &str, table: &DeTable) -> Result<Vec<(String, Value)>, Error> {
    let read = entries(table).into_iter().map(|(key, value)| {
        let at = |e: Error| e.at(&format!("line {}: {}", line_of(text, key.span().start), key.get_ref()));
        Ok((key.get_ref().to_string(), read(value).map_err(at)?))
    });
    read.collect()
}

/// A value: a number, a text such as "30 deg", a list.
pub(super) fn read(value: &DeValue) -> Result<Value, Error> {
    match value {
        DeValue::Integer(n) => number(n.as_str(), n.radix()),
        DeValue::Float(x) => number(x.as_str(), 10),
        DeValue::String(text) => value::parse(text),
        DeValue::Boolean(flag) => Ok(Value::Word(flag.to_string())),
        DeValue::Array(items) => {
            items.iter().map(|i| read(i.get_ref())).collect::<Result<_, _>>().map(Value::List)
        }
        other => kind("a number, a text or a list", other),
    }
}
pub(super) fn number(digits: &str, radix: u32) -> Result<Value, Error> {
    let digits = digits.replace('_', "");
    let parsed = if radix == 10 {
        digits.parse::<f64>().ok()
    } else {
        i64::from_str_radix(&digits, radix).ok().map(|n| n as f64)
    };
    match parsed {
        Some(x) if x.is_finite() => Ok(Value::number(x)),
        _ => input(format!("{} is not a finite number", quoted(&digits))),
    }
}

/// A text, or a list of texts.
pub(super) fn words(value: &DeValue) -> Result<Vec<String>, Error> {
    match value {
        DeValue::Array(names) => names.iter().map(|n| word(n.get_ref())).collect(),
        one => Ok(vec![word(one)?]),
    }
}

/// A table of texts.
pub(super) fn texts(table: &DeTable) -> Result<Vec<(String, String)>, Error> {
    let text = |(key, value): (&Spanned<Cow<str>>, &DeValue)| Ok((key.get_ref().to_string(), word(value)?));
    entries(table).into_iter().map(text).collect()
}

/// A small whole number.
pub(super) fn number_of(value: &DeValue, most: usize) -> Result<usize, Error> {
    let text = integer(value)?;
    match text.parse::<usize>() {
        Ok(n) if n <= most => Ok(n),
        _ => input(format!("a whole number from 0 to {most} is needed here, not {}", quoted(&text))),
    }
}

/// Two values, from and to.
pub(super) fn pair(value: &DeValue) -> Result<[Value; 2], Error> {
    two(read(value)?)
}

/// A list of two values.
pub(super) fn two(value: Value) -> Result<[Value; 2], Error> {
    match value {
        Value::List(ends) if ends.len() == 2 => Ok([ends[0].clone(), ends[1].clone()]),
        _ => input("two values in brackets are needed here"),
    }
}

/// The items of a list; a single value is a list of one.
pub(super) fn several(value: Value) -> Vec<Value> {
    match value {
        Value::List(items) => items,
        one => vec![one],
    }
}

/// A list, or a text such as `-2:2:9` (evenly spaced, both ends included), or a single value.
pub(super) fn line(value: &DeValue, most: usize) -> Result<Vec<Value>, Error> {
    if let DeValue::String(text) = value
        && let [low, high, points] = text.split(':').collect::<Vec<_>>()[..]
    {
        return evenly(low, high, points, most);
    }
    match read(value)? {
        Value::List(items) if items.is_empty() => input("the list is empty"),
        Value::List(items) => Ok(items),
        one => Ok(vec![one]),
    }
}

fn evenly(low: &str, high: &str, points: &str, most: usize) -> Result<Vec<Value>, Error> {
    let count = value::parse(points)?.in_unit("")?;
    if !(count.trunc() == count && (2.0..=most as f64).contains(&count)) {
        return input(format!("the number of values lies between 2 and {most}, not at {count}"));
    }
    let (low, high) = (value::parse(low)?, value::parse(high)?);
    let (Value::Number { x: a, dimension }, Value::Number { x: b, dimension: other }) = (low, high) else {
        return input("a line of values goes from a number to a number: \"-2:2:9\"");
    };
    if dimension != other {
        return input("both ends of a line of values have the same unit, or none");
    }
    let at = |k: usize| Value::Number { x: a + (b - a) * (k as f64 / (count - 1.0)), dimension };
    Ok((0..count as usize).map(at).collect())
}
