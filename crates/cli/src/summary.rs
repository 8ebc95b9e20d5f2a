//! What a run tells on standard error when it is over.

use precess::system::ColumnKind;
use precess::value::shortest;
use precess::{Outcome, Plan, Step, drifts};
use std::fmt::Write;
use std::time::Duration;

/// Events beyond this are only counted.
const MOST_EVENTS: usize = 10;

/// Steps, cost, drift of every invariant, events, the state at the end.
pub fn summary(plan: &Plan, outcome: &Outcome, time: Duration) -> String {
    let mut text = String::new();
    let cost = &outcome.provenance;
    let steps = match plan.step {
        Step::Fixed(dt) => format!("dt = {} s", shortest(dt)),
        Step::Adaptive { rtol, atol } => format!("rtol = {rtol:e}, atol = {atol:e}"),
    };
    // Writing to a String cannot fail.
    let _ = writeln!(text, "{} by {} ({steps})", plan.card.id, plan.method.card().id);
    let _ = writeln!(
        text,
        "  {} steps, {} rejected, {} evaluations, {} samples in {}",
        cost.steps,
        cost.rejections,
        cost.evaluations,
        outcome.trajectory.len(),
        duration(time)
    );
    if let Step::Fixed(dt) = plan.step
        && dt > plan.every
    {
        let every = shortest(plan.every);
        let _ = writeln!(
            text,
            "  samples lie closer than dt, so the steps were shortened to {every} s (see --every)"
        );
    }
    for drift in drifts(&outcome.trajectory) {
        let relative = drift.relative().map_or_else(
            || format!("(it starts at zero; {} absolute)", with_unit(drift.largest, &drift.unit)),
            |_| format!("relative, from {}", with_unit(drift.start, &drift.unit)),
        );
        let number = drift.relative().unwrap_or(drift.largest);
        let _ = writeln!(text, "  drift of {:<18} {number:8.1e} {relative}", drift.name);
    }
    events(&mut text, outcome);
    end(&mut text, outcome);
    text
}

fn with_unit(x: f64, unit: &str) -> String {
    let digits = format!("{x:.6e}");
    let plain = x == 0.0 || x.abs() >= 1e-3 && x.abs() < 1e6;
    let number = if plain { format!("{x:.6}") } else { digits };
    if unit.is_empty() { number } else { format!("{number} {unit}") }
}

fn duration(time: Duration) -> String {
    let seconds = time.as_secs_f64();
    match seconds {
        s if s < 1e-3 => format!("{:.0} us", s * 1e6),
        s if s < 1.0 => format!("{:.1} ms", s * 1e3),
        s => format!("{s:.2} s"),
    }
}

fn events(text: &mut String, outcome: &Outcome) {
    let events = &outcome.trajectory.events;
    for event in events.iter().take(MOST_EVENTS) {
        let _ = writeln!(text, "  event {:<20} at t = {} s", event.name, shortest(event.t));
    }
    if events.len() > MOST_EVENTS {
        let _ = writeln!(text, "  and {} events more", events.len() - MOST_EVENTS);
    }
    if let Some(name) = &outcome.stopped_by {
        let _ = writeln!(text, "  stopped by {name}");
    }
}

fn end(text: &mut String, outcome: &Outcome) {
    let Some(last) = outcome.trajectory.rows().last() else { return };
    let columns = outcome.trajectory.columns.iter().zip(last);
    let state = columns.filter(|(c, _)| c.kind == ColumnKind::State).take(8);
    let state: Vec<String> = state.map(|(c, x)| format!("{} = {}", c.name, with_unit(*x, ""))).collect();
    let _ = writeln!(text, "  at t = {} s: {}", shortest(last[0]), state.join(", "));
}
