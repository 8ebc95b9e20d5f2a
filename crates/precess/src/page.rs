//! The catalogue as a page of Markdown (`docs/catalogue.md`): every system, from its card and its equations.

use crate::value::shortest;
use crate::{catalogue, equations};
use precess_scalar::Notation;
use precess_system::{
    AnySystem, Card, Coordinate, Default, Given, Layout, ObservableKind, Order, Parameter, Quantity, Values,
};
use std::fmt::{Result, Write};

/// Coordinates and observables beyond this many are not listed one by one.
const MOST: usize = 24;

/// The page.
pub fn page() -> String {
    let mut page = String::from(
        "# Catalogue\n\n\
         Every system, from the card that the program computes with. T and P are the two sources (see `errata.md`).\n\
         This page is generated: `PRECESS_BLESS=1 cargo test -p precess --test catalogue` writes it anew.\n\n",
    );
    for system in catalogue::systems() {
        let card = system.card();
        // Writing to a String cannot fail.
        let _ = writeln!(page, "- [`{0}`](#{0}): {1}", card.id, card.title.en);
    }
    for system in catalogue::systems() {
        let _ = entry(&mut page, *system);
    }
    page
}

fn entry(out: &mut String, system: &dyn AnySystem) -> Result {
    let card = system.card();
    let values = Values::defaults(&card);
    let layout = system.layout(&values, &Given::default());
    writeln!(out, "\n## {}\n\n**{}.** {}\n", card.id, card.title.en, card.about.en)?;
    writeln!(out, "Source: {}.\n", card.source.trim_end_matches('.'))?;
    let printed = equations(system, Notation::Text);
    writeln!(out, "```text")?;
    for (left, right) in printed.definitions.iter().chain(&printed.equations) {
        writeln!(out, "{left} = {right}")?;
    }
    writeln!(out, "```\n")?;
    coordinates(out, &layout)?;
    parameters(out, &card)?;
    observables(out, &layout)?;
    let names: Vec<_> = layout.events.iter().map(|e| format!("`{}`", e.name)).collect();
    if !names.is_empty() {
        writeln!(out, "Events: {}.\n", names.join(", "))?;
    }
    let solvable = system
        .start(&values, &layout, &Given::default())
        .and_then(|start| system.solvable(&values, &layout, &start));
    let exact = if solvable.is_ok() { "; `exact` knows its closed form" } else { "" };
    let run = card.defaults;
    writeln!(out, "A run without options: `{}` until {} s{exact}.", run.method, shortest(run.until))
}

fn coordinates(out: &mut String, layout: &Layout) -> Result {
    writeln!(out, "| coordinate | unit | start | start of its rate | |\n|---|---|---|---|---|")?;
    for Coordinate { quantity, order, start, start_dot, .. } in layout.coordinates.iter().take(MOST) {
        let rate = if order == Order::Second { shortest(start_dot) } else { "first order".into() };
        row(out, &quantity, &[&shortest(start), &rate])?;
    }
    more(out, layout.coordinates.len())
}

fn parameters(out: &mut String, card: &Card) -> Result {
    if card.parameters.is_empty() {
        return writeln!(out, "No parameters.\n");
    }
    writeln!(out, "| parameter | unit | default | values | |\n|---|---|---|---|---|")?;
    for parameter in &card.parameters {
        let (default, values) = default_of(parameter);
        row(out, &parameter.quantity, &[&default, &values])?;
    }
    writeln!(out)
}

/// The default of a parameter, and what else it may be.
fn default_of(parameter: &Parameter) -> (String, String) {
    let range = parameter.quantity.range;
    let bounds = match (range.low.is_finite(), range.high.is_finite()) {
        (false, _) => String::new(),
        (true, false) if range.open => format!("above {}", shortest(range.low)),
        (true, false) => format!("{} and above", shortest(range.low)),
        (true, true) => format!("{} to {}", shortest(range.low), shortest(range.high)),
    };
    match &parameter.default {
        Default::Number(x) => (shortest(*x), bounds),
        Default::List { fields, items } => {
            let one = |item: &[f64]| item.iter().map(|x| shortest(*x)).collect::<Vec<_>>().join("; ");
            let items = items.chunks(fields.len()).map(one);
            if fields.len() == 1 {
                (
                    format!("[{}]", items.collect::<Vec<_>>().join("; ")),
                    format!("a list {bounds}").trim().into(),
                )
            } else {
                let items: Vec<_> = items.map(|item| format!("[{item}]")).collect();
                (format!("[{}]", items.join("; ")), format!("a list of [{}]", fields.join("; ")))
            }
        }
        Default::Choice(options) => (options[0].into(), options.join(", ")),
    }
}

fn observables(out: &mut String, layout: &Layout) -> Result {
    if layout.observables.is_empty() {
        return Ok(());
    }
    writeln!(out, "| observable | unit | constant | |\n|---|---|---|---|")?;
    for observable in layout.observables.iter().take(MOST) {
        let constant = match &observable.kind {
            ObservableKind::Signal => String::new(),
            ObservableKind::Invariant { when_zero } if when_zero.is_empty() => "always".into(),
            ObservableKind::Invariant { when_zero } => format!("if {} = 0", when_zero.join(" = ")),
        };
        row(out, &observable.quantity, &[&constant])?;
    }
    more(out, layout.observables.len())
}

fn row(out: &mut String, quantity: &Quantity, cells: &[&str]) -> Result {
    writeln!(
        out,
        "| `{}` | {} | {} | {} |",
        quantity.name,
        quantity.unit,
        cells.join(" | "),
        quantity.text.en
    )
}

fn more(out: &mut String, count: usize) -> Result {
    let left = count.saturating_sub(MOST);
    if left > 0 { writeln!(out, "\nand {left} more like them.\n") } else { writeln!(out) }
}
