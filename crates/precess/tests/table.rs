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

/// Beyond Jellett's threshold (76.7 rad/s from nearly upright) it turns over completely, below it stays leaning.
#[test]
fn a_tippe_top_turns_over_completely_beyond_the_threshold() {
    let leaning = |spin: &str| {
        let settings = [
            ("-omega3", spin),
            ("epsilon", "1e-2"),
            ("--rtol", "1e-9"),
            ("--atol", "1e-9"),
            ("--until", "40"),
        ];
        let run = go("tippe_top", &settings, None);
        let theta = run.trajectory.column("theta").expect("a column");
        theta[theta.len() * 3 / 4..].iter().sum::<f64>() / (theta.len() - theta.len() * 3 / 4) as f64
    };
    let (below, beyond) = (leaning("69"), leaning("84.4"));
    assert!((2.2..2.5).contains(&below) && beyond > 2.95, "{below} {beyond}");
}

/// With exact dry friction the contact comes to rest and the top rolls: it does not turn over, and Routh's quantity is constant.
#[test]
fn a_tippe_top_that_sticks_does_not_turn_over() {
    let run = go("tippe_top", &[("friction", "coulomb"), ("--until", "4")], None);
    let names: Vec<&str> = run.trajectory.events.iter().map(|event| event.name.as_str()).collect();
    assert_eq!(names, ["sticks"]);
    let rests = run.trajectory.events[0].t;
    let after = |name: &str| -> Vec<f64> {
        let (times, column) = (run.trajectory.column("t"), run.trajectory.column(name).expect("a column"));
        times.expect("times").into_iter().zip(column).filter(|(t, _)| *t > rests).map(|(_, x)| x).collect()
    };
    for name in ["routh", "energy"] {
        let values = after(name);
        assert!(values.iter().all(|x| (x / values[0] - 1.0).abs() < 1e-12), "{name}");
    }
    assert!(
        after("theta").iter().all(|theta| *theta < 0.2) && after("slip").iter().all(|slip| *slip < 1e-10)
    );
}

#[test]
fn a_billiard_ball_sticks_at_two_sevenths() {
    let run = go("billiard_ball", &[("friction", "coulomb")], None);
    let rolls = 2.0 * 2.0 / (7.0 * 0.3 * 9.81);
    assert!((run.trajectory.events[0].t / rolls - 1.0).abs() < 1e-11, "{}", run.trajectory.events[0].t);
    assert!((last(&run, "x_dot") - 2.0 * 5.0 / 7.0).abs() < 1e-10, "{}", last(&run, "x_dot"));
}

/// Boole's rule over the power gives what the energy has lost.
#[test]
fn friction_takes_what_the_energy_loses() {
    for (law, spot) in [("coulomb_smooth", "0"), ("viscous", "0"), ("drilling", "1e-3")] {
        let settings = [
            ("friction", law),
            ("spot", spot),
            ("epsilon", "0.1"),
            ("damping", "1e-8"),
            ("--rtol", "1e-13"),
            ("--atol", "1e-13"),
            ("--until", "1"),
            ("--every", "1e-4"),
        ];
        let run = go("tippe_top", &settings, None);
        let power = run.trajectory.column("power").expect("a column");
        let energy = run.trajectory.column("energy").expect("a column");
        let quarters = power.windows(5).step_by(4);
        let work: f64 =
            quarters.map(|p| 2e-4 / 45.0 * (7.0 * (p[0] + p[4]) + 32.0 * (p[1] + p[3]) + 12.0 * p[2])).sum();
        let lost = last(&run, "energy") - energy[0];
        assert!(lost < -1e-3 * energy[0], "{law} takes something");
        assert!((work - lost).abs() < 1e-12 * energy[0], "{law}: {work} {lost}");
    }
}

/// A top that falls bounces, hops and turns over; no blow and no friction changes Jellett's quantity, and none gives energy.
#[test]
fn a_tippe_top_that_is_dropped_keeps_jelletts_quantity() {
    let settings = [
        ("contact", "free"),
        ("friction", "coulomb"),
        ("restitution", "0.5"),
        ("-z", "0.05"),
        ("--until", "1"),
    ];
    let run = go("tippe_top", &settings, None);
    let first = run.trajectory.events[0].t;
    let falls: f64 = 0.05 + 0.02 * (0.3 * precess::scalar::Scalar::cos(0.1) - 1.0);
    assert!((first - (2.0 * falls / 9.81).sqrt()).abs() < 1e-11, "{first}");
    assert!(drift(&run, "jellett") < 1e-11, "{}", drift(&run, "jellett"));
    let energy = run.trajectory.column("energy").expect("a column");
    assert!(energy.windows(2).all(|e| e[1] <= e[0] * (1.0 + 1e-13)), "energy only falls");
    let lands = run.trajectory.events.iter().filter(|event| event.name == "lands").count();
    assert!(lands > 5 && run.trajectory.events.iter().any(|event| event.name == "sticks"), "{lands}");
}

