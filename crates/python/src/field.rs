//! The equations themselves: rates, their Jacobian, and the recorded expressions.

use crate::error::InputError;
use crate::plan::Plan;
use numpy::{IntoPyArray, PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1};
use precess::scalar::{Dual, Entry, Notation};
use precess::system::Bind;
use precess::{parameter_names, record};
use pyo3::prelude::*;

/// The full state of a plan from the numbers that are reported.
fn full(plan: &precess::Plan, y: &PyReadonlyArray1<f64>) -> PyResult<Vec<f64>> {
    let state = plan.layout.shape().state();
    let id = plan.card.id;
    if plan.structure.hybrid {
        return Err(InputError::new_err(format!("{id} has events, which its rates alone do not tell")));
    }
    if plan.layout.modes > 0 {
        let why = "moves numbers behind its state, which its rates alone do not tell";
        return Err(InputError::new_err(format!("{id} {why}")));
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
    let field = Bind::<Dual<f64>>::bind(plan.system, plan.values.map(|&x| Dual::from(x)), &plan.layout);
    let matrix = precess::analysis::jacobian(&*field, t, &y);
    matrix.numbers.into_pyarray(py).reshape([matrix.size, matrix.size])
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
    names.extend(parameter_names(&plan.card, &plan.values, Notation::Text));
    let operation = |entry| match entry {
        Entry::Constant(x) => ("constant".into(), vec![], x),
        Entry::Input(k) => ("input".into(), vec![k], 0.0),
        Entry::Power(a, n) => ("power".into(), vec![a], f64::from(n)),
        Entry::Operation(name, operands) => (name, operands, 0.0),
    };
    let outputs = tape.outputs().collect();
    (names, tape.entries().map(operation).collect(), outputs)
}
