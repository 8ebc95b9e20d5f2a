//! The golden hashes: every system under every method that fits it, to the last bit.
//!
//! `golden/hashes.txt` holds one line a run: system, method, step (or tolerance), end, time between samples,
//! SHA-256. Every face must reproduce it. `PRECESS_BLESS=1` writes it anew, after a change that is meant.

use precess::integrate::{Kind, Needs};
use precess::scalar::Isa;
use precess::value::shortest;
use precess::{Keep, Plan, Scenario, Step, Workers, catalogue, ensemble, hash, run, value::Value};
use std::fmt::Write;
use std::path::PathBuf;

/// Steps of a fixed-step run; an adaptive one covers the same time.
const STEPS: f64 = 1e4;

fn file() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../golden/hashes.txt")
}

fn plans() -> Vec<Plan> {
    let mut plans = vec![];
    for system in catalogue::systems() {
        let card = system.card();
        for method in catalogue::methods().iter().map(|m| m.card()) {
            let until = STEPS * card.defaults.dt;
            let mut scenario = Scenario::of(card.id);
            scenario.method = Some(method.id.into());
            scenario.run =
                vec![("until".into(), Value::number(until)), ("every".into(), Value::number(until / 10.0))];
            match Plan::new(&scenario) {
                Ok(plan) => plans.push(plan),
                // The only reason to leave a pair out is that the method says it does not fit.
                Err(refusal) => assert_eq!(method.needs, Needs::Separable, "{}: {refusal}", card.id),
            }
        }
    }
    plans
}

fn line(plan: &Plan) -> String {
    let id = plan.card.id;
    let method = plan.method.card();
    let outcome = run(plan, &mut |_| std::ops::ControlFlow::Continue(()));
    assert!(outcome.failure.is_none(), "{id} by {}: {:?}", method.id, outcome.failure);
    let last = outcome.trajectory.rows().last().expect("a run records its start");
    assert!(last.iter().all(|x| x.is_finite()), "{id} by {} ends at {last:?}", method.id);
    assert_eq!(last[0], plan.until, "{id} by {} is sampled at its end", method.id);
    if method.kind == Kind::Fixed {
        // Each of the system's own events cuts a step, and the next one begins there.
        let (steps, events) = (outcome.provenance.steps as f64, outcome.trajectory.events.len() as f64);
        assert!((STEPS..=STEPS + events + 10.0).contains(&steps), "{id} by {}: {steps} steps", method.id);
    }
    let step = match plan.step {
        Step::Fixed(dt) => shortest(dt),
        Step::Adaptive { rtol, .. } => shortest(rtol),
    };
    let (until, every) = (shortest(plan.until), shortest(plan.every));
    format!("{id} {} {step} {until} {every} {}", method.id, hash(&outcome.trajectory))
}

/// The golden start among others, in lanes: every width of this machine, by one thread and by two.
fn in_lanes(plan: &Plan, golden: &str) -> Result<(), String> {
    // Neighbours that differ a little, before and after: more than a block holds of the narrower lanes.
    const MEMBERS: usize = 19;
    const PLACE: usize = 7;
    let mut starts = vec![];
    for member in 0..MEMBERS {
        let neighbour = |x: &f64| if member == PLACE { *x } else { x * (1.0 + 1e-3 * (member as f64 - 9.5)) };
        starts.extend(plan.start.iter().map(neighbour));
    }
    for isa in Isa::available() {
        for threads in [1, 2] {
            let workers = Workers { isa, threads };
            let mut go_on = |_| std::ops::ControlFlow::Continue(());
            let members = ensemble(plan, &starts, Keep::Samples, workers, &mut go_on).expect("no watches");
            let hash = members.hash(PLACE);
            if hash != golden {
                let (id, method, isa) = (plan.card.id, plan.method.card().id, isa.name());
                return Err(format!(
                    "{id} by {method} in {isa} lanes, {threads} threads: {hash}, not {golden}"
                ));
            }
        }
    }
    Ok(())
}

#[test]
fn every_system_under_every_method_gives_the_golden_bits_in_lanes() {
    let golden = std::fs::read_to_string(file()).expect("golden/hashes.txt is there");
    for plan in &plans() {
        let start = format!("{} {} ", plan.card.id, plan.method.card().id);
        let line = golden.lines().find(|line| line.starts_with(&start)).expect("a golden line");
        let hash = line.split(' ').next_back().expect("a hash");
        in_lanes(plan, hash).unwrap();
    }
}

#[test]
fn every_system_under_every_method_gives_the_golden_bits() {
    let mut now = String::from("# system method step-or-tolerance until every sha256\n");
    for plan in plans() {
        let _ = writeln!(now, "{}", line(&plan));
    }
    if std::env::var_os("PRECESS_BLESS").is_some() {
        std::fs::write(file(), now).expect("golden/hashes.txt can be written");
        return;
    }
    let golden = std::fs::read_to_string(file()).expect("golden/hashes.txt is there");
    let differ: Vec<_> = now.lines().filter(|line| !golden.lines().any(|g| g == *line)).collect();
    assert!(differ.is_empty(), "not the golden bits:\n{}", differ.join("\n"));
    assert_eq!(now.lines().count(), golden.lines().count(), "golden/hashes.txt has lines that nothing gives");
}
