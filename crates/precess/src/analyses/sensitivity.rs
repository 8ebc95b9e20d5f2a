//! Sensitivities: how the motion answers to its start and its parameters, by the variational equations.

use super::numbers::{exists, parameter, unit_of};
use super::subject::{Subject, failed, forwards, smooth};
use super::{Answer, Progress, table};
use crate::canonical::scenario_toml;
use crate::error::{Error, input};
use crate::figure::{Curve, Figure, Panel};
use crate::picture::subtitle;
use crate::plan::Plan;
use crate::scenario::Scenario;
use precess_scalar::Dual;
use precess_system::{Bind, Field};

/// A motion and its derivatives.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sensitivities {
    /// The times.
    pub times: Vec<f64>,
    /// Numbers of the state and observables, in the order of the plan's columns; time by time.
    pub values: Vec<f64>,
    /// Their derivatives along each direction in turn; time by time.
    pub slopes: Vec<f64>,
}

/// One direction: a number of the start that moves, or a parameter.
struct Along {
    start: Vec<f64>,
    field: Box<dyn Field<Dual<f64>>>,
}

/// The motion at these times (not falling, from zero on) and its derivatives with respect to numbers of the start and
/// numeric parameters; an item of a list is written `masses[0]`. The start does not move with a parameter.
///
/// # Errors
/// Where a name is no such number, times make no sense, the system has events, or the motion cannot be integrated.
pub fn sensitivities(
    plan: &Plan,
    names: &[String],
    times: &[f64],
    progress: Progress,
) -> Result<Sensitivities, Error> {
    smooth(plan, "a sensitivity")?;
    let along: Vec<Along> = names.iter().map(|name| direction(plan, name)).collect::<Result<_, _>>()?;
    let fields: Vec<&dyn Field<Dual<f64>>> = along.iter().map(|a| a.field.as_ref()).collect();
    let subject = Subject::new(plan)?;
    let end = times.last().copied().filter(|t| *t > 0.0).unwrap_or(1.0);
    let mut share = |t: f64| progress(t / end);
    let flow = subject.flow(&mut share);
    let mut state = plan.start.clone();
    let mut vectors: Vec<Vec<f64>> = along.iter().map(|a| a.start.clone()).collect();
    let mut found = Sensitivities { times: times.to_vec(), ..Sensitivities::default() };
    let mut now = 0.0;
    for &t in times {
        if !(t.is_finite() && t >= now) {
            return input(format!("times must not fall, nor lie before zero: {t} follows {now}"));
        }
        if t > now
            && let Err(failure) = flow.carry_along(&fields, now, &mut state, &mut vectors, t - now)
        {
            return failed(&failure);
        }
        now = t;
        observe(&subject, t, &state, &along, &vectors, &mut found);
    }
    Ok(found)
}

/// State and observables, and their derivatives.
fn observe(
    subject: &Subject,
    t: f64,
    state: &[f64],
    along: &[Along],
    vectors: &[Vec<f64>],
    found: &mut Sensitivities,
) {
    let size = subject.plan.layout.shape().state();
    let mut observed = vec![0.0; subject.plan.layout.observables.len()];
    subject.field.observe(t, state, &mut observed);
    found.values.extend_from_slice(&state[..size]);
    found.values.extend(observed.iter());
    let mut moved = vec![Dual::constant(0.0); observed.len()];
    for (along, vector) in along.iter().zip(vectors) {
        let dual: Vec<Dual<f64>> = state.iter().zip(vector).map(|(x, v)| Dual::new(*x, *v)).collect();
        along.field.observe(Dual::constant(t), &dual, &mut moved);
        found.slopes.extend_from_slice(&vector[..size]);
        found.slopes.extend(moved.iter().map(|d| d.slope));
    }
}

/// What moves along a name.
fn direction(plan: &Plan, name: &str) -> Result<Along, Error> {
    exists(plan, name)?;
    let mut start = vec![0.0; plan.start.len()];
    let mut values = plan.values.map(|&x| Dual::from(x));
    match plan.layout.state().iter().position(|q| q.name == name) {
        Some(k) => start[k] = 1.0,
        None => parameter(plan, name, &mut values).into_iter().for_each(|number| number.slope = 1.0),
    }
    Ok(Along { start, field: Bind::<Dual<f64>>::bind(plan.system, values, &plan.layout) })
}

/// The sensitivities of a scenario at its samples, as a table: `theta`, `dtheta_dl` and so on.
///
/// # Errors
/// As [`sensitivities`], and where the scenario makes no sense.
pub fn sensitivity(scenario: &Scenario, names: &[String], progress: Progress) -> Result<Answer, Error> {
    let plan = Plan::new(scenario)?;
    forwards(&plan)?;
    if names.is_empty() {
        return input("a sensitivity needs something to move: a number of the start, or a parameter");
    }
    let samples = precess_integrate::Samples::new(plan.until, plan.every);
    let times: Vec<f64> = (0..=samples.last()).map(|k| samples.time(k)).collect();
    let found = sensitivities(&plan, names, &times, progress)?;
    let quantities = &plan.columns()[1..];
    let mut columns = vec![("t".to_string(), "s".to_string())];
    columns.extend(quantities.iter().map(|q| (q.name.clone(), q.unit.clone())));
    for name in names {
        let over = unit_of(&plan, name);
        columns.extend(quantities.iter().map(|q| (format!("d{}_d{name}", q.name), ratio(&q.unit, &over))));
    }
    let width = quantities.len();
    let rows =
        found.times.iter().zip(found.values.chunks(width)).zip(found.slopes.chunks(width * names.len()));
    let numbers = rows.flat_map(|((t, values), slopes)| [&[*t], values, slopes].concat()).collect();
    let borrowed: Vec<_> = columns.iter().map(|(name, unit)| (name.as_str(), unit.as_str())).collect();
    let figure = picture(&plan, &found, names);
    Ok(Answer { table: table(&borrowed, numbers), figure, summary: vec![], failure: None })
}

fn ratio(unit: &str, over: &str) -> String {
    let one = if unit.is_empty() { "1" } else { unit };
    match over {
        "" | "1" => unit.into(),
        over if over.contains([' ', '/']) => format!("{one}/({over})"),
        over => format!("{one}/{over}"),
    }
}

/// A panel for each direction, with the derivatives of the coordinates.
fn picture(plan: &Plan, found: &Sensitivities, names: &[String]) -> Figure {
    let quantities = &plan.columns()[1..];
    let width = quantities.len();
    let curve = |along: usize, k: usize| Curve {
        label: quantities[k].name.clone(),
        x: found.times.clone(),
        y: found.slopes.chunks(width * names.len()).map(|slopes| slopes[along * width + k]).collect(),
        ..Curve::default()
    };
    let coordinates = plan.layout.coordinates.len();
    let panel = |(along, name): (usize, &String)| Panel {
        title: format!("Derivative with respect to {name}"),
        x_label: "t [s]".into(),
        curves: (0..coordinates).map(|k| curve(along, k)).collect(),
        ..Panel::default()
    };
    Figure {
        title: plan.title.clone(),
        subtitle: subtitle(plan),
        panels: names.iter().enumerate().map(panel).collect(),
        scenario: scenario_toml(plan),
    }
}
