//! Bodies on a table, followed with a method of high order.

use precess::value::parse;
use precess::{Outcome, Plan, Scenario, drifts, run};
use std::ops::ControlFlow;

/// Runs a system by its defaults at a tolerance of 1e-12; a name with a leading `-` is a start, one with `--` a setting.
fn go(system: &str, settings: &[(&str, &str)], watch: Option<&str>) -> Outcome {
    let mut scenario = Scenario::of(system);
    let tolerances = [("--rtol", "1e-12"), ("--atol", "1e-12")];
    for (name, value) in tolerances.iter().chain(settings) {
        let value = parse(value).expect("a value");
        match (name.strip_prefix("--"), name.strip_prefix('-')) {
            (Some(setting), _) => Scenario::set(&mut scenario.run, setting, value),
            (None, Some(start)) => Scenario::set(&mut scenario.start, start, value),
            _ => Scenario::set(&mut scenario.parameters, name, value),
        }
    }
    let when = watch.unwrap_or_default().to_string();
    scenario.events.extend(watch.map(|_| precess::EventSpec { when, ..Default::default() }));
    let plan = Plan::new(&scenario).expect("a plan");
    let outcome = run(&plan, &mut |_| ControlFlow::Continue(()));
    assert_eq!(outcome.failure, None);
    outcome
}

fn drift(outcome: &Outcome, name: &str) -> f64 {
    let drifts = drifts(&outcome.trajectory);
    drifts.iter().find(|d| d.name == name).and_then(precess::Drift::relative).expect("an invariant")
}

fn last(outcome: &Outcome, name: &str) -> f64 {
    *outcome.trajectory.column(name).expect("a column").last().expect("a sample")
}

/// Kane and Levinson's rattleback, without losses: one way it turns back within seconds, the other way much later.
#[test]
fn a_rattleback_reverses_one_way_soon_and_the_other_way_late() {
    let reversal = |spin: &str| {
        let run = go("rattleback", &[("-omega3", spin), ("--until", "12")], Some("spin = 0"));
        assert!(drift(&run, "energy") < 1e-10, "{}", drift(&run, "energy"));
        run.trajectory.events.first().map(|event| event.t).expect("it turns back")
    };
    let (soon, late) = (reversal("5"), reversal("-5"));
    assert!((soon - 2.68).abs() < 0.02 && (late - 11.46).abs() < 0.02, "{soon} {late}");
}

/// The motion backwards in time is the motion of the other spin.
#[test]
fn a_rattleback_goes_back_the_way_it_came() {
    let names = ["qw", "qx", "qy", "qz", "omega1", "omega2", "omega3"];
    let there = go("rattleback", &[("-omega3", "5"), ("--until", "2")], None);
    let turned: Vec<String> = names
        .iter()
        .map(|name| (if name.starts_with('q') { 1.0 } else { -1.0 }) * last(&there, name))
        .map(|x| x.to_string())
        .collect();
    let starts: Vec<String> = names.iter().map(|name| format!("-{name}")).collect();
    let mut settings: Vec<(&str, &str)> =
        starts.iter().map(String::as_str).zip(turned.iter().map(String::as_str)).collect();
    settings.push(("--until", "2"));
    let back = go("rattleback", &settings, None);
    for name in names {
        let start = there.trajectory.column(name).expect("a column")[0];
        let sign = if name.starts_with('q') { 1.0 } else { -1.0 };
        assert!((last(&back, name) - sign * start).abs() < 1e-8, "{name}: {} {start}", last(&back, name));
    }
}

/// The top turns over. How soon depends on epsilon: it comes to rest upside down as slowly as its slip dies.
#[test]
fn a_tippe_top_that_slips_turns_over() {
    let run = go(
        "tippe_top",
        &[("--rtol", "1e-10"), ("--atol", "1e-10"), ("--until", "8")],
        Some("theta = 90 deg"),
    );
    let over = run.trajectory.events.first().map(|event| event.t).expect("it turns over");
    assert!((3.2..4.8).contains(&over) && last(&run, "theta") > 2.8, "{over} {}", last(&run, "theta"));
    assert!(drift(&run, "jellett") < 1e-9, "{}", drift(&run, "jellett"));
    assert!(
        last(&run, "spin_axis") < -70.0,
        "it spins about the same vertical, so the other way about its axis"
    );
}
