//! The equations themselves: rates, their Jacobian, and the recorded expressions.

use crate::error::InputError;
use crate::plan::Plan;
use numpy::{IntoPyArray, PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1};
use precess::record;
use precess::scalar::{Dual, Entry};
use precess::system::{Bind, Default};
use pyo3::prelude::*;

/// The full state of a plan from the numbers that are reported.
fn full(plan: &precess::Plan, y: &PyReadonlyArray1<f64>) -> PyResult<Vec<f64>> {
    let state = plan.layout.shape().state();
    let id = plan.card.id;
    if plan.structure.hybrid {
        return Err(InputError::new_err(format!("{id} has events, which its rates alone do not tell")));
    }
    let mut full = plan.start.clone();
    let y = y.as_array();
    if y.len() != state {
        return Err(InputError::new_err(format!("a state of {id} has {state} numbers, not {}", y.len())));
    }
    full.iter_mut().zip(y).for_each(|(place, x)| *place = *x);
    Ok(full)
}

/// The rate of a state.
#[pyfunction]
pub fn rate<'py>(
    py: Python<'py>,
    plan: &Plan,
    t: f64,
    y: PyReadonlyArray1<f64>,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let plan = &plan.plan;
    let y = full(plan, &y)?;
    let mut dy = vec![0.0; y.len()];
    Bind::<f64>::bind(plan.system, plan.values.clone(), &plan.layout).rate(t, &y, &mut dy);
    dy.truncate(plan.layout.shape().state());
    Ok(dy.into_pyarray(py))
}

/// Its derivatives with respect to the state, by dual numbers: a row for each rate.
#[pyfunction]
pub fn jacobian<'py>(
    py: Python<'py>,
    plan: &Plan,
    t: f64,
    y: PyReadonlyArray1<f64>,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let plan = &plan.plan;
    let y = full(plan, &y)?;
    let size = plan.layout.shape().state();
    let field = Bind::<Dual<f64>>::bind(plan.system, plan.values.map(|&x| Dual::from(x)), &plan.layout);
    let mut dual: Vec<Dual<f64>> = y.iter().map(|&x| Dual::from(x)).collect();
    let mut rate = dual.clone();
    let mut rows = vec![0.0; size * size];
    for column in 0..size {
        dual[column].slope = 1.0;
        field.rate(Dual::from(t), &dual, &mut rate);
        dual[column].slope = 0.0;
        for row in 0..size {
            rows[row * size + column] = rate[row].slope;
        }
    }
    rows.into_pyarray(py).reshape([size, size])
}

/// An operation: its name, what it is computed from, and a number where it has one.
type Operation = (String, Vec<usize>, f64);

/// The equations of motion as recorded: the names of the inputs, the operations, where the highest derivative of each
/// coordinate stands.
#[pyfunction]
pub fn expressions(plan: &Plan) -> (Vec<String>, Vec<Operation>, Vec<usize>) {
    let plan = &plan.plan;
    let tape = record(plan.system, &plan.values, &plan.layout).simplified();
    let mut names = vec!["t".to_string()];
    names.extend(plan.layout.state().into_iter().map(|q| q.name));
    names.extend((0..plan.layout.modes).map(|k| format!("mode{k}")));
    let (mut numbers, mut items) = (vec![], vec![]);
    let mut lists = plan.values.lists.iter();
    for parameter in &plan.card.parameters {
        let name = &parameter.quantity.name;
        match &parameter.default {
            Default::Number(_) => numbers.push(name.clone()),
            Default::List { fields, .. } => {
                let length = lists.next().map_or(0, |list| list.items.len() / list.width);
                items.extend((0..length).flat_map(|k| {
                    fields.iter().map(move |field| match fields.len() {
                        1 => format!("{name}[{k}]"),
                        _ => format!("{name}[{k}].{field}"),
                    })
                }));
            }
            Default::Choice(_) => {}
        }
    }
    names.extend(numbers.into_iter().chain(items));
    let operation = |entry| match entry {
        Entry::Constant(x) => ("constant".into(), vec![], x),
        Entry::Input(k) => ("input".into(), vec![k], 0.0),
        Entry::Power(a, n) => ("power".into(), vec![a], f64::from(n)),
        Entry::Operation(name, operands) => (name, operands, 0.0),
    };
    let outputs = tape.outputs().collect();
    (names, tape.entries().map(operation).collect(), outputs)
}
