//! The golden hashes: every system, and every method, to the last bit.
//!
//! Every system runs under its own method, `rk4`, `dop853` and, where it has a closed form, `exact`; every method that fits runs under the few systems of
//! [`EXERCISERS`]. All pairs would take for ever, and a system does not know by which method it is called.
//!
//! `golden/hashes.txt` holds one line a run: system, method, step (or tolerance), end, time between samples,
//! SHA-256. Every face must reproduce it. `golden/short.txt` holds the same with a tenth of the steps, for machines
//! that are emulated; `PRECESS_GOLDEN=short` checks nothing but it. `PRECESS_BLESS=1` writes both anew, after a change
//! that is meant.

use precess::integrate::{Kind, Needs};
use precess::scalar::Isa;
use precess::value::shortest;
use precess::{Keep, Plan, Scenario, Step, Workers, catalogue, ensemble, hash, run, value::Value};
use std::fmt::Write;
use std::path::PathBuf;

/// The systems that run under every method: separable, with friction and lists, not separable, of several bodies, with
/// events.
const EXERCISERS: [&str; 5] = ["pendulum", "magnetic_pendulum", "gyroscope", "n_body", "noria"];
/// The methods under which every system runs, besides its own.
const EVERYWHERE: [&str; 3] = ["rk4", "dop853", "exact"];

/// A file of hashes, and the steps of its fixed-step runs; an adaptive one covers the same time.
#[derive(Clone, Copy)]
struct Golden {
    file: &'static str,
    steps: f64,
}

/// The files to be checked.
fn files() -> Vec<Golden> {
    let all = [Golden { file: "hashes.txt", steps: 1e4 }, Golden { file: "short.txt", steps: 1e3 }];
    let short = std::env::var("PRECESS_GOLDEN").is_ok_and(|which| which == "short");
    all.into_iter().filter(|golden| !short || golden.file == "short.txt").collect()
}

impl Golden {
    fn path(self) -> PathBuf {
        PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../golden").join(self.file)
    }
    fn read(self) -> String {
        std::fs::read_to_string(self.path()).expect("the file is there")
    }
}

fn plans(steps: f64) -> Vec<Plan> {
    let mut plans = vec![];
    for system in catalogue::systems() {
        let card = system.card();
        let all = EXERCISERS.contains(&card.id);
        let wanted = |id: &str| all || id == card.defaults.method || EVERYWHERE.contains(&id);
        for method in catalogue::methods().iter().map(|m| m.card()).filter(|m| wanted(m.id)) {
            let until = steps * card.defaults.dt;
            let mut scenario = Scenario::of(card.id);
            scenario.method = Some(method.id.into());
            scenario.run =
                vec![("until".into(), Value::number(until)), ("every".into(), Value::number(until / 10.0))];
            match Plan::new(&scenario) {
                Ok(plan) => plans.push(plan),
                // The only reason to leave a pair out is that the method says it does not fit.
                Err(refusal) => assert_ne!(method.needs, Needs::Any, "{}: {refusal}", card.id),
            }
        }
    }
    plans
}

fn line(plan: &Plan, least: f64) -> String {
    let id = plan.card.id;
    let method = plan.method.card();
    let outcome = run(plan, &mut |_| std::ops::ControlFlow::Continue(()));
    assert!(outcome.failure.is_none(), "{id} by {}: {:?}", method.id, outcome.failure);
    let last = outcome.trajectory.rows().last().expect("a run records its start");
    assert!(last.iter().all(|x| x.is_finite()), "{id} by {} ends at {last:?}", method.id);
    assert_eq!(last[0], plan.until, "{id} by {} is sampled at its end", method.id);
    if method.kind == Kind::Fixed && method.needs != Needs::ClosedForm {
        // Each of the system's own events cuts a step, and the next one begins there.
        let (steps, events) = (outcome.provenance.steps as f64, outcome.trajectory.events.len() as f64);
        assert!((least..=least + events + 10.0).contains(&steps), "{id} by {}: {steps} steps", method.id);
    }
    let step = match plan.step {
        Step::Fixed(dt) => shortest(dt),
        Step::Adaptive { rtol, .. } => shortest(rtol),
    };
    let (until, every) = (shortest(plan.until), shortest(plan.every));
    format!("{id} {} {step} {until} {every} {}", method.id, hash(&outcome.trajectory))
}

/// The golden start among others, in lanes: every width of this machine, and two threads.
fn in_lanes(plan: &Plan, golden: &str) -> Result<(), String> {
    const PLACE: usize = 7;
    let widest = Isa::best();
    let each = Isa::available().into_iter().map(|isa| Workers { isa, threads: 1 });
    // That threads change nothing does not depend on the lanes: once is enough.
    for workers in each.chain([Workers { isa: widest, threads: 2 }]) {
        // Neighbours that differ a little, before and after, and a few more than there are lanes.
        let members = if workers.isa.lanes() < 6 { PLACE + 2 } else { workers.isa.lanes() + 3 };
        let mut starts = vec![];
        for member in 0..members {
            let neighbour =
                |x: &f64| if member == PLACE { *x } else { x * (1.0 + 1e-3 * (member as f64 - 9.5)) };
            starts.extend(plan.start.iter().map(neighbour));
        }
        let mut go_on = |_| std::ops::ControlFlow::Continue(());
        let members = ensemble(plan, &starts, Keep::Samples, workers, &mut go_on).expect("no watches");
        let hash = members.hash(PLACE);
        if hash != golden {
            let (id, method) = (plan.card.id, plan.method.card().id);
            return Err(format!("{id} by {method} with {workers:?}: {hash}, not {golden}"));
        }
    }
    Ok(())
}

#[test]
fn every_system_and_every_method_gives_the_golden_bits_in_lanes() {
    for golden in files() {
        let lines = golden.read();
        // Among 19 neighbours, several times over: the long runs by the quickest method alone.
        let is_short = golden.file == "short.txt";
        for plan in plans(golden.steps).iter().filter(|plan| is_short || plan.method.card().id == "rk4") {
            let start = format!("{} {} ", plan.card.id, plan.method.card().id);
            let line = lines.lines().find(|line| line.starts_with(&start)).expect("a golden line");
            let hash = line.split(' ').next_back().expect("a hash");
            in_lanes(plan, hash).unwrap();
        }
    }
}

#[test]
fn every_system_and_every_method_gives_the_golden_bits() {
    for golden in files() {
        let mut now = String::from("# system method step-or-tolerance until every sha256\n");
        for plan in plans(golden.steps) {
            let _ = writeln!(now, "{}", line(&plan, golden.steps));
        }
        if std::env::var_os("PRECESS_BLESS").is_some() {
            std::fs::write(golden.path(), now).expect("the file can be written");
            continue;
        }
        let file = golden.read();
        let differ: Vec<_> = now.lines().filter(|line| !file.lines().any(|g| g == *line)).collect();
        assert!(differ.is_empty(), "not the golden bits:\n{}", differ.join("\n"));
        assert_eq!(now.lines().count(), file.lines().count(), "{} has lines that nothing gives", golden.file);
    }
}
