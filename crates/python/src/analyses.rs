//! Questions beyond a run, and their answers.

use crate::error::exception;
use crate::figure::dictionary;
use crate::plan::Plan;
use crate::watch::Watch;
use numpy::{IntoPyArray, PyArray1, PyArray2, PyArray3, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2};
use precess::Error;
use precess::analyses::{
    self, BifurcationSpec, Data, FloquetSpec, FrenetSpec, PoincareSpec, PortraitSpec, ResponseSpec,
};
use precess::system::Trajectory;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::ops::ControlFlow;

/// What comes out of an analysis.
#[pyclass(frozen, get_all, module = "precess._core")]
pub struct Answer {
    /// The numbers: a column for each of `columns`.
    numbers: Py<PyArray2<f64>>,
    /// Name and unit of the columns.
    columns: Vec<(String, String)>,
    /// The picture.
    figure: Py<PyDict>,
    /// What a person wants to know, line by line.
    summary: Vec<String>,
    /// Why the work ended before its time.
    failure: Option<String>,
}

impl Answer {
    fn of(py: Python, answer: analyses::Answer) -> PyResult<Self> {
        let shape = [answer.table.len(), answer.table.columns.len()];
        Ok(Self {
            figure: dictionary(py, &answer.figure)?.unbind(),
            columns: answer.table.columns.iter().map(|c| (c.name, c.unit)).collect(),
            numbers: answer.table.numbers.into_pyarray(py).reshape(shape)?.unbind(),
            summary: answer.summary,
            failure: answer.failure,
        })
    }
}

/// Asks without the GIL.
fn asked<T: Send>(
    py: Python,
    progress: Option<Py<PyAny>>,
    ask: impl FnOnce(&mut dyn FnMut(f64) -> ControlFlow<()>) -> Result<T, Error> + Send,
) -> PyResult<T> {
    let mut watch = Watch::new(progress);
    let answer = py.detach(|| ask(&mut |share| watch.at(share)));
    watch.end()?;
    answer.map_err(exception)
}

/// The Lyapunov spectrum.
#[pyfunction]
#[pyo3(signature = (plan, progress=None))]
pub fn lyapunov(py: Python, plan: &Plan, progress: Option<Py<PyAny>>) -> PyResult<Answer> {
    let answer = asked(py, progress, |told| analyses::lyapunov(&plan.scenario, told))?;
    Answer::of(py, answer)
}

/// How far a run can be trusted.
#[pyfunction]
#[pyo3(signature = (plan, within, progress=None))]
pub fn trust(py: Python, plan: &Plan, within: f64, progress: Option<Py<PyAny>>) -> PyResult<Answer> {
    let answer = asked(py, progress, |told| analyses::trust(&plan.scenario, within, told))?;
    Answer::of(py, answer)
}

/// A Poincaré section.
#[pyfunction]
#[pyo3(signature = (plan, section, direction=None, x=None, y=None, progress=None))]
pub fn poincare(
    py: Python,
    plan: &Plan,
    section: String,
    direction: Option<String>,
    x: Option<String>,
    y: Option<String>,
    progress: Option<Py<PyAny>>,
) -> PyResult<Answer> {
    let spec = PoincareSpec { section, direction, x, y };
    let answer = asked(py, progress, |told| analyses::poincare(&plan.scenario, &spec, told))?;
    Answer::of(py, answer)
}

/// The phase portrait: fixed points and the picture; windows such as `x=-2:2`.
#[pyfunction]
#[pyo3(signature = (plan, windows, levels=None, progress=None))]
pub fn portrait(
    py: Python,
    plan: &Plan,
    windows: Vec<String>,
    levels: Option<usize>,
    progress: Option<Py<PyAny>>,
) -> PyResult<Answer> {
    let spec = PortraitSpec { windows, levels };
    let answer = asked(py, progress, |told| analyses::portrait(&plan.scenario, &spec, told))?;
    Answer::of(py, answer)
}

/// The response to a drive along a sweep such as `frequency=0.2:3:200`.
#[pyfunction]
#[pyo3(signature = (plan, sweep, coordinate=None, down=false, progress=None))]
pub fn response(
    py: Python,
    plan: &Plan,
    sweep: String,
    coordinate: Option<String>,
    down: bool,
    progress: Option<Py<PyAny>>,
) -> PyResult<Answer> {
    let spec = ResponseSpec { sweep, coordinate, down };
    let answer = asked(py, progress, |told| analyses::response(&plan.scenario, &spec, told))?;
    Answer::of(py, answer)
}

/// The bifurcations along a sweep.
#[pyfunction]
#[pyo3(signature = (plan, sweep, coordinate=None, down=false, progress=None))]
pub fn bifurcation(
    py: Python,
    plan: &Plan,
    sweep: String,
    coordinate: Option<String>,
    down: bool,
    progress: Option<Py<PyAny>>,
) -> PyResult<Answer> {
    let spec = BifurcationSpec { sweep, coordinate, down };
    let answer = asked(py, progress, |told| analyses::bifurcation(&plan.scenario, &spec, told))?;
    Answer::of(py, answer)
}

/// Floquet multipliers: of the motion near the start, along one sweep, or over two.
#[pyfunction]
#[pyo3(signature = (plan, sweeps, progress=None))]
pub fn floquet(
    py: Python,
    plan: &Plan,
    sweeps: Vec<String>,
    progress: Option<Py<PyAny>>,
) -> PyResult<Answer> {
    let spec = FloquetSpec { sweeps };
    let answer = asked(py, progress, |told| analyses::floquet(&plan.scenario, &spec, told))?;
    Answer::of(py, answer)
}

