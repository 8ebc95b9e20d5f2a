//! A scenario held against the cards, as a Python object that does not change.

use crate::ensemble::Members;
use crate::error::exception;
use crate::run::Outcome;
use crate::value::values;
use numpy::PyReadonlyArray2;
use precess::system::{Default, Quantity};
use precess::{EventSpec, Scenario, Step, scenario_toml};
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

/// A run that is fully determined.
#[pyclass(frozen, module = "precess._core")]
pub struct Plan {
    pub scenario: Scenario,
    pub plan: precess::Plan,
}

/// An event as Python gives it: name, crossing, direction, whether the run ends there.
type Event = (Option<String>, String, Option<String>, bool);

impl Plan {
    fn of(scenario: Scenario) -> PyResult<Self> {
        let plan = precess::Plan::new(&scenario).map_err(exception)?;
        Ok(Self { scenario, plan })
    }
}

#[pymethods]
impl Plan {
    /// A plan from what differs from the cards.
    #[new]
    #[pyo3(signature = (system, parameters, start, method, run, events, title))]
    fn new(
        system: &str,
        parameters: &Bound<PyDict>,
        start: &Bound<PyDict>,
        method: Option<String>,
        run: &Bound<PyDict>,
        events: Vec<Event>,
        title: String,
    ) -> PyResult<Self> {
        let event = |(name, when, direction, stop)| EventSpec { name, when, direction, stop };
        Self::of(Scenario {
            title,
            parameters: values(parameters)?,
            start: values(start)?,
            method,
            run: values(run)?,
            events: events.into_iter().map(event).collect(),
            ..Scenario::of(system)
        })
    }

    /// A plan from the text of a scenario file.
    #[staticmethod]
    fn parse(text: &str) -> PyResult<Self> {
        Scenario::parse(text).map_err(exception).and_then(Self::of)
    }

    /// The plan with other parameters, starts and settings beside its own.
    fn changed(
        &self,
        parameters: &Bound<PyDict>,
        start: &Bound<PyDict>,
        method: Option<&str>,
        run: &Bound<PyDict>,
    ) -> PyResult<Self> {
        let mut scenario = match method {
            Some(method) => self.scenario.by(method).map_err(exception)?,
            None => self.scenario.clone(),
        };
        for (list, given) in
            [(&mut scenario.parameters, parameters), (&mut scenario.start, start), (&mut scenario.run, run)]
        {
            for (name, value) in values(given)? {
                Scenario::set(list, &name, value);
            }
        }
        Self::of(scenario)
    }

    /// System id.
    #[getter]
    fn system(&self) -> &str {
        self.plan.card.id
    }
    /// Heading.
    #[getter]
    fn title(&self) -> &str {
        &self.plan.title
    }
    /// Method id.
    #[getter]
    fn method(&self) -> &str {
        self.plan.method.card().id
    }
    /// End time.
    #[getter]
    fn until(&self) -> f64 {
        self.plan.until
    }
    /// Time between samples.
    #[getter]
    fn every(&self) -> f64 {
        self.plan.every
    }
    /// `dt`, or `rtol` and `atol`.
    #[getter]
    fn step(&self) -> Vec<(&str, f64)> {
        match self.plan.step {
            Step::Fixed(dt) => vec![("dt", dt)],
            Step::Adaptive { rtol, atol } => vec![("rtol", rtol), ("atol", atol)],
        }
    }
    /// The values of all parameters.
    #[getter]
    fn parameters<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let values = &self.plan.values;
        let (mut numbers, mut lists, mut choices) =
            (values.numbers.iter(), values.lists.iter(), values.choices.iter());
        let found = PyDict::new(py);
        for parameter in &self.plan.card.parameters {
            let value = match &parameter.default {
                Default::Number(_) => numbers.next().map(|x| x.into_bound_py_any(py)),
                Default::List { .. } => lists.next().map(|list| match list.width {
                    1 => list.items.clone().into_bound_py_any(py),
                    width => PyList::new(py, list.items.chunks(width)).map(Bound::into_any),
                }),
                Default::Choice(options) => choices.next().map(|k| options[*k].into_bound_py_any(py)),
            };
            found.set_item(&parameter.quantity.name, value.transpose()?)?;
        }
        Ok(found)
    }
    /// The state at the start, by name.
    #[getter]
    fn start(&self) -> Vec<(String, f64)> {
        self.plan.given().0
    }
    /// Name, symbol, unit and meaning of every column of the result: time, state, observables.
    #[getter]
    fn columns(&self) -> Vec<(String, String, String, String)> {
        let row = |q: Quantity| (q.name, q.symbol, q.unit, q.text.en);
        self.plan.columns().into_iter().map(row).collect()
    }
    /// The scenario (TOML) with everything spelt out.
    fn toml(&self) -> String {
        scenario_toml(&self.plan)
    }

    /// Runs it. `progress` is told the time now and then.
    #[pyo3(signature = (progress=None))]
    fn run(&self, py: Python, progress: Option<Py<PyAny>>) -> PyResult<Outcome> {
        Outcome::of(py, &self.plan, progress)
    }

    /// Runs it from many starts: a row of values for each. `progress` is told how many are done.
    #[pyo3(signature = (names, values, samples, threads=None, progress=None))]
    fn ensemble(
        &self,
        py: Python,
        names: Vec<String>,
        values: PyReadonlyArray2<f64>,
        samples: bool,
        threads: Option<usize>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Members> {
        Members::of(py, &self.plan, &names, &values, samples, threads, progress)
    }
}
