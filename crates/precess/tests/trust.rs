//! How far a run can be trusted, against closed forms and converged runs.

use precess::analyses::trust;
use precess::value::{Value, parse};
use precess::{Plan, Scenario, run};
use std::ops::{ControlFlow, Range};

/// Share of the size that is borne.
const WITHIN: f64 = 1e-3;

fn scenario(system: &str, method: &str, settings: &[(&str, &str)]) -> Scenario {
    let mut scenario = Scenario::of(system);
    scenario.method = Some(method.into());
    for (name, value) in settings {
        Scenario::set(&mut scenario.run, name, parse(value).expect("a value"));
    }
    scenario
}

/// The errors, and up to where they are borne.
fn asked(scenario: &Scenario) -> (Vec<f64>, f64) {
    let answer = trust(scenario, WITHIN, &mut |_| ControlFlow::Continue(())).expect("an answer");
    assert_eq!(answer.failure, None);
    let trusted = answer.table.rows().take_while(|row| row[2] == 1.0).last();
    (answer.table.rows().map(|row| row[1]).collect(), trusted.map_or(f64::NAN, |row| row[0]))
}

/// The states of a run, sample by sample.
fn states(scenario: &Scenario) -> Vec<Vec<f64>> {
    let plan = Plan::new(scenario).expect("a plan");
    let numbers = plan.layout.shape().state();
    let outcome = run(&plan, &mut |_| ControlFlow::Continue(()));
    assert_eq!(outcome.failure, None);
    outcome.trajectory.rows().map(|row| row[..=numbers].to_vec()).collect()
}

/// The largest difference, sample by sample, as a share of the largest size so far: over all numbers where they have no
/// units, over angles (at most one) and over rates elsewhere.
fn distance(system: &str, run: &[Vec<f64>], other: &[Vec<f64>]) -> Vec<f64> {
    let groups: &[(Range<usize>, f64)] = match system {
        "pendulum" => &[(1..2, 1.0), (2..3, f64::INFINITY)],
        "double_pendulum" => &[(1..3, 1.0), (3..5, f64::INFINITY)],
        "harmonic_oscillator" => &[(1..2, f64::INFINITY), (2..3, f64::INFINITY)],
        _ => &[(1..4, f64::INFINITY)],
    };
    let mut sizes = vec![0.0_f64; groups.len()];
    let mut distance = |(a, b): (&Vec<f64>, &Vec<f64>)| {
        let mut most = 0.0_f64;
        for ((group, cap), size) in groups.iter().zip(&mut sizes) {
            let numbers = group.clone().flat_map(|i| [a[i], b[i]]);
            *size = numbers.fold(*size, |size, z| larger(size, smaller(z.abs(), *cap)));
            let apart = group.clone().fold(0.0, |most, i| larger(most, (a[i] - b[i]).abs()));
            most = larger(most, if apart == 0.0 { 0.0 } else { apart / *size });
        }
        most
    };
    run.iter().zip(other).map(&mut distance).collect()
}

fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

fn smaller(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

#[test]
fn a_regular_motion_is_trusted_to_the_end() {
    for (system, bound) in
        [("pendulum", 1e-7), ("n_body", 1e-6), ("gyroscope", 1e-6), ("foucault_pendulum", 1e-6)]
    {
        let settings = [("until", "5"), ("every", "0.1")];
        let (errors, horizon) = asked(&scenario(system, "dop853", &settings));
        let most = errors.iter().fold(0.0, |most, e| larger(most, *e));
        println!("{system}: {most:.1e}");
        assert_eq!(horizon, 5.0, "{system}");
        assert!(most > 1e-17 && most < bound, "{system}: {most}");
    }
}

/// The error that is told is the error: the difference from the closed form, which itself has none to speak of.
#[test]
fn the_error_is_that_against_the_closed_form() {
    for system in ["pendulum", "harmonic_oscillator"] {
        let settings = [("until", "20"), ("every", "0.1")];
        let exact = scenario(system, "exact", &settings);
        let (none, _) = asked(&exact);
        assert!(none.iter().all(|e| *e < 1e-12), "{system}: {none:?}");
        let rough = scenario(system, "rk4", &[&settings[..], &[("dt", "0.05")]].concat());
        let (told, _) = asked(&rough);
        let found = distance(system, &states(&rough), &states(&exact));
        for (told, found) in told.iter().zip(&found) {
            assert!((told - found).abs() < 1e-11, "{system}: {told} {found}");
        }
        assert_eq!(told.len(), found.len());
        assert!(told[told.len() - 1] > 1e-8, "{system}: rk4 is no closed form");
    }
}

/// Where chaos has carried a rough run away from a far more accurate one that can be trusted there.
#[test]
fn chaos_parts_two_runs_at_the_horizon() {
    for (system, method, step, until) in [
        ("lorenz", "rk4", ("dt", "0.01"), "25"),
        ("lorenz", "dopri5", ("rtol", "1e-6"), "25"),
        ("double_pendulum", "rk4", ("dt", "0.01"), "60"),
        ("double_pendulum", "dopri5", ("rtol", "1e-6"), "60"),
    ] {
        let settings = [("until", until), ("every", "0.1")];
        let mut rough = scenario(system, method, &[&settings[..], &[step]].concat());
        let mut fine =
            scenario(system, "taylor", &[&settings[..], &[("rtol", "1e-15"), ("atol", "1e-15")]].concat());
        if system == "double_pendulum" {
            for scenario in [&mut rough, &mut fine] {
                Scenario::set(&mut scenario.start, "theta1", Value::number(2.0));
                Scenario::set(&mut scenario.start, "theta2", Value::number(2.5));
            }
        }
        let (_, horizon) = asked(&rough);
        let (_, further) = asked(&fine);
        let (rough, fine) = (states(&rough), states(&fine));
        let apart = distance(system, &rough, &fine);
        let parted = apart.iter().position(|e| *e > WITHIN).expect("chaos");
        println!("{system} by {method}: {horizon}; taylor: {further}");
        assert_eq!(horizon, rough[parted - 1][0], "{system} by {method}");
        assert!(horizon > 1.0 && horizon + 5.0 < further, "{system} by {method}: {horizon} {further}");
    }
}

#[test]
fn a_wish_that_makes_no_sense_is_refused() {
    let pendulum = scenario("pendulum", "rk4", &[]);
    let asked = |s: &Scenario, within| trust(s, within, &mut |_| ControlFlow::Continue(())).map(|_| ());
    for within in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(asked(&pendulum, within).is_err(), "{within}");
    }
    assert!(asked(&Scenario::of("noria"), WITHIN).is_err());
}
