//! A scenario's text to a result.

use crate::kept::Kept;
use crate::{memory, report};
use precess::integrate::Failure;
use precess::{Plan, Scenario};
use std::ops::ControlFlow;

/// A longer text is no scenario. The library takes more, but a file made for it, of nothing but nested tables, needs
/// six hundred times its length to be understood, and 32 bits do not address that.
const LONGEST: usize = 1 << 20;

/// Runs a scenario. `watch` is told the time now and then and says whether to go on.
pub fn run(text: &str, watch: &mut dyn FnMut(f64) -> bool) -> Result<(Kept, String), String> {
    let plan = plan(text)?;
    fits(&plan)?;
    let mut full = false;
    let outcome = precess::run(&plan, &mut |t| {
        full = memory::used() > memory::MOST;
        if full || !watch(t) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    let failure = outcome.failure.as_ref().map(|failure| match failure {
        Failure::Interrupted { t } if full => {
            format!("at t = {t:?} s the results fill the memory: end the run earlier, or watch fewer events")
        }
        other => other.to_string(),
    });
    let drifts = precess::drifts(&outcome.trajectory);
    let kept = Kept::from(outcome.trajectory);
    let Kept::Run { trajectory, names, .. } = &kept else { unreachable!("a trajectory is a run") };
    let stopped_by = outcome.stopped_by.as_deref();
    let report =
        report::run(trajectory, names, &plan, &outcome.provenance, &drifts, stopped_by, failure.as_deref());
    Ok((kept, report.to_string()))
}

/// Understands a scenario.
pub fn plan(text: &str) -> Result<Plan, String> {
    if text.len() > LONGEST {
        return Err("the text is longer than 1 MiB: that is no scenario".into());
    }
    Scenario::parse(text).and_then(|s| Plan::new(&s)).map_err(|e| e.to_string())
}

/// Whether the samples find room. A table that grows may take twice what it holds.
pub fn fits(plan: &Plan) -> Result<(), String> {
    let rows = plan.until.abs() / plan.every + 2.0;
    memory::fits(rows * plan.width() as f64 * 2.0, || {
        format!("{rows:.1e} samples do not fit into the memory of this page: make 'every' longer")
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kept::Table;
    use serde_json::Value;

    const PENDULUM: &str =
        "precess = 1\n[system]\nid = \"pendulum\"\n[run]\nmethod = \"rk4\"\nuntil = 10\nevery = 1\n";

    fn done(text: &str) -> (Kept, Value) {
        let (kept, report) = run(text, &mut |_| true).unwrap_or_else(|sentence| panic!("{sentence}"));
        (kept, serde_json::from_str(&report).expect("a report is JSON"))
    }

    #[test]
    fn a_run_gives_the_table_of_the_library() {
        let (kept, report) = done(PENDULUM);
        let plan = Scenario::parse(PENDULUM).and_then(|s| Plan::new(&s)).expect("a scenario");
        let expected = precess::run(&plan, &mut |_| ControlFlow::Continue(()));
        assert_eq!(kept.table(Table::Numbers), expected.trajectory.numbers);
        assert_eq!(kept.hash(0), Some(precess::hash(&expected.trajectory)));
        assert_eq!(kept.hash(1), None);
        assert_eq!(report["rows"], 11);
        assert_eq!(report["failure"], Value::Null);
        assert_eq!(report["scenario"], precess::scenario_toml(&plan));
    }

    #[test]
    fn events_are_rows_of_numbers() {
        let watched = format!("{PENDULUM}[[event]]\nname = \"down\"\nwhen = \"theta = 0\"\n");
        let (kept, report) = done(&watched);
        assert_eq!(report["events"], serde_json::json!(["down"]));
        let rows: Vec<&[f64]> = kept.table(Table::Events).chunks(4).collect();
        assert!(rows.len() > 5);
        assert!(rows.iter().all(|row| row[0] == 0.0 && row[2].abs() < 1e-12), "{rows:?}");
        assert!(rows.is_sorted_by(|a, b| a[1] < b[1]));
    }

    #[test]
    fn whoever_watches_can_end_a_run_and_keeps_its_samples() {
        let (_, report) = run(PENDULUM, &mut |t| t < 5.0).expect("a run that is ended is a run");
        assert!(report.contains("interrupted at t = "), "{report}");
        let report: Value = serde_json::from_str(&report).expect("a report is JSON");
        assert!((5..11).contains(&report["rows"].as_u64().expect("a count")));
    }

    #[test]
    fn what_does_not_fit_is_refused() {
        let long = PENDULUM.replace("every = 1\n", "every = 1e-7\n");
        let refusal = run(&long, &mut |_| true).err().expect("too long");
        assert!(refusal.contains("every"), "{refusal}");
    }
}
