//! Systems that change their mind on the way: the string of a pendulum, dry friction, bodies that collide; and the
//! asteroids of a cluster, by parts and as a whole.

use precess::integrate::Failure;
use precess::scalar::Scalar;
use precess::value::{Value, parse};
use precess::{Outcome, Plan, Scenario, drifts, hash, run};
use std::f64::consts::PI;
use std::ops::ControlFlow;

/// A name with a leading `-` is a start, one with `--` a setting of the run.
fn scenario(system: &str, settings: &[(&str, &str)]) -> Scenario {
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
    scenario
}

fn of(scenario: &Scenario) -> Outcome {
    run(&Plan::new(scenario).expect("a plan"), &mut |_| ControlFlow::Continue(()))
}

fn go(system: &str, settings: &[(&str, &str)]) -> Outcome {
    of(&scenario(system, settings))
}

fn names(outcome: &Outcome) -> Vec<&str> {
    outcome.trajectory.events.iter().map(|e| e.name.as_str()).collect()
}

fn drift(outcome: &Outcome, name: &str) -> f64 {
    let drifts = drifts(&outcome.trajectory);
    drifts.iter().find(|d| d.name == name).and_then(precess::Drift::relative).expect("an invariant")
}

/// Released with just the energy of the top, the string goes slack at cos theta = -2/3: 131.81 degrees (P, 9.1).
#[test]
fn the_string_goes_slack_at_131_81_degrees() {
    let swing = go(
        "pendulum",
        &[("string", "true"), ("-theta", "0"), ("-theta_dot", "6.26418390534633"), ("--until", "2")],
    );
    let slack = &swing.trajectory.events[0];
    assert_eq!(slack.name, "slackens");
    let degrees = slack.state[0] * 180.0 / PI;
    assert!((degrees - 131.810_314_895_778_6).abs() < 1e-7, "{degrees}");
}

/// It flies on a parabola, is caught where that meets the circle again, and what the jerk takes is accounted for.
#[test]
fn the_mass_flies_and_is_caught_and_no_energy_is_unaccounted_for() {
    let swing = go(
        "pendulum",
        &[
            ("string", "true"),
            ("-theta", "0"),
            ("-theta_dot", "6.26418390534633"),
            ("--until", "6"),
            ("--every", "0.001"),
        ],
    );
    assert_eq!(swing.failure, None);
    assert!(names(&swing).starts_with(&["slackens", "caught"]), "{:?}", names(&swing));
    let [slack, caught] = &swing.trajectory.events[..2] else { panic!("two events") };
    // The parabola, by itself: from the point of the circle with the speed there.
    let (theta, w) = (slack.state[0], slack.state[2]);
    let (sin, cos) = Scalar::sin_cos(theta);
    let time = caught.t - slack.t;
    let (x, y) = (sin + w * cos * time, -cos + w * sin * time - 0.5 * 9.81 * time * time);
    assert!((x * x + y * y - 1.0).abs() < 1e-8, "it is back on the circle");
    let (sin, cos) = Scalar::sin_cos(caught.state[0]);
    assert!((x - sin).abs() + (y + cos).abs() < 1e-8, "at the place of the parabola");
    let column = |name: &str| swing.trajectory.column(name).expect("a column");
    let lost = column("lost");
    let jerk = 0.5 * caught.state[3] * caught.state[3];
    let after = column("t").iter().position(|t| *t > caught.t).expect("a sample");
    assert!((lost[after] - jerk).abs() < 1e-12 && jerk > 1.0, "{} {jerk}", lost[after]);
    assert!(drift(&swing, "account") < 1e-9, "{}", drift(&swing, "account"));
    let r = column("r");
    assert!(r.iter().all(|r| *r < 1.0 + 1e-9), "the string is no longer than it is");
}

