//! Errors as Python exceptions: the sentence is the library's.

use pyo3::exceptions::{PyOSError, PyRuntimeError, PyValueError};
use pyo3::{PyErr, create_exception};

create_exception!(
    precess,
    InputError,
    PyValueError,
    "What was asked for makes no sense: what, where, the nearest right thing."
);
create_exception!(
    precess,
    RunError,
    PyRuntimeError,
    "A run ended before its time: what happened, when, what to try. `trajectory` has the samples up to then."
);

/// The exception of a library's error.
pub fn exception(error: precess::Error) -> PyErr {
    match error {
        precess::Error::Input(sentence) => InputError::new_err(sentence),
        precess::Error::File(sentence) => PyOSError::new_err(sentence),
        precess::Error::Failed(sentence) => RunError::new_err(sentence),
    }
}
