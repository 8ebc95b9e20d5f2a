//! What is said of a run beside its numbers, as JSON.

use crate::kept::Kept;
use precess::system::{Column, ColumnKind};
use precess::{Drift, Provenance};
use serde_json::{Value, json};

/// The report of a run. A number that is not finite is null, as JSON has it.
pub fn report(
    kept: &Kept,
    provenance: &Provenance,
    drifts: &[Drift],
    stopped_by: Option<&str>,
    failure: Option<&str>,
) -> Value {
    json!({
        "rows": kept.trajectory.len(),
        "columns": kept.trajectory.columns.iter().map(column).collect::<Vec<_>>(),
        "events": kept.names,
        "drifts": drifts.iter().map(drift).collect::<Vec<_>>(),
        "stopped_by": stopped_by,
        "failure": failure,
        "version": provenance.version,
        "scenario": provenance.scenario,
        "scenario_hash": provenance.scenario_hash,
        "steps": provenance.steps,
        "rejections": provenance.rejections,
        "evaluations": provenance.evaluations,
    })
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
