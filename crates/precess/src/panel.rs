//! A panel held against the quantities of a run.

use crate::error::{Error, input, quoted, unknown};
use crate::plan::{PanelPlan, Plan};
use crate::resolve;
use crate::scenario::{FigureKind, FigureSpec};
use crate::value::Value;
use precess_system::Quantity;
use std::collections::HashSet;

/// What a panel calls the run itself.
pub(crate) const RUN: &str = "run";

/// A panel of a plan whose families are known.
pub(crate) fn panel(plan: &Plan, figure: &FigureSpec) -> Result<PanelPlan, Error> {
    let at = |e: Error| e.at(&format!("figure {}", quoted(&figure.title)));
    held(plan, figure).map_err(at)
}

fn held(plan: &Plan, figure: &FigureSpec) -> Result<PanelPlan, Error> {
    let columns = plan.columns();
    for name in figure.x.iter().chain(&figure.y).filter(|_| figure.kind != FigureKind::Response) {
        if starred(&columns, name).is_empty() {
            resolve::column(plan, name)?;
        }
    }
    if figure.x.len() > 1 && figure.x.len() != figure.y.len() {
        return input(format!(
            "x has {} quantities and y has {}: one x for all, or one for each y",
            figure.x.len(),
            figure.y.len()
        ));
    }
    let families = || std::iter::once(RUN).chain(plan.members.iter().map(|m| m.family.as_str()));
    if let Some(stranger) = figure.of.iter().find(|name| !families().any(|known| known == *name)) {
        return Err(unknown("family", stranger, families()));
    }
    let unit = |names: &[String], otherwise: &str| {
        let name = names.first().map_or(otherwise, String::as_str);
        columns.iter().find(|q| q.name == name.replace('*', "0")).map_or(String::new(), |q| q.unit.clone())
    };
    let first = |k: usize| plan.layout.state().get(k).map_or(String::new(), |q| q.name.clone());
    let (x, y) = match figure.kind {
        FigureKind::Curves => ("t".to_string(), String::new()),
        _ => (first(0), first(1)),
    };
    let range = |ends: &Option<[Value; 2]>, unit: &str, what: &str| -> Result<Option<(f64, f64)>, Error> {
        let Some([low, high]) = ends else { return Ok(None) };
        let (low, high) = (low.in_unit(unit), high.in_unit(unit));
        let (low, high) = low.and_then(|l| high.map(|h| (l, h))).map_err(|e| e.at(what))?;
        if low < high { Ok(Some((low, high))) } else { input(format!("{what}: {low} is not below {high}")) }
    };
    let at = figure.at.iter().map(|v| v.in_unit("s")).collect::<Result<_, _>>();
    Ok(PanelPlan {
        x_range: range(&figure.x_range, &unit(&figure.x, &x), "x_range")?,
        y_range: range(&figure.y_range, &unit(&figure.y, &y), "y_range")?,
        between: range(&figure.between, "s", "between")?,
        at: at.map_err(|e: Error| e.at("at"))?,
        marks: figure
            .marks
            .iter()
            .map(|[x, y]| Ok([x.in_unit("")?, y.in_unit("")?]))
            .collect::<Result<_, Error>>()
            .map_err(|e| e.at("marks"))?,
        spec: figure.clone(),
    })
}

/// The quantities that `x*` stands for: `x0`, `x1`, ... as far as there are any.
pub(crate) fn starred(columns: &[Quantity], name: &str) -> Vec<String> {
    if !name.contains('*') {
        return vec![];
    }
    let numbered = (0..columns.len()).map(|k| name.replace('*', &k.to_string()));
    let names: HashSet<&str> = columns.iter().map(|q| q.name.as_str()).collect();
    numbered.take_while(|own| names.contains(own.as_str())).collect()
}
