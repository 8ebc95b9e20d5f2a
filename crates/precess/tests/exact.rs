//! The closed forms against the integration of the same equations, over whole runs, and what has none.

use precess::scalar::Scalar;
use precess::value::parse;
use precess::{Outcome, Plan, Scenario, catalogue, run};
use std::f64::consts::PI;
use std::ops::ControlFlow;

/// A name with a leading `-` is a start, one with `--` a setting of the run.
fn scenario(system: &str, settings: &[(&str, &str)]) -> Scenario {
    let mut scenario = Scenario::of(system);
    for (name, value) in settings {
        let value = parse(value).expect("a value");
        match name.strip_prefix("--") {
            Some(setting) => Scenario::set(&mut scenario.run, setting, value),
            None => match name.strip_prefix('-') {
                Some(start) => Scenario::set(&mut scenario.start, start, value),
                None => Scenario::set(&mut scenario.parameters, name, value),
            },
        }
    }
    scenario
}

fn go(scenario: &Scenario) -> Outcome {
    let outcome = run(&Plan::new(scenario).expect("a plan"), &mut |_| ControlFlow::Continue(()));
    assert_eq!(outcome.failure, None);
    outcome
}

/// The largest distance between the closed form and dop853, each number relative to its largest size.
fn distance(system: &str, settings: &[(&str, &str)]) -> f64 {
    let methods = ["exact".to_string()];
    let mut go_on = |_: &str, _| ControlFlow::Continue(());
    let comparison = precess::compare(&scenario(system, settings), &methods, &mut go_on).expect("plans");
    assert_eq!(comparison.contenders[0].outcome.failure, None);
    comparison.contenders[0].error
}

#[test]
fn every_closed_form_agrees_with_the_integration_of_its_equations() {
    let mut count = 0;
    for system in catalogue::systems() {
        let id = system.card().id;
        let mut exact = scenario(id, &[]);
        exact.method = Some("exact".into());
        if Plan::new(&exact).is_err() {
            continue;
        }
        count += 1;
        let distance = distance(id, &[]);
        println!("{id}: {distance:.1e}");
        assert!(distance < 1e-11, "{id}: {distance:e}");
    }
    assert!(count >= 8, "{count} closed forms");
}

#[test]
fn the_special_cases_too() {
    let cases: &[(&str, &[(&str, &str)])] = &[
        // Linear: over, exactly and nearly critically damped; fed instead of damped; at the resonance and beside it.
        ("driven_oscillator", &[("p", "2.2"), ("amplitude", "0")]),
        ("driven_oscillator", &[("p", "2"), ("frequency", "0.3")]),
        ("driven_oscillator", &[("p", "2.000001"), ("frequency", "0.3")]),
        ("driven_oscillator", &[("p", "-0.1"), ("frequency", "2"), ("--until", "20")]),
        ("driven_oscillator", &[("p", "0"), ("frequency", "1")]),
        ("driven_oscillator", &[("p", "0"), ("frequency", "1.0001")]),
        ("driven_oscillator", &[("p", "1e-9"), ("frequency", "1")]),
        ("driven_oscillator", &[("p", "0"), ("q", "0"), ("frequency", "0.001"), ("--until", "30")]),
        ("driven_oscillator", &[("p", "0.2"), ("q", "-1"), ("frequency", "0"), ("--until", "5")]),
        ("driven_oscillator", &[("p", "100"), ("frequency", "1"), ("--until", "3")]),
        ("car_suspension", &[("speed", "0.159")]),
        ("potential_well", &[("u", "[3; 0.2; 0.5]"), ("b", "0.3")]),
        ("potential_well", &[("u", "[0; 1]")]),
        ("potential_well", &[("u", "[0; 0.1; -0.5]"), ("--until", "4")]),
        ("spring", &[("b", "0.4"), ("g", "9.81"), ("m", "0.3")]),
        // The pendulum: P's large swing, turning over, nearly at the separatrix on either side, in the next well, gravity
        // upwards, none.
        // (Each passage of the top costs an integration two digits: one is seen here.)
        ("pendulum", &[("-theta", "49*pi/50"), ("--until", "4")]),
        ("pendulum", &[("-theta_dot", "8")]),
        ("pendulum", &[("-theta_dot", "-30")]),
        ("pendulum", &[("-theta", "0"), ("-theta_dot", "2*sqrt(9.81) + 1e-6"), ("--until", "3")]),
        ("pendulum", &[("-theta", "0"), ("-theta_dot", "2*sqrt(9.81) - 1e-6"), ("--until", "3")]),
        ("pendulum", &[("-theta", "7.5"), ("-theta_dot", "1")]),
        ("pendulum", &[("g", "-9.81"), ("-theta", "2.5")]),
        ("pendulum", &[("g", "0"), ("-theta_dot", "2")]),
        // Two bodies: P's second start, long ellipses, a parabola, a hyperbola, in space, many turns.
        ("n_body", &[("-y0_dot", "-0.08"), ("-y1_dot", "0.8"), ("--until", "8")]),
        (
            "n_body",
            &[
                ("masses", "[1; 0]"),
                ("-x0", "0"),
                ("-y0_dot", "0"),
                ("-y1_dot", "sqrt(2)"),
                ("--until", "50"),
            ],
        ),
        (
            "n_body",
            &[("masses", "[1; 0]"), ("-x0", "0"), ("-y0_dot", "0"), ("-y1_dot", "1.7"), ("--until", "50")],
        ),
        (
            "n_body",
            &[
                ("masses", "[1; 1]"),
                ("-x1_dot", "-3"),
                ("-y0_dot", "0"),
                ("-y1_dot", "0.5"),
                ("--until", "5"),
            ],
        ),
        ("n_body", &[("-z1", "0.4"), ("-z0_dot", "0.3"), ("--until", "5")]),
        ("n_body", &[("k", "0"), ("--until", "5")]),
    ];
    let mut off = vec![];
    for (system, settings) in cases {
        for until in [1.0, -1.0] {
            let mut all = settings.to_vec();
            let back =
                settings.iter().find(|s| s.0 == "--until").map_or("-10".into(), |s| format!("-{}", s.1));
            if until < 0.0 {
                // What grows backwards in time outgrows every bound.
                if settings.iter().any(|s| s.0 == "p" || s.0 == "b") {
                    continue;
                }
                all.retain(|s| s.0 != "--until");
                all.push(("--until", &back));
            }
            let distance = distance(system, &all);
            println!("{system} {all:?}: {distance:.1e}");
            if distance.is_nan() || distance > 1e-11 {
                off.push(format!("{system} {all:?}: {distance:e}"));
            }
        }
    }
    assert!(off.is_empty(), "{off:#?}");
}

