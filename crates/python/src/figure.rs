//! A figure as Python's own dictionaries, lists and arrays, for whoever draws it.

use numpy::IntoPyArray;
use precess::figure::{Figure, Map, Panel, Sign, Stroke};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

/// The figure as a dictionary.
pub fn dictionary<'py>(py: Python<'py>, figure: &Figure) -> PyResult<Bound<'py, PyDict>> {
    let found = PyDict::new(py);
    found.set_item("title", &figure.title)?;
    found.set_item("subtitle", &figure.subtitle)?;
    found.set_item("scenario", &figure.scenario)?;
    let panels = figure.panels.iter().map(|p| panel(py, p)).collect::<PyResult<Vec<_>>>()?;
    found.set_item("panels", PyList::new(py, panels)?)?;
    Ok(found)
}

fn panel<'py>(py: Python<'py>, panel: &Panel) -> PyResult<Bound<'py, PyDict>> {
    let found = PyDict::new(py);
    found.set_item("title", &panel.title)?;
    found.set_item("x_label", &panel.x_label)?;
    found.set_item("y_label", &panel.y_label)?;
    found.set_item("equal_scales", panel.equal_scales)?;
    found.set_item("logarithmic", panel.logarithmic)?;
    found.set_item("x_range", panel.x_range)?;
    found.set_item("y_range", panel.y_range)?;
    let curves = panel.curves.iter().map(|c| {
        let stroke = match c.stroke {
            Stroke::Line => "line",
            Stroke::Thin => "thin",
            Stroke::Dashed => "dashed",
            Stroke::Dots => "dots",
        };
        (c.label.clone(), c.x.clone().into_pyarray(py), c.y.clone().into_pyarray(py), c.ink, stroke)
    });
    found.set_item("curves", curves.collect::<Vec<_>>())?;
    let marks = panel.marks.iter().map(|m| {
        let sign = match m.sign {
            Sign::Dot => "dot",
            Sign::Ring => "ring",
            Sign::Cross => "cross",
            Sign::Ball => "ball",
        };
        (m.label.clone(), m.x, m.y, sign, m.ink)
    });
    found.set_item("marks", marks.collect::<Vec<_>>())?;
    found.set_item("map", panel.map.as_ref().map(|m| map(py, m)))?;
    Ok(found)
}

type Classes<'py> = ((f64, f64), (f64, f64), usize, Bound<'py, numpy::PyArray1<i32>>, Vec<String>);

/// Ranges, points of a row, classes, names.
fn map<'py>(py: Python<'py>, map: &Map) -> Classes<'py> {
    (map.x, map.y, map.columns, map.classes.clone().into_pyarray(py), map.names.clone())
}
