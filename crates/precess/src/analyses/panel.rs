//! Panels of a run's picture that are answers to questions.

use super::poincare::{self, PoincareSpec};
use crate::error::{Error, input};
use crate::figure::Panel;
use crate::picture::{Shown, Watcher};
use crate::plan::{PanelPlan, Plan};
use crate::scenario::FigureKind;

/// The panel of a kind that the analyses know.
pub(crate) fn panel(
    plan: &Plan,
    panel: &PanelPlan,
    _shown: &[Shown],
    progress: Watcher,
) -> Result<Panel, Error> {
    let spec = &panel.spec;
    let drawn = match spec.kind {
        FigureKind::Poincare => {
            let section = spec.section.clone().unwrap_or_default();
            let (x, y) = (spec.x.first().cloned(), spec.y.first().cloned());
            poincare::of_plan(plan, &PoincareSpec { section, direction: None, x, y }, progress)?.1
        }
        other => return input(format!("a panel of kind '{}' is no analysis", other.name())),
    };
    Ok(Panel {
        title: if spec.title.is_empty() { drawn.title } else { spec.title.clone() },
        x_range: panel.x_range.or(drawn.x_range),
        y_range: panel.y_range.or(drawn.y_range),
        equal_scales: spec.equal_scales,
        ..drawn
    })
}
