//! Who watches while Rust computes: Ctrl-C, and a progress bar.

use pyo3::prelude::*;
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

/// Signals and progress are looked after this often: too seldom to cost, too often to be noticed.
const PAUSE: Duration = Duration::from_millis(50);

/// Watches a run that goes on without the GIL.
pub struct Watch {
    progress: Option<Py<PyAny>>,
    last: Instant,
    raised: Option<PyErr>,
}

impl Watch {
    /// A watch that tells `progress`, a callable, how far the work has come.
    pub fn new(progress: Option<Py<PyAny>>) -> Self {
        Self { progress, last: Instant::now(), raised: None }
    }

    /// The work has come this far (a time, a number of members).
    pub fn at(&mut self, done: f64) -> ControlFlow<()> {
        if self.last.elapsed() < PAUSE {
            return ControlFlow::Continue(());
        }
        let told = Python::attach(|py| {
            py.check_signals()?;
            self.progress.as_ref().map_or(Ok(()), |progress| progress.call1(py, (done,)).map(|_| ()))
        });
        self.last = Instant::now();
        match told {
            Ok(()) => ControlFlow::Continue(()),
            Err(raised) => {
                self.raised = Some(raised);
                ControlFlow::Break(())
            }
        }
    }

    /// The exception that ended the work, if one did.
    pub fn end(self) -> PyResult<()> {
        self.raised.map_or(Ok(()), Err)
    }
}
