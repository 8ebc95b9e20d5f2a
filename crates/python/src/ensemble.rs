//! Many starts and what came out of them.

use crate::error::{InputError, exception};
use crate::watch::Watch;
use numpy::{IntoPyArray, PyArray1, PyArray3, PyArrayMethods, PyReadonlyArray2};
use precess::{Keep, Workers, starts};
use pyo3::prelude::*;

/// What came out of an ensemble.
#[pyclass(frozen, get_all, module = "precess._core")]
pub struct Members {
    /// The times that are kept.
    times: Py<PyArray1<f64>>,
    /// The states: members, times, numbers of a state. NaN after a failure.
    numbers: Py<PyArray3<f64>>,
    /// The members that ended before their time, and why.
    failures: Vec<(usize, String)>,
}

impl Members {
    /// Runs a plan from many starts without the GIL.
    pub fn of(
        py: Python,
        plan: &precess::Plan,
        names: &[String],
        values: &PyReadonlyArray2<f64>,
        samples: bool,
        threads: Option<usize>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Self> {
        let mut workers = Workers::chosen().map_err(exception)?;
        match threads {
            Some(0) => return Err(InputError::new_err("threads: at least one is needed")),
            Some(threads) => workers.threads = threads,
            None => {}
        }
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let rows = values.as_array();
        if rows.ncols() != names.len() {
            return Err(InputError::new_err(format!(
                "the starts have {} columns for the names {}",
                rows.ncols(),
                names.join(", ")
            )));
        }
        let starts =
            starts(plan, &names, &mut rows.rows().into_iter().map(|row| row.to_vec())).map_err(exception)?;
        let keep = if samples { Keep::Samples } else { Keep::Last };
        let mut watch = Watch::new(progress);
        let mut told = |done: usize| watch.at(done as f64);
        let members = py.detach(|| precess::ensemble(plan, &starts, keep, workers, &mut told));
        watch.end()?;
        let members = members.map_err(exception)?;
        let shape = [rows.nrows(), members.times.len(), members.state];
        Ok(Self {
            times: members.times.into_pyarray(py).unbind(),
            numbers: members.numbers.into_pyarray(py).reshape(shape)?.unbind(),
            failures: members.failures.into_iter().map(|(member, why)| (member, why.to_string())).collect(),
        })
    }
}
