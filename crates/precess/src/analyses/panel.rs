//! Panels of a run's picture that are answers to questions.

use super::bifurcation::{self, BifurcationSpec};
use super::floquet::{self, FloquetSpec};
use super::poincare::{self, PoincareSpec};
use super::response::{self, ResponseSpec};
use super::{Window, portrait};
use crate::basins::{BasinsSpec, basins};
use crate::canonical::scenario_toml;
use crate::error::{Error, input};
use crate::figure::{Mark, Panel};
use crate::grid::Axis;
use crate::picture::{Shown, Watcher, curves};
use crate::plan::{PanelPlan, Plan};
use crate::scenario::{FigureKind, FigureSpec, Scenario};
use crate::survey::{Checkpoint, Survey};
use crate::value::Value;
use crate::workers::Workers;
use std::path::Path;

/// The panel of a kind that the analyses know.
pub(crate) fn panel(
    plan: &Plan,
    panel: &PanelPlan,
    shown: &[Shown],
    progress: Watcher,
) -> Result<Panel, Error> {
    let spec = &panel.spec;
    let drawn = match spec.kind {
        FigureKind::Portrait => portrait_of(plan, panel, shown, progress)?,
        FigureKind::Poincare => {
            let section = spec.section.clone().unwrap_or_default();
            let (x, y) = (spec.x.first().cloned(), spec.y.first().cloned());
            poincare::of_plan(plan, &PoincareSpec { section, direction: None, x, y }, progress)?.1
        }
        FigureKind::Response => response_of(plan, panel, progress)?,
        FigureKind::Bifurcation => {
            let asked =
                BifurcationSpec { sweep: sweep(panel)?, coordinate: spec.y.first().cloned(), down: false };
            bifurcation::of_scenario(&alone(plan)?, &asked, progress)?.1
        }
        FigureKind::Basins => {
            let axes = spec.grid.iter().map(|text| Axis::parse(plan, text)).collect::<Result<_, _>>()?;
            let asked = BasinsSpec { axes, ..BasinsSpec::default() };
            let found = basins(&alone(plan)?, &asked, Workers::chosen()?, progress)?;
            found.figure().panels.into_iter().next().unwrap_or_default()
        }
        FigureKind::Ensemble => ensemble_of(plan, progress)?,
        FigureKind::Tongues => {
            if spec.grid.len() != 2 {
                return input("tongues need grid = [\"NAME=LOW:HIGH:N\", \"NAME=LOW:HIGH:N\"]");
            }
            floquet::map(&alone(plan)?, &FloquetSpec { sweeps: spec.grid.clone() }, progress)?
        }
        other => return input(format!("a panel of kind '{}' is no analysis", other.name())),
    };
    let mut drawn = drawn;
    if spec.kind != FigureKind::Portrait {
        drawn.marks.extend(panel.marks.iter().map(|&[x, y]| Mark { x, y, ink: Some(1), ..Mark::default() }));
    }
    Ok(Panel {
        title: if spec.title.is_empty() { drawn.title } else { spec.title.clone() },
        x_range: panel.x_range.or(drawn.x_range),
        y_range: panel.y_range.or(drawn.y_range),
        equal_scales: spec.equal_scales || drawn.equal_scales,
        ..drawn
    })
}

/// The scenario of the run without its picture.
fn alone(plan: &Plan) -> Result<Scenario, Error> {
    Scenario::parse(&scenario_toml(&Plan { members: vec![], panels: vec![], ..plan.clone() }))
}

fn sweep(panel: &PanelPlan) -> Result<String, Error> {
    let sweep = panel.spec.sweep.clone();
    sweep.map_or_else(|| input("this panel needs sweep = \"NAME=LOW:HIGH:N\""), Ok)
}

/// The portrait inside the panel's ranges, with the chosen trajectories on it.
fn portrait_of(plan: &Plan, panel: &PanelPlan, shown: &[Shown], progress: Watcher) -> Result<Panel, Error> {
    let state = plan.layout.state();
    let mut given = vec![];
    for (quantity, range) in state.iter().zip([panel.x_range, panel.y_range]) {
        let ends = range.map(|(low, high)| (Value::number(low), Value::number(high)));
        given.extend(ends.map(|(low, high)| Window { name: quantity.name.clone(), low, high }));
    }
    let window = portrait::window(plan, &given)?;
    let mut drawn = portrait::of_plan(plan, &window, panel.spec.levels, progress)?.panel;
    if state.len() >= 2 {
        let names = |k: usize| vec![state[k].name.clone()];
        let spec = FigureSpec { x: names(0), y: names(1), kind: FigureKind::Curves, ..panel.spec.clone() };
        let trajectories = curves(&PanelPlan { spec, ..panel.clone() }, shown);
        // Two inks are taken: levels and separatrices.
        drawn.curves.extend(trajectories.curves.into_iter().map(|mut curve| {
            let round = |ink: usize| if curve.label.is_empty() { 2 + ink % 6 } else { ink + 2 };
            curve.ink = curve.ink.map(round);
            curve
        }));
        drawn.marks.extend(trajectories.marks);
    }
    Ok(drawn)
}

/// The map of the scenario's ensemble, which is run for it.
fn ensemble_of(plan: &Plan, progress: Watcher) -> Result<Panel, Error> {
    let survey = Survey::new(&alone(plan)?, Path::new(""))?;
    let mut checkpoint = Checkpoint::in_memory();
    let share = |members: usize| members as f64 / survey.members() as f64;
    if !survey.run(&mut checkpoint, Workers::chosen()?, &mut |members| progress(share(members)))? {
        return Err(Error::Failed("interrupted before the map was complete".into()));
    }
    survey.map(&mut checkpoint)
}

fn response_of(plan: &Plan, panel: &PanelPlan, progress: Watcher) -> Result<Panel, Error> {
    let asked = ResponseSpec { sweep: sweep(panel)?, coordinate: None, down: false };
    let found = response::found(&alone(plan)?, &asked, progress)?;
    let [amplitude, lag] = response::panels(plan, &asked, &found)?;
    match panel.spec.y.first().map(String::as_str) {
        None | Some("amplitude") => Ok(amplitude),
        Some("lag") => Ok(lag),
        Some(other) => Err(crate::unknown("quantity of a response", other, ["amplitude", "lag"])),
    }
}