/// From 49 pi / 50 the period is 4 K(sin(49 pi / 100)) / omega, with K by the arithmetic-geometric mean of the test's own.
#[test]
fn the_pendulum_has_its_period_for_ever() {
    let (mut a, mut b) = (1.0_f64, Scalar::cos(49.0 * PI / 100.0));
    for _ in 0..8 {
        (a, b) = ((a + b) / 2.0, (a * b).sqrt());
    }
    let period = 2.0 * PI / a / 9.81_f64.sqrt();
    let start = 49.0 * PI / 50.0;
    for periods in [1.0, 1000.0] {
        let mut scenario = scenario("pendulum", &[("-theta", "49*pi/50")]);
        scenario.method = Some("exact".into());
        Scenario::set(&mut scenario.run, "until", precess::value::Value::number(periods * period));
        let outcome = go(&scenario);
        let last = outcome.trajectory.rows().last().expect("rows").to_vec();
        assert!((last[1] - start).abs() < 1e-13 * periods && last[2].abs() < 1e-12 * periods, "{last:?}");
    }
}

/// P's two planets: a = 1 / (2/r - v^2 / mu), the period 2 pi sqrt(a^3 / mu).
#[test]
fn two_bodies_come_back_after_kepler_s_period() {
    let (mu, v) = (11.0, 1.8 + 0.18);
    let a = 1.0_f64 / (2.0 / 2.0 - v * v / mu);
    let period = 2.0 * PI * (a * a * a / mu).sqrt();
    for (method, bound) in [("exact", 1e-13), ("dop853", 1e-11)] {
        let mut scenario = scenario("n_body", &[("-y0_dot", "0.18"), ("-y1_dot", "-1.8")]);
        scenario.method = Some(method.into());
        Scenario::set(&mut scenario.run, "until", precess::value::Value::number(period));
        if method == "dop853" {
            Scenario::set(&mut scenario.run, "rtol", precess::value::Value::number(1e-14));
            Scenario::set(&mut scenario.run, "atol", precess::value::Value::number(1e-14));
        }
        let outcome = go(&scenario);
        let (first, last) = (outcome.trajectory.row(0), outcome.trajectory.rows().last().expect("rows"));
        for k in 1..9 {
            assert!((first[k] - last[k]).abs() < bound, "{method}: {} {}", first[k], last[k]);
        }
    }
}

#[test]
fn what_has_no_closed_form_is_refused_in_a_sentence() {
    let refusal = |system: &str, settings: &[(&str, &str)]| {
        let mut scenario = scenario(system, settings);
        scenario.method = Some("exact".into());
        Plan::new(&scenario).err().expect("a refusal").to_string()
    };
    for (system, settings, words) in [
        ("pendulum", [("b", "0.1")].as_slice(), "friction"),
        ("double_pendulum", &[], "no closed form"),
        ("potential_well", &[], "second degree"),
        ("n_body", &[("softening", "0.1")], "softening"),
        ("n_body", &[("masses", "[1; 1; 1]"), ("-x2", "3")], "two bodies"),
        ("n_body", &[("-y0_dot", "0"), ("-y1_dot", "0")], "fall straight"),
        ("noria", &[], "events"),
    ] {
        let sentence = refusal(system, settings);
        assert!(sentence.contains(words) && sentence.contains("exact"), "{system}: {sentence}");
    }
}
