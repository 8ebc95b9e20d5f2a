//! `precess show SYSTEM`: everything a card says, and the equations it is integrated with.

use crate::failure::Failure;
use crate::list;
use precess::scalar::Notation;
use precess::system::{Card, Default, Given, Layout, ObservableKind, Order, Quantity, Values};
use precess::{catalogue, equations, json, value::shortest};
use std::fmt::Write;

/// Shows a system.
pub fn show(id: &str, as_json: bool, latex: bool) -> Result<(), Failure> {
    let system = catalogue::system(id)?;
    if as_json {
        return list::print(&format!("{:#}\n", json::system(system)));
    }
    let card = system.card();
    let layout = system.layout(&Values::defaults(&card), &Given::default());
    let mut text =
        format!("{}  ({})\n\n{}\n\nSource: {}\n", card.title.en, card.id, card.about.en, card.source);
    let printed = equations(system, if latex { Notation::Latex } else { Notation::Text });
    // Writing to a String cannot fail.
    let _ = writeln!(text, "\nEquations");
    for (left, right) in &printed.equations {
        let _ = writeln!(text, "  {left} = {right}");
    }
    for (k, (name, meaning)) in printed.definitions.iter().enumerate() {
        let word = if k == 0 { "with" } else { "    " };
        let _ = writeln!(text, "  {word} {name} = {meaning}");
    }
    coordinates(&mut text, &layout);
    parameters(&mut text, &card);
    observables(&mut text, &layout);
    if !card.starts.is_empty() {
        let names: Vec<&str> = card.starts.iter().map(|q| q.name.as_str()).collect();
        let _ = writeln!(text, "\nStarts may also be given as\n  {}", names.join(", "));
    }
    let defaults = card.defaults;
    let _ = writeln!(
        text,
        "\nA run without options\n  {} until {} s (fixed-step methods: dt = {} s)",
        defaults.method,
        shortest(defaults.until),
        shortest(defaults.dt)
    );
    list::print(&text)
}

/// Aligned columns: name, value, unit, meaning.
fn table(text: &mut String, heading: &str, rows: &[[String; 4]]) {
    if rows.is_empty() {
        return;
    }
    let width = |k: usize| rows.iter().map(|r| r[k].chars().count()).max().unwrap_or(0);
    let (name, value, unit) = (width(0), width(1), width(2));
    let _ = writeln!(text, "\n{heading}");
    for row in rows {
        let line = format!("  {:name$}  {:>value$}  {:unit$}  {}", row[0], row[1], row[2], row[3]);
        let _ = writeln!(text, "{}", line.trim_end());
    }
}

fn row(quantity: &Quantity, value: String) -> [String; 4] {
    [quantity.name.clone(), value, quantity.unit.clone(), quantity.text.en.clone()]
}

fn coordinates(text: &mut String, layout: &Layout) {
    let mut rows: Vec<_> = layout.coordinates.iter().map(|c| row(&c.quantity, shortest(c.start))).collect();
    let second = layout.coordinates.iter().filter(|c| c.order == Order::Second);
    rows.extend(second.map(|c| row(&c.velocity(), shortest(c.start_dot))));
    table(text, "State, with its start", &rows);
}

fn parameters(text: &mut String, card: &Card) {
    let value = |default: &Default| match default {
        Default::Number(x) => shortest(*x),
        Default::List { fields, items } => {
            let item = |numbers: &[f64]| {
                let numbers: Vec<String> = numbers.iter().map(|x| shortest(*x)).collect();
                if fields.len() == 1 { numbers.join("") } else { format!("[{}]", numbers.join("; ")) }
            };
            format!("[{}]", items.chunks(fields.len()).map(item).collect::<Vec<_>>().join("; "))
        }
        Default::Choice(options) => options.join(" | "),
    };
    let rows: Vec<_> = card.parameters.iter().map(|p| row(&p.quantity, value(&p.default))).collect();
    table(text, "Parameters", &rows);
}

fn observables(text: &mut String, layout: &Layout) {
    let split = |invariant: bool| {
        let kind = move |kind: &ObservableKind| (*kind != ObservableKind::Signal) == invariant;
        layout.observables.iter().filter(move |o| kind(&o.kind))
    };
    let invariants: Vec<_> = split(true)
        .map(|o| {
            let mut row = row(&o.quantity, String::new());
            if let ObservableKind::Invariant { when_zero } = &o.kind
                && !when_zero.is_empty()
            {
                let _ = write!(row[3], " (where {} = 0)", when_zero.join(" = "));
            }
            row
        })
        .collect();
    table(text, "Invariants", &invariants);
    let signals: Vec<_> = split(false).map(|o| row(&o.quantity, String::new())).collect();
    table(text, "Other observables", &signals);
}
