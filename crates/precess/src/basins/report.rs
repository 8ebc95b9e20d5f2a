//! What a map of basins tells: in words, and as a picture.

use super::{Basins, DIVERGED, ESCAPED, Estimate, Kind, UNDECIDED, entropy, fraction, uncertainty};
use crate::canonical::scenario_toml;
use crate::figure::{Figure, Map, Mark, Panel, Sign};
use crate::grid::Axis;
use crate::picture::{axis, subtitle};
use precess_system::Quantity;

/// Attractors beyond this are only counted.
const MOST_LINES: usize = 12;

impl Basins {
    /// Points of a row of the map.
    fn columns(&self) -> usize {
        self.axes.first().map_or(1, |axis| axis.points)
    }

    /// What a person wants to know, line by line.
    pub fn summary(&self) -> Vec<String> {
        let mut lines = vec![];
        let names = self.plan.layout.state();
        for (label, attractor) in (0..).zip(&self.attractors).take(MOST_LINES) {
            let kind = match attractor.kind {
                Kind::FixedPoint => "fixed point".to_string(),
                Kind::Driven { periods: 1 } => "cycle of one period".to_string(),
                Kind::Driven { periods } => format!("cycle of {periods} periods"),
                Kind::Cycle => "limit cycle".to_string(),
            };
            let state = names.iter().zip(&attractor.state);
            let state: Vec<String> = state.map(|(q, x)| format!("{} = {}", q.name, rounded(*x))).collect();
            let share = percent(fraction(&self.labels, label));
            lines.push(format!("{label:>3} {share}  {kind} at {}", state.join(", ")));
        }
        if self.attractors.len() > MOST_LINES {
            lines.push(format!("and {} attractors more", self.attractors.len() - MOST_LINES));
        }
        for (label, name) in [(UNDECIDED, "undecided"), (ESCAPED, "escaped"), (DIVERGED, "diverged")] {
            if self.labels.contains(&label) {
                lines.push(format!("{label:>3} {}  {name}", percent(fraction(&self.labels, label))));
            }
        }
        let decided = self.times.iter().zip(&self.labels).filter(|(_, label)| **label >= 0).map(|(t, _)| t);
        let count = decided.clone().count();
        if count > 0 {
            let mean = decided.sum::<f64>() / count as f64;
            lines.push(format!("decided when {}, after {mean:.3} s on average", self.proof));
        }
        if self.axes.len() > 1 {
            let number = |e: Estimate| format!("{:.4} ± {:.4}", e.value, e.error);
            let [all, boundary] = entropy(&self.labels, self.columns());
            if let (Some(all), Some(boundary)) = (all, boundary) {
                lines.push(format!("basin entropy {}, on the boundary {}", number(all), number(boundary)));
            }
            if let Some(exponent) = uncertainty(&self.labels, self.columns()) {
                lines.push(format!("uncertainty exponent {}", number(exponent)));
            }
        }
        lines
    }

    /// The map as a picture, with the attractors where both axes are numbers of the state.
    pub fn figure(&self) -> Figure {
        let state = self.plan.layout.state();
        let place = |axis: Option<&Axis>| axis.and_then(|a| state.iter().position(|q| q.name == a.name));
        let quantity = |axis: &Axis| -> String {
            let starts = state.iter().chain(&self.plan.card.starts);
            starts.into_iter().find(|q| q.name == axis.name).map_or(axis.name.clone(), label)
        };
        let (x, y) = (self.axes.first(), self.axes.get(1));
        let range = |axis: Option<&Axis>| axis.map_or((0.0, 1.0), |a| (a.low, a.high));
        let marks = match (place(x), place(y)) {
            (Some(i), Some(j)) => {
                let inside = |x: f64, (low, high): (f64, f64)| low <= x && x <= high;
                let seen = self
                    .attractors
                    .iter()
                    .filter(|a| inside(a.state[i], range(x)) && inside(a.state[j], range(y)));
                seen.map(|a| Mark { x: a.state[i], y: a.state[j], sign: Sign::Dot, ..Mark::default() })
                    .collect()
            }
            _ => vec![],
        };
        let coordinates = &state[..self.plan.layout.coordinates.len()];
        let unit = |axis: Option<&Axis>| {
            coordinates.iter().find(|q| axis.is_some_and(|a| a.name == q.name)).map(|q| q.unit.clone())
        };
        let panel = Panel {
            x_label: x.map_or(String::new(), quantity),
            y_label: y.map_or(String::new(), quantity),
            equal_scales: unit(x) == unit(y) && unit(x).is_some(),
            map: Some(Map {
                x: range(x),
                y: range(y),
                columns: self.columns(),
                classes: self.labels.clone(),
                names: self.attractors.iter().map(|a| self.name(&a.state)).collect(),
            }),
            marks,
            ..Panel::default()
        };
        let undecided = self.labels.iter().filter(|l| **l == UNDECIDED).count();
        let count = self.labels.len();
        Figure {
            title: format!("{}: basins of attraction", self.plan.title),
            subtitle: format!("{}, {undecided} of {count} starts undecided", subtitle(&self.plan)),
            panels: vec![panel],
            scenario: scenario_toml(&self.plan),
        }
    }

    /// An attractor by its coordinates.
    fn name(&self, state: &[f64]) -> String {
        let coordinates = state[..self.plan.layout.coordinates.len()].iter().take(3);
        format!("({})", coordinates.map(|x| rounded(*x)).collect::<Vec<_>>().join(", "))
    }
}

fn label(quantity: &Quantity) -> String {
    axis(quantity)
}

/// A few digits; a zero of rounding is zero.
fn rounded(x: f64) -> String {
    if x.abs() < 1e-9 { "0".into() } else { format!("{x:.4}") }
}

fn percent(share: Estimate) -> String {
    format!("{:6.2} ± {:.2} %", 100.0 * share.value, 100.0 * share.error)
}
