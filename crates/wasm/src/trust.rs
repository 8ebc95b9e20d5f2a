//! A scenario's text to how far its run can be trusted.

use crate::kept::Kept;
use crate::{report, run};
use precess::Scenario;
use std::ops::ControlFlow;

/// Holds the run against its shadow. `watch` is told the share of the work that is done and says whether to go on.
pub fn trust(text: &str, within: f64, watch: &mut dyn FnMut(f64) -> bool) -> Result<(Kept, String), String> {
    // The samples must find room here as those of a run must.
    run::fits(&run::plan(text)?)?;
    let mut progress = |share| if watch(share) { ControlFlow::Continue(()) } else { ControlFlow::Break(()) };
    let answer = Scenario::parse(text)
        .and_then(|scenario| precess::trust(&scenario, within, &mut progress))
        .map_err(|e| e.to_string())?;
    let report = report::answer(&answer).to_string();
    Ok((Kept::from(answer.table), report))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kept::Table;
    use serde_json::Value;

    const WILD: &str = "precess = 1\n[system]\nid = \"double_pendulum\"\n[start]\ntheta1 = 2\ntheta2 = 2\n\
                        [run]\nmethod = \"rk4\"\ndt = 0.01\nuntil = 20\nevery = 0.1\n";

    #[test]
    fn a_wild_run_is_trusted_for_a_while_and_no_longer() {
        let (kept, report) = trust(WILD, 1e-3, &mut |_| true).expect("a smooth motion");
        let report: Value = serde_json::from_str(&report).expect("a report is JSON");
        assert_eq!(report["columns"][2]["name"], "trusted");
        let rows: Vec<&[f64]> = kept.table(Table::Numbers).chunks(3).collect();
        assert_eq!(report["rows"], rows.len());
        let trusted = rows.iter().take_while(|row| row[2] == 1.0).count();
        assert!(trusted > 10 && trusted < rows.len(), "{trusted} of {}", rows.len());
        assert!(rows.iter().all(|row| (row[2] == 1.0) == (row[0] <= rows[trusted - 1][0])));
        assert!(rows[trusted - 1][1] <= 1e-3 && rows[trusted][1] > 1e-3);
    }

    #[test]
    fn it_can_be_ended_and_says_what_it_cannot_do() {
        let ended = trust(WILD, 1e-3, &mut |share| share == 0.0).err().expect("nobody waits for the shadow");
        assert!(ended.contains("interrupted"), "{ended}");
        let noria = WILD.replace("double_pendulum", "noria").replace("theta1 = 2\ntheta2 = 2\n", "");
        let refused = trust(&noria, 1e-3, &mut |_| true).err().expect("it jumps");
        assert!(refused.contains("shadow") && refused.contains("noria"), "{refused}");
    }
}
