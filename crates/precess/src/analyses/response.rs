//! Amplitude and phase of the settled motion against a parameter of the drive.

use super::subject::{Subject, failed, period, smooth, state_number};
use super::{Answer, Progress, Sweep, sweep, table};
use crate::canonical::scenario_toml;
use crate::error::Error;
use crate::figure::{Curve, Figure, Panel, Stroke};
use crate::picture::{axis, readable, subtitle};
use crate::plan::Plan;
use crate::scenario::Scenario;
use precess_analysis::{Response, exact_response};

/// Which response.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ResponseSpec {
    /// `frequency=0.2:3:200`.
    pub sweep: String,
    /// The number of the state; the first coordinate where absent.
    pub coordinate: Option<String>,
    /// From the last value to the first: a branch is followed, so the way matters where there are two.
    pub down: bool,
}

/// A value of the parameter with the measured and, for linear equations, the exact response.
type Found = (f64, Response, Option<Response>);

/// The response at every value.
///
/// # Errors
/// Where the scenario or the sweep makes no sense, or there is no drive.
pub fn response(scenario: &Scenario, spec: &ResponseSpec, progress: Progress) -> Result<Answer, Error> {
    let plan = Plan::new(scenario)?;
    let found = found(scenario, spec, progress)?;
    let panels = panels(&plan, spec, &found)?.to_vec();
    let nan = Response { omega: f64::NAN, amplitude: f64::NAN, lag: f64::NAN, swing: f64::NAN };
    let row = |(x, own, exact): &Found| {
        let exact = exact.unwrap_or(nan);
        [*x, own.omega, own.amplitude, own.lag, own.swing, exact.amplitude, exact.lag]
    };
    let quantity = Sweep::parse(&spec.sweep)?.quantity(&plan)?;
    let coordinate = &plan.layout.state()[state_number(&plan, spec.coordinate.as_deref())?];
    let columns = [
        (quantity.name.as_str(), quantity.unit.as_str()),
        ("omega", "rad/s"),
        ("amplitude", coordinate.unit.as_str()),
        ("lag", "rad"),
        ("swing", coordinate.unit.as_str()),
        ("exact_amplitude", coordinate.unit.as_str()),
        ("exact_lag", "rad"),
    ];
    let mut summary = vec![];
    if let Some((x, best, _)) = found.iter().max_by(|a, b| a.1.amplitude.total_cmp(&b.1.amplitude)) {
        summary.push(format!("largest amplitude {:.6} at {} = {x:.6}", best.amplitude, quantity.name));
    }
    let apart =
        found.iter().filter_map(|(_, own, exact)| exact.map(|e| (own.amplitude / e.amplitude - 1.0).abs()));
    if let Some(apart) = apart.max_by(f64::total_cmp) {
        summary.push(format!(
            "the equations are linear; largest relative distance from the exact answer {apart:.1e}"
        ));
    }
    let figure = Figure {
        title: format!("{}: response", plan.title),
        subtitle: subtitle(&plan),
        panels,
        scenario: scenario_toml(&plan),
    };
    let numbers = found.iter().flat_map(row).collect();
    Ok(Answer { table: table(&columns, numbers), figure, summary, failure: None })
}

/// The responses in the order of the sweep.
pub(super) fn found(
    scenario: &Scenario,
    spec: &ResponseSpec,
    progress: Progress,
) -> Result<Vec<Found>, Error> {
    let plan = Plan::new(scenario)?;
    smooth(&plan, "a response")?;
    let coordinate = state_number(&plan, spec.coordinate.as_deref())?;
    let parameter = Sweep::parse(&spec.sweep)?;
    let mut values = parameter.numbers(&plan)?;
    if spec.down {
        values.reverse();
    }
    let mut state = plan.start.clone();
    let mut found = vec![];
    for (k, &x) in values.iter().enumerate() {
        let own = sweep::at(scenario, &[(parameter.name.clone(), x)])?;
        let period = period(&own, "a response")?;
        let subject = Subject::new(&own)?;
        let share = k as f64 / values.len() as f64;
        let mut watch = |_: f64| progress(share);
        let flow = subject.flow(&mut watch);
        let settle = own.until.abs() / period;
        match precess_analysis::response(&flow, &mut state, period, settle, coordinate) {
            Ok(response) => found.push((x, response, exact_response(&flow, period, coordinate))),
            Err(failure) => return failed(&failure),
        }
    }
    Ok(found)
}

/// Amplitude, and lag behind the drive.
pub(super) fn panels(plan: &Plan, spec: &ResponseSpec, found: &[Found]) -> Result<[Panel; 2], Error> {
    let quantity = Sweep::parse(&spec.sweep)?.quantity(plan)?;
    let coordinate = &plan.layout.state()[state_number(plan, spec.coordinate.as_deref())?];
    let unit = if coordinate.unit.is_empty() { String::new() } else { format!(" [{}]", coordinate.unit) };
    let panel = |y_label: String, of: &dyn Fn(&Response) -> f64| {
        let x: Vec<f64> = found.iter().map(|f| f.0).collect();
        let own = found.iter().map(|f| of(&f.1)).collect();
        let mut curves = vec![Curve { label: "measured".into(), x: x.clone(), y: own, ..Curve::default() }];
        if found.iter().any(|f| f.2.is_some()) {
            let y = found.iter().map(|f| f.2.as_ref().map_or(f64::NAN, of)).collect();
            curves.push(Curve { label: "exact".into(), x, y, stroke: Stroke::Dashed, ..Curve::default() });
        }
        Panel { x_label: axis(&quantity), y_label, curves, ..Panel::default() }
    };
    let name = readable(&coordinate.name);
    Ok([
        panel(format!("amplitude of {name}{unit}"), &|r| r.amplitude),
        panel("lag behind the drive [rad]".into(), &|r| r.lag),
    ])
}
