//! The golden hashes: every system under every method that fits it, to the last bit.
//!
//! `golden/hashes.txt` holds one line a run: system, method, step (or tolerance), end, time between samples,
//! SHA-256. Every face must reproduce it. `PRECESS_BLESS=1` writes it anew, after a change that is meant.

use precess::integrate::{Kind, Needs};
use precess::value::shortest;
use precess::{Plan, Scenario, Step, catalogue, hash, run, value::Value};
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
