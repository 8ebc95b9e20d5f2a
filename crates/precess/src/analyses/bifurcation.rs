//! The attractor against a parameter.

use super::subject::{Subject, failed, period, smooth, state_number};
use super::{Answer, Progress, Sweep, sweep, table};
use crate::canonical::scenario_toml;
use crate::error::{Error, input};
use crate::figure::{Curve, Figure, Panel, Stroke};
use crate::picture::{axis, subtitle};
use crate::plan::Plan;
use crate::scenario::Scenario;
use precess_analysis::{Visit, visits};

/// Which diagram.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BifurcationSpec {
    /// `f=1:1.5:200`.
    pub sweep: String,
    /// The number of the state that is recorded; the first coordinate where absent.
    pub coordinate: Option<String>,
    /// From the last value to the first: a branch is followed, so the way matters where there are two.
    pub down: bool,
}

/// Half of a run settles, the other half is recorded.
const SETTLES: f64 = 0.5;

/// The values of a coordinate once a period of the drive (at its highest points, where there is no drive), at every
/// value of the parameter.
///
/// # Errors
/// Where the scenario or the sweep makes no sense, or an integration cannot go on.
pub fn bifurcation(scenario: &Scenario, spec: &BifurcationSpec, progress: Progress) -> Result<Answer, Error> {
    let plan = Plan::new(scenario)?;
    let (numbers, panel) = of_scenario(scenario, spec, progress)?;
    let quantity = Sweep::parse(&spec.sweep)?.quantity(&plan)?;
    let coordinate = &plan.layout.state()[state_number(&plan, spec.coordinate.as_deref())?];
    let columns = [
        (quantity.name.as_str(), quantity.unit.as_str()),
        (coordinate.name.as_str(), coordinate.unit.as_str()),
    ];
    let summary = vec![format!("{} points", numbers.len() / 2)];
    let figure = Figure {
        title: format!("{}: bifurcations", plan.title),
        subtitle: subtitle(&plan),
        panels: vec![panel],
        scenario: scenario_toml(&plan),
    };
    Ok(Answer { table: table(&columns, numbers), figure, summary, failure: None })
}

/// Parameter and value of each point, and the panel.
pub(super) fn of_scenario(
    scenario: &Scenario,
    spec: &BifurcationSpec,
    progress: Progress,
) -> Result<(Vec<f64>, Panel), Error> {
    let plan = Plan::new(scenario)?;
    smooth(&plan, "a bifurcation diagram")?;
    let coordinate = state_number(&plan, spec.coordinate.as_deref())?;
    let parameter = Sweep::parse(&spec.sweep)?;
    let mut values = parameter.numbers(&plan)?;
    if spec.down {
        values.reverse();
    }
    if plan.until <= 0.0 {
        return input(format!("the end must be above zero here, not {}", plan.until));
    }
    let (mut state, mut numbers) = (plan.start.clone(), vec![]);
    for (k, &x) in values.iter().enumerate() {
        let own = sweep::at(scenario, &[(parameter.name.clone(), x)])?;
        let subject = Subject::new(&own)?;
        let share = k as f64 / values.len() as f64;
        let mut watch = |_: f64| progress(share);
        let flow = subject.flow(&mut watch);
        let drive =
            if own.structure.time_enters { Some(period(&own, "a bifurcation diagram")?) } else { None };
        let half = own.until * SETTLES;
        let visit = Visit { coordinate, period: drive, settle: half, record: own.until - half };
        match visits(&flow, &mut state, &visit) {
            Ok(found) => numbers.extend(found.into_iter().flat_map(|y| [x, y])),
            Err(failure) => return failed(&failure),
        }
    }
    let of = |k: usize| numbers.chunks(2).map(|pair| pair[k]).collect();
    let panel = Panel {
        x_label: axis(&parameter.quantity(&plan)?),
        y_label: axis(&plan.layout.state()[coordinate]),
        curves: vec![Curve { x: of(0), y: of(1), stroke: Stroke::Dots, ..Curve::default() }],
        ..Panel::default()
    };
    Ok((numbers, panel))
}
