//! A fit for people: a table, a picture, lines to read.

use super::{Data, Fit};
use crate::analyses::{Answer, table};
use crate::canonical::scenario_toml;
use crate::figure::{Curve, Figure, Panel, Stroke};
use crate::picture::{axis, subtitle};
use std::fmt::Write;

impl Fit {
    /// The fit as a table, a picture of data over model, and lines to read.
    pub fn answer(&self, data: &Data) -> Answer {
        let quantities = self.plan.columns();
        let mut summary = vec![];
        for f in &self.fitted {
            let mut line = String::new();
            let unit = if f.unit.is_empty() { String::new() } else { format!(" {}", f.unit) };
            let _ = write!(line, "{} = {:.10} +- {:.2e}{unit}", f.name, f.value, f.error);
            let _ = write!(line, "  (95 %: {:.8} to {:.8})", f.interval.0, f.interval.1);
            summary.push(line);
        }
        for ((name, _), scatter) in data.columns.iter().zip(&self.scatter) {
            summary.push(format!("{name}: {scatter:.3e} about the motion (root mean square)"));
        }
        summary.push(format!("{} degrees of freedom, {} motions computed", self.freedom, self.models));
        let panels = data.columns.iter().zip(&self.model).map(|((name, values), model)| {
            let label = quantities.iter().find(|q| q.name == *name).map_or_else(|| name.clone(), axis);
            let curve = |label: &str, y: &[f64], stroke| Curve {
                label: label.into(),
                x: data.times.clone(),
                y: y.to_vec(),
                stroke,
                ..Curve::default()
            };
            Panel {
                x_label: "t [s]".into(),
                y_label: label,
                curves: vec![curve("model", model, Stroke::Line), curve("data", values, Stroke::Dots)],
                ..Panel::default()
            }
        });
        let figure = Figure {
            title: format!("{}: fitted", self.plan.title),
            subtitle: subtitle(&self.plan),
            panels: panels.collect(),
            scenario: scenario_toml(&self.plan),
        };
        let numbers = self.fitted.iter().enumerate();
        let numbers =
            numbers.flat_map(|(k, f)| [k as f64 + 1.0, f.value, f.error, f.interval.0, f.interval.1]);
        let columns = [("index", ""), ("value", ""), ("error", ""), ("low", ""), ("high", "")];
        Answer { table: table(&columns, numbers.collect()), figure, summary, failure: None }
    }
}
