//! A run and what came out of it.

use crate::watch::Watch;
use numpy::{IntoPyArray, PyArray2, PyArrayMethods, PyReadonlyArray2};
use precess::system::ColumnKind;
use precess::{drifts, hash_numbers, hash_text, scenario_toml};
use pyo3::prelude::*;

/// What came out of a run.
#[pyclass(frozen, get_all, module = "precess._core")]
pub struct Outcome {
    /// The samples: a row each, a column for each of `columns`.
    numbers: Py<PyArray2<f64>>,
    /// Name, unit and kind of the columns.
    columns: Vec<(String, String, &'static str)>,
    /// Name, time and state of the events.
    events: Vec<(String, f64, Vec<f64>)>,
    /// Name, unit, start, largest and relative drift of the invariants.
    drifts: Vec<(String, String, f64, f64, Option<f64>)>,
    /// The scenario with everything spelt out, and its SHA-256.
    scenario: (String, String),
    /// Accepted and rejected steps, evaluations.
    counts: (u64, u64, u64),
    /// The event that ended the run.
    stopped_by: Option<String>,
    /// Why it ended before its time.
    failure: Option<String>,
}

impl Outcome {
    /// Runs a plan without the GIL.
    pub fn of(py: Python, plan: &precess::Plan, progress: Option<Py<PyAny>>) -> PyResult<Self> {
        let mut watch = Watch::new(progress);
        let outcome = py.detach(|| precess::run(plan, &mut |t| watch.at(t)));
        watch.end()?;
        let trajectory = outcome.trajectory;
        let drift = |d: precess::Drift| {
            let relative = d.relative();
            (d.name, d.unit, d.start, d.largest, relative)
        };
        let drifts = drifts(&trajectory).into_iter().map(drift).collect();
        let shape = [trajectory.len(), trajectory.columns.len()];
        let kind = |kind| match kind {
            ColumnKind::Time => "time",
            ColumnKind::State => "state",
            ColumnKind::Signal => "signal",
            ColumnKind::Invariant => "invariant",
        };
        let provenance = outcome.provenance;
        let scenario = scenario_toml(plan);
        let hash = hash_text(&scenario);
        Ok(Self {
            numbers: trajectory.numbers.into_pyarray(py).reshape(shape)?.unbind(),
            columns: trajectory.columns.iter().map(|c| (c.name, c.unit, kind(c.kind))).collect(),
            events: trajectory.events.into_iter().map(|e| (e.name, e.t, e.state)).collect(),
            drifts,
            scenario: (scenario, hash),
            counts: (provenance.steps, provenance.rejections, provenance.evaluations),
            stopped_by: outcome.stopped_by,
            failure: outcome.failure.map(|failure| failure.to_string()),
        })
    }
}

/// SHA-256 over the numbers of a table as little-endian f64, row by row, every NaN the canonical one.
#[pyfunction]
pub fn hash(numbers: PyReadonlyArray2<f64>) -> String {
    hash_numbers(numbers.as_array().iter().copied())
}