/// How many points the sweeps have.
#[pyfunction]
pub fn floquet_points(sweeps: Vec<String>) -> PyResult<usize> {
    analyses::floquet_points(&FloquetSpec { sweeps }).map_err(exception)
}

/// The largest moduli at the points from one number to another, for `floquet_whole`.
#[pyfunction]
#[pyo3(signature = (plan, sweeps, first, last, progress=None))]
pub fn floquet_part(
    py: Python,
    plan: &Plan,
    sweeps: Vec<String>,
    first: usize,
    last: usize,
    progress: Option<Py<PyAny>>,
) -> PyResult<Py<PyArray1<f64>>> {
    let spec = FloquetSpec { sweeps };
    let moduli =
        asked(py, progress, |told| analyses::floquet_part(&plan.scenario, &spec, first..last, told))?;
    Ok(moduli.into_pyarray(py).unbind())
}

/// The answer from the moduli at all points.
#[pyfunction]
pub fn floquet_whole(
    py: Python,
    plan: &Plan,
    sweeps: Vec<String>,
    moduli: PyReadonlyArray1<f64>,
) -> PyResult<Answer> {
    let moduli = moduli.as_array().to_vec();
    let answer = analyses::floquet_whole(&plan.scenario, &FloquetSpec { sweeps }, &moduli);
    Answer::of(py, answer.map_err(exception)?)
}

/// A path in a plane with its curvature.
#[pyfunction]
#[pyo3(signature = (plan, x=None, y=None, progress=None))]
pub fn frenet(
    py: Python,
    plan: &Plan,
    x: Option<String>,
    y: Option<String>,
    progress: Option<Py<PyAny>>,
) -> PyResult<Answer> {
    let spec = FrenetSpec { x, y };
    let answer = asked(py, progress, |told| analyses::frenet(&plan.scenario, &spec, told))?;
    Answer::of(py, answer)
}

/// Values (times, columns) and derivatives (times, names, columns) of the motion; the columns are those of a run but
/// for the time.
#[pyfunction]
#[pyo3(signature = (plan, names, times, progress=None))]
#[allow(clippy::type_complexity)]
pub fn sensitivities(
    py: Python,
    plan: &Plan,
    names: Vec<String>,
    times: PyReadonlyArray1<f64>,
    progress: Option<Py<PyAny>>,
) -> PyResult<(Py<PyArray2<f64>>, Py<PyArray3<f64>>)> {
    let times = times.as_array().to_vec();
    let width = plan.plan.width() - 1;
    let found = asked(py, progress, |told| analyses::sensitivities(&plan.plan, &names, &times, told))?;
    let values = found.values.into_pyarray(py).reshape([times.len(), width])?;
    let slopes = found.slopes.into_pyarray(py).reshape([times.len(), names.len(), width])?;
    Ok((values.unbind(), slopes.unbind()))
}

/// Name, unit, value, standard error, 95 % interval.
type Fitted = (String, String, f64, f64, (f64, f64));

/// A fit.
#[pyclass(frozen, get_all, module = "precess._core")]
pub struct Fit {
    /// The fitted numbers.
    fitted: Vec<Fitted>,
    /// The correlation of each with each.
    correlation: Vec<Vec<f64>>,
    /// The scatter of each column.
    scatter: Vec<f64>,
    /// The sum of the squares.
    chi2: f64,
    /// Numbers measured less numbers fitted.
    freedom: usize,
    /// The fitted columns at the times of the data.
    model: Vec<Py<PyArray1<f64>>>,
    /// The fitted scenario (TOML).
    scenario: String,
    /// Table, picture, lines.
    answer: Py<Answer>,
}

/// Fits the free numbers to columns measured at times.
#[pyfunction]
#[pyo3(signature = (plan, times, columns, uncertainties, free, progress=None))]
pub fn fit(
    py: Python,
    plan: &Plan,
    times: PyReadonlyArray1<f64>,
    columns: Vec<(String, PyReadonlyArray1<f64>)>,
    uncertainties: Vec<f64>,
    free: Vec<String>,
    progress: Option<Py<PyAny>>,
) -> PyResult<Fit> {
    let columns = columns.into_iter().map(|(name, values)| (name, values.as_array().to_vec())).collect();
    let data = Data { times: times.as_array().to_vec(), columns, uncertainties };
    let fit = asked(py, progress, |told| analyses::fit(&plan.scenario, &data, &free, told))?;
    let answer = Answer::of(py, fit.answer(&data))?;
    Ok(Fit {
        scenario: precess::scenario_toml(&fit.plan),
        answer: Py::new(py, answer)?,
        fitted: fit.fitted.into_iter().map(|f| (f.name, f.unit, f.value, f.error, f.interval)).collect(),
        correlation: fit.correlation,
        scatter: fit.scatter,
        chi2: fit.chi2,
        freedom: fit.freedom,
        model: fit.model.into_iter().map(|column| column.into_pyarray(py).unbind()).collect(),
    })
}

/// The picture of a run: the numbers are those of its outcome.
#[pyfunction]
pub fn picture(py: Python, plan: &Plan, numbers: PyReadonlyArray2<f64>) -> PyResult<Py<PyDict>> {
    let columns = precess::columns(&plan.plan);
    let trajectory =
        Trajectory { columns, numbers: numbers.as_array().iter().copied().collect(), events: vec![] };
    let figure = asked(py, None, |told| precess::picture(&plan.plan, &trajectory, told))?;
    dictionary(py, &figure).map(Bound::unbind)
}
