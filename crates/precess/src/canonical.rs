//! A plan written back as a scenario that says everything, so that a picture can give back its run.

use crate::plan::{Plan, Step};
use precess_system::{Default, Direction};
use std::fmt::Write;

/// The scenario file (TOML) with every parameter, start and setting written out.
pub fn scenario_toml(plan: &Plan) -> String {
    let mut toml = String::new();
    // Writing to a String cannot fail.
    let _ = write(&mut toml, plan);
    toml
}

fn write(out: &mut String, plan: &Plan) -> std::fmt::Result {
    writeln!(out, "precess = 1\ntitle = {}\n", text(&plan.title))?;
    writeln!(out, "[system]\nid = \"{}\"\n\n[system.parameters]", plan.card.id)?;
    let (mut numbers, mut lists, mut choices) =
        (plan.values.numbers.iter(), plan.values.lists.iter(), plan.values.choices.iter());
    for parameter in &plan.card.parameters {
        let value = match &parameter.default {
            Default::Number(_) => numbers.next().map(|x| float(*x)),
            Default::List { .. } => lists.next().map(|l| {
                let items = l.items.chunks_exact(l.width).map(|item| match item {
                    [x] => float(*x),
                    row => format!("[{}]", row.iter().map(|x| float(*x)).collect::<Vec<_>>().join(", ")),
                });
                format!("[{}]", items.collect::<Vec<_>>().join(", "))
            }),
            Default::Choice(options) => choices.next().map(|k| text(options[*k])),
        };
        writeln!(out, "{} = {}", parameter.quantity.name, value.unwrap_or_default())?;
    }
    writeln!(out, "\n[start]")?;
    for (name, x) in plan.given().0 {
        writeln!(out, "{name} = {}", float(x))?;
    }
    writeln!(out, "\n[run]\nmethod = \"{}\"", plan.method.card().id)?;
    match plan.step {
        Step::Fixed(dt) => writeln!(out, "dt = {}", float(dt))?,
        Step::Adaptive { rtol, atol } => writeln!(out, "rtol = {}\natol = {}", float(rtol), float(atol))?,
    }
    for option in plan.method.card().options {
        writeln!(out, "{} = {}", option.name, float(plan.options.get(option.name)))?;
    }
    writeln!(out, "until = {}\nevery = {}", float(plan.until), float(plan.every))?;
    let columns = plan.columns();
    for watch in &plan.watches {
        let direction = match watch.direction {
            Direction::Rising => "rising",
            Direction::Falling => "falling",
            Direction::Either => "either",
        };
        let when = format!("{} = {}", columns[watch.column].name, float(watch.value));
        writeln!(out, "\n[[event]]\nname = {}\nwhen = {}", text(&watch.name), text(&when))?;
        writeln!(out, "direction = \"{direction}\"\nstop = {}", watch.stop)?;
    }
    for panel in &plan.panels {
        let y: Vec<_> = panel.y.iter().map(|&k| text(&columns[k].name)).collect();
        writeln!(out, "\n[[figure]]\ntitle = {}\nx = {}", text(&panel.title), text(&columns[panel.x].name))?;
        writeln!(out, "y = [{}]\nequal_scales = {}", y.join(", "), panel.equal_scales)?;
    }
    Ok(())
}

/// The shortest decimal that reads back to the same bits.
fn float(x: f64) -> String {
    format!("{x:?}")
}

/// A TOML basic string.
fn text(text: &str) -> String {
    let mut quoted = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            c if c.is_control() => {
                let _ = write!(quoted, "\\u{:04X}", c as u32);
            }
            c => quoted.push(c),
        }
    }
    quoted + "\""
}
