//! What is said of a result beside its numbers, as JSON.

use precess::basins::Attractor;
use precess::system::{Column, ColumnKind, Event, Trajectory};
use precess::{Answer, Drift, Members, Plan, Provenance, hash_text, scenario_toml};
use serde_json::{Value, json};

/// The report of a run. A number that is not finite is null, as JSON has it.
pub fn run(
    trajectory: &Trajectory,
    events: &[String],
    plan: &Plan,
    provenance: &Provenance,
    drifts: &[Drift],
    stopped_by: Option<&str>,
    failure: Option<&str>,
) -> Value {
    let known = &plan.layout.events;
    let scenario = scenario_toml(plan);
    json!({
        "rows": trajectory.len(),
        "columns": trajectory.columns.iter().map(|c| column(&c)).collect::<Vec<_>>(),
        "events": events,
        "event_texts": events.iter().map(|name| told(name, known)).collect::<Vec<_>>(),
        "drifts": drifts.iter().map(drift).collect::<Vec<_>>(),
        "stopped_by": stopped_by,
        "failure": failure,
        "version": provenance.version,
        "scenario_hash": hash_text(&scenario),
        "scenario": scenario,
        "steps": provenance.steps,
        "rejections": provenance.rejections,
        "evaluations": provenance.evaluations,
    })
}

/// What a system says of an event of its own; null for one that the scenario watches.
fn told(name: &str, known: &[Event]) -> Value {
    let event = known.iter().find(|event| event.name == name);
    event.map_or(Value::Null, |Event { text, .. }| json!({ "en": text.en, "fr": text.fr }))
}

/// The numbers of a state.
fn state(plan: &Plan) -> Vec<Value> {
    plan.layout.quantities().map(|q| json!({ "name": q.name, "unit": q.unit })).collect()
}

/// The report of an ensemble; the scenario is the one that its members have in common.
pub fn ensemble(plan: &Plan, members: &Members) -> Value {
    json!({
        "members": members.numbers.len() / (members.state * members.times.len()),
        "columns": state(plan),
        "failed": members.failures.len(),
        "version": env!("CARGO_PKG_VERSION"),
        "scenario": scenario_toml(plan),
    })
}

/// The report of labels: the attractors that they number, by their states.
pub fn basins(plan: &Plan, attractors: &[Attractor], rows: usize) -> Value {
    json!({
        "rows": rows,
        "columns": state(plan),
        "attractors": attractors.iter().map(|a| &a.state).collect::<Vec<_>>(),
    })
}

/// The report of what an analysis gives.
pub fn answer(Answer { table, failure, .. }: &Answer) -> Value {
    let columns: Vec<_> = table.columns.iter().map(|c| column(&c)).collect();
    json!({ "rows": table.len(), "columns": columns, "failure": failure })
}

fn column(column: &Column) -> Value {
    let kind = match column.kind {
        ColumnKind::Time => "time",
        ColumnKind::State => "state",
        ColumnKind::Signal => "signal",
        ColumnKind::Invariant => "invariant",
    };
    json!({ "name": column.name, "unit": column.unit, "kind": kind })
}

fn drift(drift: &Drift) -> Value {
    json!({
        "name": drift.name,
        "unit": drift.unit,
        "start": drift.start,
        "largest": drift.largest,
        "relative": drift.relative(),
    })
}