/// Under much friction Painleve's denominator is another on the other side of N = 0; a free contact is not there to meet it.
#[test]
fn a_slender_egg_lifts_off_and_does_not_jam() {
    let slender = [("a", "0.1"), ("b", "0.02"), ("m", "0.1"), ("i1", "2.08e-4"), ("i3", "1.6e-5")];
    let table = [("friction", "coulomb"), ("mu", "2"), ("contact", "free"), ("--until", "0.25")];
    let start = [("-theta", "0.08"), ("-omega1", "0.5"), ("-omega2", "0"), ("-omega3", "0"), ("-y_dot", "1")];
    let run = go("spinning_egg", &[&slender[..], &table, &start].concat(), None);
    let events: Vec<&str> = run.trajectory.events.iter().map(|event| event.name.as_str()).collect();
    assert!(events.contains(&"lifts") && !events.contains(&"jams"), "{events:?}");
    let normal = run.trajectory.column("normal").expect("a column");
    assert!(normal.iter().all(|push| *push >= 0.0), "the table does not pull");
}

/// A block that slides up an inclined table and stays there, or comes back: mu above or below the slope.
#[test]
fn a_ball_rolls_down_a_slope_where_friction_is_enough() {
    // A homogeneous ball needs mu of 2/7 of the slope.
    let acceleration = |mu: &str| {
        let settings =
            [("friction", "coulomb"), ("mu", mu), ("slope", "0.5"), ("-x_dot", "0"), ("--until", "1")];
        last(&go("billiard_ball", &settings, None), "x_dot")
    };
    let down = 9.81 / 1.25_f64.sqrt();
    assert!((acceleration("0.15") - 5.0 / 7.0 * 0.5 * down).abs() < 1e-9, "it rolls");
    assert!((acceleration("0.1") - (0.5 - 0.1) * down).abs() < 1e-9, "it slips: 2/7 * 0.5 is above 0.1");
}

/// T, section 6.2, lets a rolling egg rise; only one that slips does.
#[test]
fn an_egg_rises_because_it_slips() {
    let lowest = |settings: &[(&str, &str)]| {
        let theta = go("spinning_egg", settings, None).trajectory.column("theta").expect("a column");
        theta.into_iter().fold(0.0, |a, theta| {
            let lean = (theta - std::f64::consts::FRAC_PI_2).abs();
            if lean > a { lean } else { a }
        })
    };
    let slips = lowest(&[("--until", "2"), ("--rtol", "1e-9"), ("--atol", "1e-9")]);
    let rolls = lowest(&[("--until", "2"), ("friction", "coulomb"), ("mu", "1e3")]);
    assert!(slips > 1.1 && rolls < 0.2, "{slips} {rolls}");
}

/// The sharp tip keeps its spin and does not rise, the round one does.
#[test]
fn a_round_tip_rises_and_a_sharp_one_does_not() {
    let lean = |id: &str| {
        let run =
            go(id, &[("--until", "1"), ("--rtol", "1e-9"), ("--atol", "1e-9"), ("contact", "free")], None);
        let theta = run.trajectory.column("theta").expect("a column");
        let tail = &theta[theta.len() / 2..];
        (tail.iter().sum::<f64>() / tail.len() as f64, last(&run, "spin_axis"))
    };
    let ((sharp, spin), (round, slower)) = (lean("sliding_cone"), lean("rounded_top"));
    assert!((0.3..0.36).contains(&sharp) && (spin - 600.0).abs() < 1e-9, "{sharp} {spin}");
    assert!(round < 0.2 && slower < 599.5, "{round} {slower}");
}

/// A rattleback whose axes of inertia are those of its shape (a solid of revolution is one) never turns back.
#[test]
fn a_rattleback_needs_skew_axes() {
    for spin in ["5", "-5"] {
        let run = go("rattleback", &[("-omega3", spin), ("i12", "0"), ("--until", "20")], Some("spin = 0"));
        assert_eq!(run.trajectory.events.len(), 0);
    }
}

/// Kane and Levinson's stone, written out.
const STONE: &str = "precess = 1\n[system]\nid = \"rolling_body\"\n[system.body]\nmass = 1.0\n\
    inertia = [[2e-4, 2e-5, 0], [2e-5, 16e-4, 0], [0, 0, 17e-4]]\n\
    support = { point = [0, 0, 0.01], radius = 0, axes = [0.2, 0.03, 0.02] }\n";

