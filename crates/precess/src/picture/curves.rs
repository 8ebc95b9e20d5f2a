//! Quantities of trajectories against one another, and where everything is at a few times.

use super::labels::{axis, readable, shared};
use super::shown::Shown;
use crate::figure::{Curve, Mark, Panel, Stroke};
use crate::panel::starred;
use crate::plan::PanelPlan;
use crate::value::shortest;
use precess_system::Quantity;
use std::collections::HashMap;

/// Curves of the chosen trajectories.
pub(crate) fn curves(panel: &PanelPlan, shown: &[Shown]) -> Panel {
    let chosen = chosen(panel, shown);
    let pairs = pairs(panel, shown);
    let planes = pairs.iter().any(|(x, _)| *x != pairs[0].0);
    let mut drawn = framed(panel, shown, &pairs);
    let mut inks: Vec<String> = vec![];
    for (one, own_ink) in chosen.iter().zip(own_inks(&chosen, shown)) {
        for (k, (x, y)) in pairs.iter().enumerate() {
            let (Some(i), Some(j)) = (one.column(x), one.column(y)) else { continue };
            let quantity = match (panel.spec.names.get(k), pairs.len(), planes) {
                (Some(name), ..) => name.clone(),
                (_, 1, _) => String::new(),
                (.., true) => format!("{}, {}", readable(x), readable(y)),
                (.., false) => readable(y),
            };
            // A trajectory alone in its panel needs no name.
            let own = if chosen.len() > 1 { one.label } else { "" };
            let between = if own.is_empty() || quantity.is_empty() { "" } else { ": " };
            let label = format!("{own}{between}{quantity}");
            let stroke = panel.spec.style.unwrap_or(one.style);
            // Curves of one name have one colour.
            let ink = if pairs.len() == 1 {
                own_ink
            } else {
                inks.iter().position(|name| *name == label).unwrap_or_else(|| {
                    inks.push(label.clone());
                    inks.len() - 1
                })
            };
            let rows = || one.trajectory.rows().filter(|row| within(panel, row[0]));
            let values = |k: usize| rows().map(|row| row[k]).collect::<Vec<f64>>();
            drawn.curves.push(Curve { label, x: values(i), y: values(j), ink: Some(ink), stroke });
            if panel.spec.starts {
                let colour = (chosen.len() > 1).then_some(ink);
                let start = one.sample(0.0).filter(|row| within(panel, row[0]));
                drawn.marks.extend(start.map(|row| Mark {
                    x: row[i],
                    y: row[j],
                    ink: colour,
                    ..Mark::default()
                }));
            }
            #[cfg(feature = "analyses")]
            if panel.spec.circles {
                let circle = |(k, row): (usize, &[f64])| {
                    crate::analyses::osculating(one.plan, row, [i, j], ink + 1 + k)
                };
                let rows = panel.at.iter().filter_map(|&t| one.sample(t)).enumerate();
                drawn.curves.extend(rows.filter_map(circle));
            }
            let dots = panel.at.iter().filter_map(|&t| one.sample(t));
            let dot = |row: &[f64]| Mark { x: row[i], y: row[j], ink: Some(ink), ..Mark::default() };
            drawn.marks.extend(dots.map(dot));
        }
    }
    drawn
}

/// The colours of trajectories: a name has the same one in all panels; where nothing is named, colours come round without
/// dashes.
pub(super) fn own_inks(chosen: &[&Shown], shown: &[Shown]) -> Vec<usize> {
    let mut names: Vec<&str> = vec![];
    for one in shown.iter().filter(|one| !one.label.is_empty()) {
        if !names.contains(&one.label) {
            names.push(one.label);
        }
    }
    let nameless = usize::from(chosen.iter().any(|one| one.label.is_empty()));
    let mut further = 0;
    let ink = |one: &&Shown| {
        if let Some(place) = names.iter().position(|name| *name == one.label) {
            return place + nameless;
        }
        further += 1;
        if further == 1 { 0 } else { (names.len() + further - 1) % 8 }
    };
    chosen.iter().map(ink).collect()
}

