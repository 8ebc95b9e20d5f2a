//! A pendulum on a string, and one with dry friction: what holds them at the start and at events.

mod common;
use common::{given, ready};
use precess_scalar::Scalar;
use std::f64::consts::PI;

#[test]
fn a_string_starts_taut_where_it_pulls_and_slack_elsewhere() {
    let mut string = ready("pendulum");
    string.values.choices[0] = 1;
    string.layout = string.system.layout(&string.values, &given(&[]));
    let slack = |starts: &[(&str, f64)]| {
        let y = string.start(starts).expect("a start");
        (y.len(), y[5])
    };
    assert_eq!(slack(&[]), (7, 0.0));
    // Above the pivot at rest, and fast enough to stay there.
    assert_eq!(slack(&[("theta", 3.0)]).1, 1.0);
    assert_eq!(slack(&[("theta", 3.0), ("theta_dot", 4.0)]).1, 0.0);
    assert_eq!(slack(&[("r", 0.5)]).1, 1.0);
    for (starts, word) in [
        ([("r", 1.5), ("r_dot", 0.0)], "long"),
        ([("r", 0.0), ("r_dot", 0.0)], "distance"),
        ([("r", 1.0), ("r_dot", 0.1)], "taut"),
    ] {
        let refusal = string.start(&starts).expect_err("no start");
        assert!(refusal.contains(word), "{refusal}");
    }
}

/// Where it falls free, no force but gravity acts: x'' = 0, y'' = -g.
#[test]
fn a_slack_string_leaves_a_parabola() {
    let mut string = ready("pendulum");
    string.values.choices[0] = 1;
    string.layout = string.system.layout(&string.values, &given(&[]));
    let y =
        string.start(&[("theta", 2.5), ("theta_dot", -1.0), ("r", 0.7), ("r_dot", 0.4)]).expect("a start");
    let rate = string.rate(&y);
    let ([theta, r, w, u], [turning, outwards]) = ([y[0], y[1], y[2], y[3]], [rate[2], rate[3]]);
    let (sin, cos) = Scalar::sin_cos(theta);
    let (radial, along) = (outwards - r * w * w, r * turning + 2.0 * u * w);
    assert!((radial * sin + along * cos).abs() < 1e-14, "x'' = 0");
    assert!((radial * cos - along * sin - 9.81).abs() < 1e-14, "downwards g");
}

#[test]
fn dry_friction_holds_where_gravity_is_weaker() {
    let mut rod = ready("pendulum");
    rod.set("dry", 2.0);
    rod.layout = rod.system.layout(&rod.values, &given(&[]));
    // sin(theta) = 2 / 9.81 is the edge.
    for (theta, held) in [(0.2, true), (0.21, false), (PI - 0.2, true), (PI / 2.0, false), (-0.1, true)] {
        let y = rod.start(&[("theta", theta)]).expect("a start");
        assert_eq!(y[2] == 0.0, held, "{theta}");
        let a = rod.rate(&y)[1];
        let pull = -9.81 * Scalar::sin(theta);
        assert!(if held { a == 0.0 } else { (a - pull + 2.0 * pull.signum()).abs() < 1e-14 }, "{theta}: {a}");
    }
}
