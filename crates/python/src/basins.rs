//! Basins of attraction.

use crate::error::{InputError, exception};
use crate::figure::dictionary;
use crate::plan::Plan;
use crate::watch::Watch;
use numpy::{IntoPyArray, PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray2};
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

/// Name, first value, last value and number of points of an axis.
type Given = (String, f64, f64, usize);

/// Axes, whether attractors that differ by whole turns are one, whether each start is followed once.
type Asked = (Vec<Given>, bool, bool);

/// What is asked, and by how many threads.
fn asked((axes, wrap, once): Asked, threads: Option<usize>) -> PyResult<(BasinsSpec, Workers)> {
    let mut workers = Workers::chosen().map_err(exception)?;
    match threads {
        Some(0) => return Err(InputError::new_err("threads: at least one is needed")),
        Some(threads) => workers.threads = threads,
        None => {}
    }
    let axes = axes.into_iter().map(|(name, low, high, points)| Axis { name, low, high, points }).collect();
    Ok((BasinsSpec { axes, wrap, once }, workers))
}

/// The basins of a plan on a grid.
#[pyfunction]
#[pyo3(signature = (plan, spec, threads=None, progress=None))]
pub fn basins(
    py: Python,
    plan: &Plan,
    spec: Asked,
    threads: Option<usize>,
    progress: Option<Py<PyAny>>,
) -> PyResult<Basins> {
    let (spec, workers) = asked(spec, threads)?;
    let mut watch = Watch::new(progress);
    let found =
        py.detach(|| precess::basins::basins(&plan.scenario, &spec, workers, &mut |share| watch.at(share)));
    watch.end()?;
    Basins::of(py, found.map_err(exception)?)
}

/// What became of the starts from one number to another: a row of numbers each, for `basins_whole`.
#[pyfunction]
#[pyo3(signature = (plan, spec, first, last, threads=None, progress=None))]
pub fn basins_part(
    py: Python,
    plan: &Plan,
    spec: Asked,
    first: usize,
    last: usize,
    threads: Option<usize>,
    progress: Option<Py<PyAny>>,
) -> PyResult<Py<PyArray2<f64>>> {
    let (spec, workers) = asked(spec, threads)?;
    let mut watch = Watch::new(progress);
    let found = py.detach(|| {
        precess::basins::part(&plan.scenario, &spec, first..last, workers, &mut |share| watch.at(share))
    });
    watch.end()?;
    let (rows, width) = found.map_err(exception)?;
    let count = rows.len() / width;
    Ok(rows.into_pyarray(py).reshape([count, width])?.unbind())
}

/// The basins from the rows of all starts.
#[pyfunction]
#[pyo3(signature = (plan, spec, rows, threads=None, progress=None))]
pub fn basins_whole(
    py: Python,
    plan: &Plan,
    spec: Asked,
    rows: PyReadonlyArray2<f64>,
    threads: Option<usize>,
    progress: Option<Py<PyAny>>,
) -> PyResult<Basins> {
    let (spec, workers) = asked(spec, threads)?;
    let rows: Vec<f64> = rows.as_array().iter().copied().collect();
    let mut watch = Watch::new(progress);
    let found = py.detach(|| {
        precess::basins::whole(&plan.scenario, &spec, &rows, workers, &mut |share| watch.at(share))
    });
    watch.end()?;
    Basins::of(py, found.map_err(exception)?)
}

impl Basins {
    fn of(py: Python, found: precess::basins::Basins) -> PyResult<Self> {
        let told = |a: &Attractor| {
            let kind = match a.kind {
                Kind::FixedPoint => "fixed point".into(),
                Kind::Driven { periods } => format!("cycle of {periods} periods"),
                Kind::Cycle => "limit cycle".into(),
            };
            (a.state.clone(), kind, a.pass)
        };
        Ok(Self {
            figure: dictionary(py, &found.figure())?.unbind(),
            summary: found.summary(),
            attractors: found.attractors.iter().map(told).collect(),
            scenario: precess::scenario_toml(&found.plan),
            labels: found.labels.into_pyarray(py).unbind(),
            times: found.times.into_pyarray(py).unbind(),
        })
    }
}