/// Dots where everything is: a colour for each time. What others move round (all but satellites) has a larger one.
pub(super) fn snapshot(panel: &PanelPlan, shown: &[Shown]) -> Panel {
    let pairs = pairs(panel, shown);
    let mut drawn = framed(panel, shown, &pairs);
    for (ink, &t) in panel.at.iter().enumerate() {
        let mut dots = Curve {
            label: if panel.at.len() > 1 { format!("t = {} s", shortest(t)) } else { String::new() },
            stroke: Stroke::Dots,
            ink: Some(ink),
            ..Curve::default()
        };
        for one in chosen(panel, shown) {
            let Some(row) = one.sample(t) else { continue };
            let heavy = one.plan.system.satellites(&one.plan.values, 1).map_or(0, |s| s.rest);
            for (x, y) in &pairs {
                let (Some(i), Some(j)) = (one.column(x), one.column(y)) else { continue };
                if i <= heavy {
                    drawn.marks.push(Mark { x: row[i], y: row[j], ink: Some(ink), ..Mark::default() });
                } else {
                    dots.x.push(row[i]);
                    dots.y.push(row[j]);
                }
            }
        }
        drawn.curves.push(dots);
    }
    drawn
}

/// An empty panel with its labels and ranges.
fn framed(panel: &PanelPlan, shown: &[Shown], pairs: &[(String, String)]) -> Panel {
    let columns = shown.first().map_or(vec![], |run| run.plan.columns());
    let known: HashMap<&str, &Quantity> = columns.iter().map(|q| (q.name.as_str(), q)).collect();
    let xs: Vec<&Quantity> = pairs.iter().filter_map(|(x, _)| known.get(&**x).copied()).collect();
    let ys: Vec<&Quantity> = pairs.iter().filter_map(|(_, y)| known.get(&**y).copied()).collect();
    Panel {
        title: panel.spec.title.clone(),
        x_label: shared(&xs),
        y_label: if ys.len() == 1 { axis(ys[0]) } else { shared(&ys) },
        equal_scales: panel.spec.equal_scales,
        logarithmic: panel.spec.logarithmic,
        x_range: panel.x_range,
        y_range: panel.y_range,
        marks: panel.marks.iter().map(|&[x, y]| Mark { x, y, ink: Some(1), ..Mark::default() }).collect(),
        ..Panel::default()
    }
}

/// The trajectories that a panel asks for.
pub(super) fn chosen<'a, 'b>(panel: &PanelPlan, shown: &'b [Shown<'a>]) -> Vec<&'b Shown<'a>> {
    let of = &panel.spec.of;
    shown.iter().filter(|one| of.is_empty() || of.iter().any(|name| name == one.family)).collect()
}

fn within(panel: &PanelPlan, t: f64) -> bool {
    panel.between.is_none_or(|(from, to)| from <= t && t <= to)
}

/// What is drawn against what: one x for all or one for each y, numbered names written out.
fn pairs(panel: &PanelPlan, shown: &[Shown]) -> Vec<(String, String)> {
    let columns = shown.first().map_or(vec![], |run| run.plan.columns());
    let written = |name: &String| {
        let all = starred(&columns, name);
        if all.is_empty() { vec![name.clone()] } else { all }
    };
    let time = "t".to_string();
    let x = |k: usize| match &panel.spec.x[..] {
        [] => &time,
        [one] => one,
        many => &many[k],
    };
    let mut pairs = vec![];
    for (k, y) in panel.spec.y.iter().enumerate() {
        let (xs, ys) = (written(x(k)), written(y));
        let x = |i: usize| if xs.len() == 1 { xs[0].clone() } else { xs[i].clone() };
        let count = if xs.len() == 1 || xs.len() > ys.len() { ys.len() } else { xs.len() };
        pairs.extend((0..count).map(|i| (x(i), ys[i].clone())));
    }
    pairs
}
