//! The figure of a run: the scenario's panels, or the card's views and the drift of the invariants.

mod curves;
mod labels;
mod potential;
mod shown;
mod views;

pub(crate) use curves::curves;
pub(crate) use labels::{axis, readable, subtitle};
pub(crate) use shown::Shown;

use crate::canonical::scenario_toml;
use crate::drift::{departures, invariants};
use crate::error::Error;
use crate::figure::{Curve, Figure, Panel};
use crate::plan::{PanelPlan, Plan};
use crate::scenario::FigureKind;
use precess_system::Trajectory;
use std::ops::ControlFlow;

/// Told how much of the work is done (from 0 to 1); ends it where it breaks.
pub(crate) type Watcher<'a> = &'a mut dyn FnMut(f64) -> ControlFlow<()>;

/// The figure of a run. The families of its scenario are run for it.
///
/// # Errors
/// Where a panel cannot be drawn.
pub fn picture(plan: &Plan, trajectory: &Trajectory, progress: Watcher) -> Result<Figure, Error> {
    let shown = shown::all(plan, trajectory, progress);
    let columns = plan.columns();
    let mut panels = vec![];
    if plan.panels.is_empty() {
        for view in &plan.card.views {
            panels.push(curves(&views::panel(&columns, view), &shown));
        }
        panels.extend(drift_panel(trajectory));
    }
    for panel in &plan.panels {
        panels.extend(of_kind(plan, panel, &shown, progress)?);
    }
    Ok(Figure { title: plan.title.clone(), subtitle: subtitle(plan), panels, scenario: scenario_toml(plan) })
}

/// A panel as the scenario asks for it; `None` where this program has no analyses.
fn of_kind(
    plan: &Plan,
    panel: &PanelPlan,
    shown: &[Shown],
    progress: Watcher,
) -> Result<Option<Panel>, Error> {
    match panel.spec.kind {
        FigureKind::Curves => Ok(Some(curves(panel, shown))),
        FigureKind::Snapshot => Ok(Some(curves::snapshot(panel, shown))),
        FigureKind::Potential => potential::potential(panel, shown).map(Some),
        #[cfg(feature = "analyses")]
        _ => crate::analyses::panel(plan, panel, shown, progress).map(Some),
        #[cfg(not(feature = "analyses"))]
        _ => {
            let _ = (plan, progress);
            Ok(None)
        }
    }
}

fn drift_panel(trajectory: &Trajectory) -> Option<Panel> {
    let times: Vec<f64> = trajectory.rows().map(|row| row[0]).collect();
    let curves: Vec<Curve> = invariants(trajectory)
        .map(|(k, column)| {
            let values: Vec<f64> = trajectory.rows().map(|row| row[k]).collect();
            let label = readable(&column.name);
            Curve { label, x: times.clone(), y: departures(&values), ..Curve::default() }
        })
        .collect();
    (!curves.is_empty()).then(|| Panel {
        title: match &curves[..] {
            [one] => format!("Drift of {}, relative to the start", one.label),
            _ => "Drift of the invariants, relative to the start".into(),
        },
        x_label: "t [s]".into(),
        logarithmic: true,
        curves,
        ..Panel::default()
    })
}