/// The two thresholds of P's exercise 11, found by halving an interval of runs: 2 omega to turn over, sqrt(5) omega to do
/// so on a string.
#[test]
fn the_thresholds_of_turning_over() {
    let threshold = |turns: &dyn Fn(f64) -> bool| {
        let (mut low, mut high) = (3.0, 10.0);
        while high - low > 1e-9 {
            let middle = f64::midpoint(low, high);
            if turns(middle) { high = middle } else { low = middle }
        }
        high
    };
    let omega = 9.81_f64.sqrt();
    let started = |string: &str, speed: f64, until: f64| {
        let mut start = scenario(
            "pendulum",
            &[("string", string), ("-theta", "0"), ("--rtol", "1e-12"), ("--atol", "1e-12")],
        );
        Scenario::set(&mut start.start, "theta_dot", Value::number(speed));
        Scenario::set(&mut start.run, "until", Value::number(until));
        Scenario::set(&mut start.run, "every", Value::number(until / 100.0));
        of(&start)
    };
    let rod = threshold(&|speed| {
        let theta = started("false", speed, 8.0).trajectory.column("theta").expect("a column");
        theta.iter().any(|theta| *theta > PI)
    });
    assert!((rod / omega - 2.0).abs() < 1e-9, "{}", rod / omega);
    // The tension at the top, where a rod that turns over pulls least.
    let at_the_top = |speed: f64| {
        let mut start = scenario(
            "pendulum",
            &[("-theta", "0"), ("--rtol", "1e-13"), ("--atol", "1e-13"), ("--until", "2")],
        );
        Scenario::set(&mut start.start, "theta_dot", Value::number(speed));
        let top = precess::EventSpec { when: "theta = pi".into(), stop: true, ..Default::default() };
        start.events = vec![top];
        *of(&start).trajectory.column("tension").expect("a column").last().expect("a sample")
    };
    let taut = threshold(&|speed| speed > 2.0 * omega + 1e-3 && at_the_top(speed) > 0.0);
    assert!((taut / omega - 5.0_f64.sqrt()).abs() < 1e-9, "{}", taut / omega);
    // The string itself: a dip of the tension below zero between two of the places where a step is looked at goes unseen,
    // so that it holds a little earlier.
    let string = threshold(&|speed| started("true", speed, 2.0).trajectory.events.is_empty());
    assert!((string / taut - 1.0).abs() < 1e-6, "{}", string / omega);
}

/// Between two stops gravity and friction are smooth: each swing ends where the energy says, and the last one sticks.
#[test]
fn dry_friction_ends_the_motion() {
    let swing = go("pendulum", &[("dry", "1"), ("-theta", "1"), ("--until", "10")]);
    assert_eq!(swing.failure, None);
    let stops: Vec<f64> = swing.trajectory.events.iter().map(|e| e.state[0]).collect();
    assert!(stops.len() > 2);
    let mut from = 1.0;
    for stop in stops {
        // cos(stop) = cos(from) + dry / (g / l) |stop - from|
        let work = 9.81 * (Scalar::cos(stop) - Scalar::cos(from)) - (stop - from).abs();
        assert!(work.abs() < 1e-8, "{work}");
        from = stop;
    }
    let last = swing.trajectory.rows().last().expect("rows").to_vec();
    assert_eq!([last[1], last[2]], [from, 0.0]);
    assert!(9.81 * Scalar::sin(from.abs()) <= 1.0, "it sticks where gravity is weaker");
}

#[test]
fn bodies_that_collide_end_the_run_with_the_pair_and_the_time() {
    let fall = go("n_body", &[("-y0_dot", "0"), ("-y1_dot", "0"), ("--until", "10")]);
    let sentence = fall.failure.expect("they meet").to_string();
    assert!(sentence.contains("bodies 0 and 1 collide"), "{sentence}");
    // From rest at a distance d, after pi / 2 sqrt(d^3 / (2 mu)).
    let time = fall.trajectory.rows().last().expect("rows")[0];
    let expected = PI / 2.0 * (8.0_f64 / 22.0).sqrt();
    assert!((time - expected).abs() < 0.02, "{time} {expected}");
    assert!(sentence.contains(&format!("t = {expected:.4}")[..8]), "{sentence}");
}

