//! The errors of the sources, each with its number: see `docs/errata.md`.

use precess::value::parse;
use precess::{Outcome, Plan, Scenario, drifts, run};
use std::ops::ControlFlow;

/// Runs a system; a name with a leading `-` is a start, one with `--` a setting of the run.
fn go(system: &str, settings: &[(&str, &str)]) -> Outcome {
    let mut scenario = Scenario::of(system);
    for (name, value) in settings {
        let parsed = || parse(value).expect("a value");
        match name.strip_prefix("--") {
            Some("method") => scenario.method = Some((*value).into()),
            Some(setting) => Scenario::set(&mut scenario.run, setting, parsed()),
            None => match name.strip_prefix('-') {
                Some(start) => Scenario::set(&mut scenario.start, start, parsed()),
                None => Scenario::set(&mut scenario.parameters, name, parsed()),
            },
        }
    }
    let plan = Plan::new(&scenario).expect("a plan");
    run(&plan, &mut |_| ControlFlow::Continue(()))
}

fn drift(outcome: &Outcome, name: &str) -> f64 {
    let drifts = drifts(&outcome.trajectory);
    drifts.iter().find(|d| d.name == name).and_then(precess::Drift::relative).expect("an invariant")
}

fn largest(outcome: &Outcome, name: &str) -> f64 {
    let column = outcome.trajectory.column(name).expect("a column");
    column.into_iter().fold(f64::NEG_INFINITY, |a, b| if b > a { b } else { a })
}

#[test]
fn euler_cromer_loses_the_energy_of_the_cone() {
    let settings = |dt| [("--method", "euler_cromer"), ("--dt", dt), ("--until", "10"), ("--every", "0.01")];
    let fine = go("gyroscope", &settings("1e-4"));
    assert!((0.15..0.25).contains(&drift(&fine, "energy")), "{}", drift(&fine, "energy"));
    let coarse = go("gyroscope", &settings("1e-3"));
    let end = coarse.failure.expect("it diverges").time();
    assert!((1.5..1.7).contains(&end), "{end}");
}

#[test]
fn the_cone_swings_below_the_table() {
    let lowest = largest(&go("gyroscope", &[("--until", "2"), ("--every", "0.001")]), "theta");
    assert!((lowest - 2.7888).abs() < 1e-4, "{lowest}");
}

#[test]
fn improved_euler_gains_energy() {
    let run = go("harmonic_oscillator", &[("--method", "euler_taylor"), ("--dt", "1e-4")]);
    // (1 + dt^2 / 2)^(t / dt), with t = 9 pi.
    let expected = 1e-4 * 9.0 * std::f64::consts::PI / 2.0;
    let gained = drift(&run, "energy");
    assert!((gained / expected - 1.0).abs() < 0.05, "{gained} {expected}");
}

#[test]
fn the_largest_tension() {
    let run = go("pendulum", &[("-theta", "2"), ("--until", "10"), ("--every", "0.001")]);
    let cos = precess::scalar::Scalar::cos(2.0);
    let largest = largest(&run, "tension") / 9.81;
    assert!((largest - (3.0 - 2.0 * cos)).abs() < 1e-4, "{largest}");
    assert!((largest - (3.0 - cos)).abs() > 0.4);
}

#[test]
fn the_two_planets_drift() {
    let run = go("n_body", &[("--until", "1")]);
    let momentum = run.trajectory.column("momentum_y").expect("a column")[0];
    assert!((momentum - 17.82).abs() < 1e-12, "{momentum}");
}

#[test]
fn a_hundredth_throws_the_moon_out() {
    let moon = |start| {
        let settings = [
            ("masses", "[45; 1; 0.01]"),
            ("-y0_dot", "6"),
            ("-y1_dot", "-6/45"),
            ("-x2", start),
            ("-y2_dot", "-6/45 + 2.5"),
            ("--rtol", "1e-13"),
            ("--atol", "1e-13"),
            ("--until", "36"),
            ("--every", "0.1"),
        ];
        let run = go("n_body", &settings);
        let of = |name| run.trajectory.column(name).expect("a column");
        let (x1, y1, x2, y2) = (of("x1"), of("y1"), of("x2"), of("y2"));
        let distance =
            |k: usize| ((x2[k] - x1[k]) * (x2[k] - x1[k]) + (y2[k] - y1[k]) * (y2[k] - y1[k])).sqrt();
        (0..x1.len()).map(distance).collect::<Vec<_>>()
    };
    let (stays, leaves) = (moon("1.20"), moon("1.21"));
    assert!(stays.iter().all(|d| *d < 0.4), "with 1.20 the moon stays");
    assert!(leaves[..200].iter().all(|d| *d < 0.6), "with 1.21 it stays at first");
    assert!(leaves[359] > 5.0, "and leaves: {}", leaves[359]);
}
