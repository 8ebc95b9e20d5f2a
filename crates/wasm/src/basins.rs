//! A scenario's text and a tile of a grid to the labels of its starts.

use crate::ensemble::{Side, sides, tile};
use crate::kept::Kept;
use crate::{memory, report, run};
use precess::basins::{BasinsSpec, Care, Court};
use precess::scalar::Isa;
use precess::system::Trajectory;
use precess::{Axis, Scenario, Workers};
use std::cell::RefCell;
use std::ops::ControlFlow;

/// What the host asks for.
pub struct Request<'a> {
    /// The scenario (TOML).
    pub scenario: &'a str,
    /// Names of initial values, one a line.
    pub names: &'a str,
    /// Six numbers for each name, as of an ensemble's tile.
    pub numbers: &'a [f64],
    /// Whether a draft will do: each start followed once, within a loose tolerance.
    pub draft: bool,
    /// Whether one number is computed at a time, not a register of them.
    pub plain: bool,
}

/// What a court depends on: wells and scouts are the same for all tiles of a map.
#[derive(PartialEq)]
struct Case {
    scenario: String,
    spec: BasinsSpec,
}

thread_local! {
    /// The last court, for the next tile of the same map.
    static COURT: RefCell<Option<(Case, Court)>> = const { RefCell::new(None) };
}

/// The labels of a tile's starts: the number of an attractor in the report, or a negative one. `watch` is told how many
/// starts are done and says whether to go on.
pub fn basins(request: &Request, watch: &mut dyn FnMut(f64) -> bool) -> Result<(Kept, String), String> {
    let names: Vec<&str> = request.names.lines().collect();
    let sides = sides(&names, request.numbers)?;
    let axes: Vec<Axis> = sides.iter().map(|side: &Side| side.axis.clone()).collect();
    let starts = axes.iter().map(|axis| axis.points as f64).product::<f64>();
    let state = run::plan(request.scenario)?.start.len() as f64;
    memory::fits(2.0 * starts * state, || {
        format!("{starts} starts do not fit into the memory of this page")
    })?;
    let workers = Workers { isa: if request.plain { Isa::Scalar } else { Isa::best() }, threads: 1 };
    let spec = BasinsSpec { axes, wrap: true, ..BasinsSpec::default() };
    let case = Case { scenario: request.scenario.into(), spec };
    // Taken while it works: whoever watches may call again.
    let known = COURT.take().filter(|(last, _)| *last == case).map(|(_, court)| court);
    let mut going = |done: f64| if watch(done) { ControlFlow::Continue(()) } else { ControlFlow::Break(()) };
    let court = match known {
        Some(court) => court,
        None => Scenario::parse(request.scenario)
            .and_then(|scenario| Court::new(&scenario, &case.spec, workers, &mut |_| going(0.0)))
            .map_err(|e| e.to_string())?,
    };
    let care = if request.draft { Care::Draft } else { Care::Confirmed };
    let starts = tile(court.plan(), &names, &sides, |_| Ok(()))?;
    let members = (starts.len() / court.plan().start.len()) as f64;
    let labels = court.labels(&starts, care, workers, &mut |share| going(share * members));
    let report = report::basins(court.plan(), &court.attractors(), labels.len()).to_string();
    let numbers = labels.into_iter().map(f64::from).collect();
    if !court.interrupted() {
        COURT.set(Some((case, court)));
    }
    Ok((Kept::from(Trajectory { numbers, ..Trajectory::default() }), report))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kept::Table;
    use precess::basins::{UNDECIDED, basins as whole};
    use serde_json::Value;

    const MAGNETS: &str = "precess = 1\n[system]\nid = \"magnetic_pendulum\"\n[start]\ny_dot = 0\n";

    fn labels(numbers: &[f64], watch: &mut dyn FnMut(f64) -> bool) -> (Vec<f64>, Value) {
        let request = Request { scenario: MAGNETS, names: "x\ny", numbers, draft: false, plain: false };
        let (kept, report) = basins(&request, watch).expect("labels");
        (kept.table(Table::Numbers).to_vec(), serde_json::from_str(&report).expect("a report is JSON"))
    }

    #[test]
    fn tiles_have_the_labels_of_the_whole() {
        let scenario = Scenario::parse(MAGNETS).expect("a scenario");
        let axes = ["x", "y"].map(|name| Axis { name: name.into(), low: -2.0, high: 2.0, points: 9 });
        let spec = BasinsSpec { axes: axes.to_vec(), ..BasinsSpec::default() };
        let workers = Workers { isa: Isa::Scalar, threads: 1 };
        let all = whole(&scenario, &spec, workers, &mut |_| ControlFlow::Continue(())).expect("basins");
        for (first, count) in [(0, 5), (1, 4)] {
            let side = [-2.0, 2.0, 9.0, f64::from(first), 2.0, f64::from(count)];
            let (labels, report) = labels(&[side, side].concat(), &mut |_| true);
            let mine = |k: i32| {
                f64::from(
                    all.labels[(first + 2 * (k / count)) as usize * 9 + (first + 2 * (k % count)) as usize],
                )
            };
            assert_eq!(labels, (0..count * count).map(mine).collect::<Vec<_>>());
            let places: Vec<Vec<f64>> = serde_json::from_value(report["attractors"].clone()).expect("states");
            assert_eq!(places, all.attractors.iter().map(|a| a.state.clone()).collect::<Vec<_>>());
            assert_eq!(report["columns"][3]["name"], "y_dot");
        }
    }

    #[test]
    fn who_ends_the_work_has_undecided_starts_and_who_asks_for_nonsense_a_sentence() {
        let side = [-2.0, 2.0, 9.0, 0.0, 1.0, 9.0];
        let (labels, _) = labels(&[side, side].concat(), &mut |_| false);
        assert!(labels.contains(&f64::from(UNDECIDED)));
        let asked = |scenario: &str, names: &str, numbers: &[f64]| {
            let request = Request { scenario, names, numbers, draft: true, plain: true };
            basins(&request, &mut |_| true).err().expect("a refusal")
        };
        assert!(asked(MAGNETS, "x", &[0.0; 7]).contains("7 numbers are no axes of x"));
        assert!(asked(MAGNETS, "nothing", &side).contains("nothing"));
        let huge = [-2.0, 2.0, 4e9, 0.0, 1.0, 1.0];
        assert!(asked(MAGNETS, "x\ny", &[huge, huge].concat()).contains("do not fit"));
        let free = MAGNETS.replace("[start]", "[system.parameters]\nr = 0\n[start]");
        assert!(asked(&free, "x\ny", &[side, side].concat()).contains("friction"));
    }
}
