//! Basins of attraction.

use crate::error::exception;
use crate::figure::dictionary;
use crate::plan::Plan;
use crate::watch::Watch;
use numpy::{IntoPyArray, PyArray1};
use precess::basins::{Attractor, BasinsSpec, Kind};
use precess::{Axis, Workers};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Where the starts of a grid end.
#[pyclass(frozen, get_all, module = "precess._core")]
pub struct Basins {
    /// The number of each start's attractor, or a negative one; the first axis runs fastest.
    labels: Py<PyArray1<i32>>,
    /// When it was known.
    times: Py<PyArray1<f64>>,
    /// State, kind and pass of the attractors.
    attractors: Vec<(Vec<f64>, String, Option<f64>)>,
    /// The run of each start (TOML).
    scenario: String,
    /// The picture.
    figure: Py<PyDict>,
    /// What a person wants to know, line by line.
    summary: Vec<String>,
}

/// The basins of a plan on a grid: name, first value, last value and number of points of each axis.
#[pyfunction]
#[pyo3(signature = (plan, axes, wrap, threads=None, progress=None))]
pub fn basins(
    py: Python,
    plan: &Plan,
    axes: Vec<(String, f64, f64, usize)>,
    wrap: bool,
    threads: Option<usize>,
    progress: Option<Py<PyAny>>,
) -> PyResult<Basins> {
    let mut workers = Workers::chosen().map_err(exception)?;
    workers.threads = threads.filter(|n| *n > 0).unwrap_or(workers.threads);
    let axes = axes.into_iter().map(|(name, low, high, points)| Axis { name, low, high, points }).collect();
    let spec = BasinsSpec { axes, wrap };
    let mut watch = Watch::new(progress);
    let found =
        py.detach(|| precess::basins::basins(&plan.scenario, &spec, workers, &mut |share| watch.at(share)));
    watch.end()?;
    let found = found.map_err(exception)?;
    let told = |a: &Attractor| {
        let kind = match a.kind {
            Kind::FixedPoint => "fixed point".into(),
            Kind::Driven { periods } => format!("cycle of {periods} periods"),
            Kind::Cycle => "limit cycle".into(),
        };
        (a.state.clone(), kind, a.pass)
    };
    Ok(Basins {
        figure: dictionary(py, &found.figure())?.unbind(),
        summary: found.summary(),
        attractors: found.attractors.iter().map(told).collect(),
        scenario: precess::scenario_toml(&found.plan),
        labels: found.labels.into_pyarray(py).unbind(),
        times: found.times.into_pyarray(py).unbind(),
    })
}
