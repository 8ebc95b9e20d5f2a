//! The figure of a run: the scenario's panels, or the card's views and the drift of the invariants.

use crate::canonical::scenario_toml;
use crate::drift::departures;
use crate::figure::{Curve, Figure, Mark, Panel};
use crate::plan::{PanelPlan, Plan, Step};
use precess_system::{ColumnKind, Quantity, Trajectory, View};

/// The figure of a run.
pub fn picture(plan: &Plan, trajectory: &Trajectory) -> Figure {
    let columns = plan.columns();
    let mut panels: Vec<Panel> = if plan.panels.is_empty() {
        plan.card.views.iter().map(|view| view_panel(&columns, trajectory, view)).collect()
    } else {
        plan.panels.iter().map(|p| scenario_panel(p, &columns, trajectory)).collect()
    };
    if plan.panels.is_empty() {
        panels.extend(drift_panel(trajectory));
    }
    Figure { title: plan.title.clone(), subtitle: subtitle(plan), panels, scenario: scenario_toml(plan) }
}

/// Method and steps.
pub(crate) fn subtitle(plan: &Plan) -> String {
    let method = plan.method.card().id;
    match plan.step {
        Step::Fixed(dt) => format!("{method}, dt = {dt} s"),
        Step::Adaptive { rtol, atol } => format!("{method}, rtol = {rtol:e}, atol = {atol:e}"),
    }
}

/// Name and unit of an axis: `theta [rad]`.
pub(crate) fn axis(quantity: &Quantity) -> String {
    let name = readable(&quantity.name);
    if quantity.unit.is_empty() { name } else { format!("{name} [{}]", quantity.unit) }
}

/// `theta1_dot` to `θ1′`.
pub(crate) fn readable(name: &str) -> String {
    let (stem, prime) = name.strip_suffix("_dot").map_or((name, ""), |stem| (stem, "′"));
    let letters = stem.trim_end_matches(|c: char| c.is_ascii_digit());
    let greek = match letters {
        "theta" => "θ",
        "psi" => "ψ",
        "phi" => "φ",
        "omega" => "ω",
        other => other,
    };
    format!("{greek}{}{prime}", &stem[letters.len()..])
}

fn curve(columns: &[Quantity], trajectory: &Trajectory, x: usize, y: usize, label: bool) -> Curve {
    let values = |k: usize| trajectory.rows().map(|row| row[k]).collect();
    let label = if label { readable(&columns[y].name) } else { String::new() };
    Curve { label, x: values(x), y: values(y), ..Curve::default() }
}

fn scenario_panel(plan: &PanelPlan, columns: &[Quantity], trajectory: &Trajectory) -> Panel {
    let many = plan.y.len() > 1;
    Panel {
        title: plan.title.clone(),
        x_label: axis(&columns[plan.x]),
        y_label: shared_label(columns, &plan.y),
        equal_scales: plan.equal_scales,
        curves: plan.y.iter().map(|&y| curve(columns, trajectory, plan.x, y, many)).collect(),
        ..Panel::default()
    }
}

/// One quantity by its name, several by the unit they share.
fn shared_label(columns: &[Quantity], indices: &[usize]) -> String {
    match indices {
        [one] => axis(&columns[*one]),
        [first, rest @ ..] if rest.iter().all(|k| columns[*k].unit == columns[*first].unit) => {
            let unit = &columns[*first].unit;
            if unit.is_empty() { String::new() } else { format!("[{unit}]") }
        }
        _ => String::new(),
    }
}

/// More paths than this cannot be told apart.
const MOST_PATHS: usize = 16;

fn view_panel(columns: &[Quantity], trajectory: &Trajectory, view: &View) -> Panel {
    // A law holds the names in every view against the card; a name that is none draws nothing.
    let index = |name: &str| columns.iter().position(|q| q.name == name);
    match view {
        View::Time(names) => {
            let y = names.iter().filter_map(|name| index(name)).collect();
            scenario_panel(
                &PanelPlan { title: String::new(), x: 0, y, equal_scales: false },
                columns,
                trajectory,
            )
        }
        View::Plane { pairs, equal_scales } => {
            let pairs = expand(columns, pairs);
            let known = pairs.iter().filter_map(|(x, y)| index(x).zip(index(y)));
            let known: Vec<(usize, usize)> = known.take(MOST_PATHS).collect();
            let many = known.len() > 1;
            // Several bodies share their axes: the names without the number.
            let label = |k: usize| match axis(&columns[k]) {
                shared if many => shared.chars().filter(|c| !c.is_ascii_digit()).collect(),
                own => own,
            };
            let path = |&(x, y): &(usize, usize)| {
                let mut path = curve(columns, trajectory, x, y, false);
                if many {
                    path.label = format!("{}, {}", readable(&columns[x].name), readable(&columns[y].name));
                }
                path
            };
            let start = trajectory.rows().next();
            Panel {
                x_label: known.first().map_or(String::new(), |p| label(p.0)),
                y_label: known.first().map_or(String::new(), |p| label(p.1)),
                equal_scales: *equal_scales,
                curves: known.iter().map(path).collect(),
                marks: known
                    .iter()
                    .filter_map(|&(x, y)| start.map(|row| Mark { x: row[x], y: row[y], ..Mark::default() }))
                    .collect(),
                ..Panel::default()
            }
        }
    }
}

/// The pair (`x*`, `y*`) stands for (`x0`, `y0`), (`x1`, `y1`), ... as far as there are such coordinates.
fn expand(columns: &[Quantity], pairs: &[(String, String)]) -> Vec<(String, String)> {
    let mut all = vec![];
    for (x, y) in pairs {
        if !x.ends_with('*') {
            all.push((x.clone(), y.clone()));
            continue;
        }
        for k in 0..columns.len() {
            let pair = (x.replace('*', &k.to_string()), y.replace('*', &k.to_string()));
            if !columns.iter().any(|q| q.name == pair.0) {
                break;
            }
            all.push(pair);
        }
    }
    all
}

fn drift_panel(trajectory: &Trajectory) -> Option<Panel> {
    let columns = trajectory.columns.iter().enumerate();
    let invariants = columns.filter(|(_, c)| c.kind == ColumnKind::Invariant);
    let times: Vec<f64> = trajectory.rows().map(|row| row[0]).collect();
    let curves: Vec<Curve> = invariants
        .map(|(k, column)| {
            let values: Vec<f64> = trajectory.rows().map(|row| row[k]).collect();
            Curve {
                label: readable(&column.name),
                x: times.clone(),
                y: departures(&values),
                ..Curve::default()
            }
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