/// The elements of an orbit are those that its start was made of, and stay.
#[test]
fn two_bodies_keep_their_osculating_elements() {
    let orbit = go(
        "n_body",
        &[("masses", "[3; 1]"), ("-x0", "0"), ("-y0_dot", "0"), ("-y1_dot", "1.6"), ("--until", "20")],
    );
    let of = |name: &str| orbit.trajectory.column(name).expect("a column")[0];
    let (v, mu) = (1.6, 4.0);
    let a = 1.0 / (2.0 - v * v / mu);
    assert!((of("a01") - a).abs() < 1e-15 && (of("e01") - (1.0 - 1.0 / a).abs()).abs() < 1e-15);
    assert!(drift(&orbit, "a01") < 1e-8 && drift(&orbit, "e01") < 1e-8);
}

/// Whatever is asked for is asked at looks: a run that is interrupted at one of them has the samples of all before.
#[test]
fn an_interrupted_cluster_keeps_what_is_done() {
    let settings = [("--method", "rk4"), ("--dt", "0.01"), ("--until", "4"), ("--every", "0.25")];
    let plan = Plan::new(&scenario("cluster", &settings)).expect("a plan");
    let broken_at = |last: usize| {
        let mut looks = 0;
        let outcome = run(&plan, &mut |_| {
            looks += 1;
            if looks < last { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        });
        (looks, outcome)
    };
    let (all, whole) = broken_at(usize::MAX);
    let mut kept = vec![];
    for last in [1, all / 3, all / 2, all] {
        let (looks, part) = broken_at(last);
        assert_eq!(looks, last, "nothing is asked after the end");
        let rows = part.trajectory.rows().count();
        assert_eq!(part.trajectory.numbers, whole.trajectory.numbers[..part.trajectory.numbers.len()]);
        let t = 0.25 * (rows - 1) as f64;
        assert_eq!(part.failure, Some(Failure::Interrupted { t }));
        if last > 1 {
            assert_eq!(part.provenance.steps, whole.provenance.steps * (rows as u64 - 1) / 16);
        }
        kept.push(rows);
    }
    assert!(kept.is_sorted() && kept[0] == 1 && kept[1] > 3 && kept[3] == 16, "{kept:?}");
}

/// The asteroids run in lanes and threads, part by part: the bits are those of all together.
#[test]
fn a_cluster_by_parts_has_the_bits_of_the_whole() {
    for (stepping, method) in [
        ("corrected", "verlet"),
        ("corrected", "rk4"),
        ("corrected", "yoshida4"),
        ("as_printed", "euler_taylor"),
    ] {
        let settings = [
            ("stepping", stepping),
            ("--method", method),
            ("--until", "20"),
            ("--dt", "0.01"),
            ("--every", "2"),
        ];
        let parts = scenario("cluster", &settings);
        // A watch asks for the run as a whole.
        let mut whole = parts.clone();
        whole.events.push(precess::EventSpec { when: "distance = 1".into(), ..Default::default() });
        let (parts, whole) = (of(&parts), of(&whole));
        assert_eq!(hash(&parts.trajectory), hash(&whole.trajectory), "{stepping} {method}");
        assert_eq!(parts.trajectory.numbers, whole.trajectory.numbers);
        assert_eq!(parts.provenance.steps, whole.provenance.steps);
    }
}

#[test]
fn what_is_stepped_as_printed_takes_the_printed_method() {
    let plan = Plan::new(&scenario("cluster", &[("stepping", "as_printed")])).expect("a plan");
    assert_eq!(plan.method.card().id, "euler_taylor");
    let refusal = Plan::new(&scenario("cluster", &[("stepping", "as_printed"), ("--method", "rk4")]));
    let sentence = refusal.err().expect("refused").to_string();
    assert!(sentence.contains("euler_taylor") && sentence.contains("rk4"), "{sentence}");
}