#[test]
fn a_body_written_out_is_the_named_one() {
    let start = ["omega1 = 0", "omega2 = 0", "omega3 = 5", "theta = 0.01", "phi = 0.5"].join("\n");
    let rest = format!("[start]\n{start}\n[run]\nuntil = 1\n");
    let end = |text: &str| {
        let plan = Plan::new(&Scenario::parse(text).expect("a scenario")).expect("a plan");
        let outcome = run(&plan, &mut |_| ControlFlow::Continue(()));
        ["qw", "qx", "qy", "qz", "omega1", "omega2", "omega3", "x", "y"]
            .map(|name| last(&outcome, name).to_bits())
    };
    let named = format!("precess = 1\n[system]\nid = \"rattleback\"\n{rest}");
    assert_eq!(end(&format!("{STONE}{rest}")), end(&named));
    let shape = "precess = 1\n[system]\nid = \"rolling_body\"\n[system.body]\nshape = \"sphere\"\nmass = 1\nradius = \"2 cm\"\n";
    let plan = Plan::new(&Scenario::parse(shape).expect("a scenario")).expect("a plan");
    let value = |name: &str| plan.values.number(&plan.card, name).expect("a parameter");
    assert!(value("radius") == 0.02 && value("axis1") == 0.0 && (value("i22") - 0.4 * 4e-4).abs() < 1e-18);
}

#[test]
fn a_body_that_makes_no_sense_is_refused_with_the_line() {
    let refusal = |from: &str, to: &str| {
        let text = STONE.replace(from, to);
        assert_ne!(text, STONE);
        let planned = Scenario::parse(&text).and_then(|scenario| Plan::new(&scenario).map(|_| ()));
        planned.expect_err("this makes no sense").to_string()
    };
    for (from, to, words) in [
        ("mass = 1.0", "mass = 0", &["mass", "above zero"][..]),
        ("mass = 1.0", "mas = 1.0", &["line 5", "'mas'", "mass"]),
        ("2e-5, 16e-4", "3e-5, 16e-4", &["line 6", "not symmetric", "12 and 21"]),
        ("17e-4", "19e-4", &["no body has this inertia"]),
        ("radius = 0", "radius = -1", &["line 7", "convex"]),
        ("axes = [0.2, 0.03, 0.02]", "axes = [0.2, 0.03]", &["line 7", "three numbers"]),
        ("rolling_body", "rattleback", &["rattleback", "rolling_body and sliding_body"]),
        ("mass = 1.0\n", "mass = 1.0\nshape = \"sphere\"\n", &["inertia"]),
        ("[system.body]", "parameters = { m = 2 }\n[system.body]", &["m is given twice"]),
        ("rolling_body", "heavy_top", &["heavy_top takes a shape, not 'mass'"]),
    ] {
        let sentence = refusal(from, to);
        assert!(words.iter().all(|word| sentence.contains(word)), "{sentence}");
    }
}

/// A top with a stem, by its radii.
fn drawn(system: &str, radii: &str) -> Result<Plan, String> {
    let body = format!("shape = \"smooth_profile\"\ndensity = 700\nheight = 0.06\nradii = {radii}\n");
    let text = format!("precess = 1\n[system]\nid = \"{system}\"\n[system.body]\n{body}");
    Scenario::parse(&text).and_then(|scenario| Plan::new(&scenario)).map_err(|e| e.to_string())
}

#[test]
fn a_profile_becomes_a_heavy_top_that_turns_about_its_lower_end() {
    let plan = drawn("heavy_top", "[0.002, 0.02, 0.028, 0.01, 0.004]").expect("a top");
    let words = ["smooth_profile", "density=700", "height=0.06", "radii=[0.002; 0.02; 0.028; 0.01; 0.004]"];
    let solid = precess::body::read(&words.map(String::from)).expect("the same body");
    let value = |name: &str| plan.values.number(&plan.card, name).expect("a parameter");
    assert_eq!(value("m"), solid.mass);
    assert_eq!(plan.values.lists[0].items, solid.centre);
    // Huygens and Steiner.
    let carried = solid.inertia[0][0] + solid.mass * solid.centre[2] * solid.centre[2];
    assert!((value("i1") - carried).abs() < 1e-15 * carried && value("i1") == value("i2"));
    assert_eq!(value("i3"), solid.inertia[2][2]);
}

#[test]
fn a_hollow_profile_stands_on_no_table() {
    let hollow = drawn("sliding_body", "[0.002, 0.02, 0.028, 0.01, 0.004]").err().expect("it has a stem");
    assert!(hollow.contains("hollow at radius 4") && hollow.contains("convex"), "{hollow}");
    drawn("sliding_body", "[0.01, 0.02, 0.022, 0.02, 0.01]").expect("a barrel");
}
