//! A plan written back as a scenario that says everything, so that a picture can give back its run.

use crate::family::FamilyMember;
use crate::figure::Stroke;
use crate::plan::{PanelPlan, Plan, Step};
use crate::scenario::STROKES;
use precess_system::{Default, Direction, Parameter};
use std::fmt::{Display, Formatter, Write};

/// The scenario file (TOML) with every parameter, start and setting written out.
pub fn scenario_toml(plan: &Plan) -> String {
    spelt_out(plan).to_string()
}

/// The same, to be written somewhere without being kept: a swarm has millions of starts.
pub fn spelt_out(plan: &Plan) -> impl Display + '_ {
    SpeltOut(plan)
}

struct SpeltOut<'a>(&'a Plan);

impl Display for SpeltOut<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        write(f, self.0)
    }
}

fn write(out: &mut Formatter, plan: &Plan) -> std::fmt::Result {
    writeln!(out, "precess = 1\ntitle = {}", text(&plan.title))?;
    if !plan.label.is_empty() {
        writeln!(out, "label = {}", text(&plan.label))?;
    }
    writeln!(out, "\n[system]\nid = \"{}\"\n\n[system.parameters]", plan.card.id)?;
    lines(out, &parameters(plan))?;
    writeln!(out, "\n[start]")?;
    starts(plan).try_for_each(|(name, value)| writeln!(out, "{name} = {value}"))?;
    writeln!(out, "\n[run]")?;
    lines(out, &settings(plan))?;
    for watch in &plan.watches {
        let direction = match watch.direction {
            Direction::Rising => "rising",
            Direction::Falling => "falling",
            Direction::Either => "either",
        };
        let when = format!("{} = {}", plan.column(watch.column).name, float(watch.value));
        writeln!(out, "\n[[event]]\nname = {}\nwhen = {}", text(&watch.name), text(&when))?;
        writeln!(out, "direction = \"{direction}\"\nstop = {}", watch.stop)?;
    }
    for member in &plan.members {
        writeln!(out, "\n[[family]]")?;
        lines(out, &family(member))?;
    }
    for panel in &plan.panels {
        writeln!(out, "\n[[figure]]")?;
        lines(out, &figure(panel))?;
    }
    if let Some(ensemble) = &plan.ensemble {
        write!(out, "\n{}", ensemble.toml())?;
    }
    Ok(())
}

/// Names with their values as TOML.
type Entries = Vec<(String, String)>;

fn lines(out: &mut Formatter, entries: &Entries) -> std::fmt::Result {
    entries.iter().try_for_each(|(name, value)| writeln!(out, "{name} = {value}"))
}

fn inline(entries: &Entries) -> String {
    let parts: Vec<String> = entries.iter().map(|(name, value)| format!("{name} = {value}")).collect();
    format!("{{ {} }}", parts.join(", "))
}

fn parameters(plan: &Plan) -> Entries {
    let (mut numbers, mut lists, mut choices) =
        (plan.values.numbers.iter(), plan.values.lists.iter(), plan.values.choices.iter());
    let parameter = |parameter: &Parameter| {
        let value = match &parameter.default {
            Default::Number(_) => numbers.next().map(|x| float(*x)),
            Default::List { .. } => lists.next().map(|l| {
                list(l.items.chunks_exact(l.width).map(|item| match item {
                    [x] => float(*x),
                    row => list(row.iter().map(|x| float(*x))),
                }))
            }),
            Default::Choice(options) => choices.next().map(|k| text(options[*k])),
        };
        (parameter.quantity.name.clone(), value.unwrap_or_default())
    };
    plan.card.parameters.iter().map(parameter).collect()
}

/// One after another, for there may be a million.
fn starts(plan: &Plan) -> impl Iterator<Item = (String, String)> + '_ {
    plan.layout.starts().zip(&plan.start).map(|(quantity, x)| (quantity.name, float(*x)))
}

fn settings(plan: &Plan) -> Entries {
    let mut settings = vec![("method".into(), text(plan.method.card().id))];
    match plan.step {
        Step::Fixed(dt) => settings.push(("dt".into(), float(dt))),
        Step::Adaptive { rtol, atol } => {
            settings.extend([("rtol".into(), float(rtol)), ("atol".into(), float(atol))]);
        }
    }
    for option in plan.method.card().options {
        settings.push((option.name.into(), float(plan.options.get(option.name))));
    }
    settings.extend([("until".into(), float(plan.until)), ("every".into(), float(plan.every))]);
    settings
}

/// A family of one.
fn family(member: &FamilyMember) -> Entries {
    // A list gives its items to the members one by one, so a value that is a list stands in another one.
    let single = |entries: Entries| {
        entries
            .into_iter()
            .map(|(n, v)| if v.starts_with('[') { (n, format!("[{v}]")) } else { (n, v) })
            .collect()
    };
    let mut entries = vec![
        ("name".into(), text(&member.family)),
        ("label".into(), text(&member.label)),
        ("system".into(), text(member.plan.card.id)),
        ("parameters".into(), inline(&single(parameters(&member.plan)))),
        ("start".into(), inline(&starts(&member.plan).collect())),
        ("run".into(), inline(&settings(&member.plan))),
        ("both_ways".into(), member.both_ways.to_string()),
    ];
    if !member.names.is_empty() {
        let names = member.names.iter().map(|(theirs, own)| (text(theirs), text(own))).collect();
        entries.push(("names".into(), inline(&names)));
    }
    entries.extend(style(member.style));
    entries
}

fn style(style: Option<Stroke>) -> Option<(String, String)> {
    let (name, _) = STROKES.iter().find(|(_, stroke)| Some(*stroke) == style)?;
    Some(("style".into(), text(name)))
}

fn figure(panel: &PanelPlan) -> Entries {
    let spec = &panel.spec;
    let mut entries: Entries =
        vec![("kind".into(), text(spec.kind.name())), ("title".into(), text(&spec.title))];
    let words =
        [("x", &spec.x), ("y", &spec.y), ("names", &spec.names), ("of", &spec.of), ("grid", &spec.grid)];
    for (name, words) in words {
        if !words.is_empty() {
            entries.push((name.into(), list(words.iter().map(|w| text(w)))));
        }
    }
    let ranges = [("x_range", panel.x_range), ("y_range", panel.y_range), ("between", panel.between)];
    for (name, range) in ranges {
        entries.extend(range.map(|(low, high)| (name.into(), list([float(low), float(high)]))));
    }
    if !panel.at.is_empty() {
        entries.push(("at".into(), list(panel.at.iter().map(|t| float(*t)))));
    }
    if !panel.marks.is_empty() {
        entries.push(("marks".into(), list(panel.marks.iter().map(|p| list(p.map(float))))));
    }
    entries.extend(style(spec.style));
    entries.extend(spec.levels.map(|n| ("levels".into(), n.to_string())));
    for (name, word) in [("sweep", &spec.sweep), ("section", &spec.section)] {
        entries.extend(word.as_ref().map(|w| (name.into(), text(w))));
    }
    let flags = [
        ("circles", spec.circles),
        ("starts", spec.starts),
        ("equal_scales", spec.equal_scales),
        ("logarithmic", spec.logarithmic),
    ];
    entries.extend(flags.iter().filter(|(_, set)| *set).map(|(name, _)| ((*name).into(), "true".into())));
    entries
}

fn list(items: impl IntoIterator<Item = String>) -> String {
    format!("[{}]", items.into_iter().collect::<Vec<_>>().join(", "))
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
