//! Values as people write them in Python: a number, a text such as "30 deg", a list or an array of them.

use crate::error::{InputError, exception};
use precess::value::{self, Value};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyMapping, PyString};

/// Nesting beyond this is a mistake.
const DEEPEST: usize = 8;

/// The values of a dictionary, in its order.
pub fn values(given: &Bound<PyDict>) -> PyResult<Vec<(String, Value)>> {
    given.iter().map(|(name, value)| named(&name, &value)).collect()
}

fn named(name: &Bound<PyAny>, given: &Bound<PyAny>) -> PyResult<(String, Value)> {
    let Ok(name) = name.extract::<String>() else {
        return Err(PyTypeError::new_err("a name is a text"));
    };
    let value = read(&name, given, 0)?;
    Ok((name, value))
}

fn read(name: &str, given: &Bound<PyAny>, depth: usize) -> PyResult<Value> {
    let wrong = || {
        let kind = given.get_type().name().map_or_else(|_| "that".into(), |kind| kind.to_string());
        PyTypeError::new_err(format!(
            "{name}: a number, a text such as '30 deg' or a list is needed, not {kind}"
        ))
    };
    if let Ok(text) = given.cast::<PyString>() {
        return value::parse(text.to_str()?).map_err(|e| exception(e.at(name)));
    }
    if given.is_instance_of::<PyBool>() || given.cast::<PyMapping>().is_ok() || depth > DEEPEST {
        return Err(wrong());
    }
    // An array of no dimension has no length and is a number.
    if given.len().is_ok() {
        let items = given.try_iter().map_err(|_| wrong())?;
        return items.map(|item| read(name, &item?, depth + 1)).collect::<PyResult<_>>().map(Value::List);
    }
    let x: f64 = given.extract().map_err(|_| wrong())?;
    if x.is_finite() {
        Ok(Value::number(x))
    } else {
        Err(InputError::new_err(format!("{name}: {x} is not a finite number")))
    }
}
