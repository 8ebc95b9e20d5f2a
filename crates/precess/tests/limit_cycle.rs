//! Van der Pol's limit cycle: amplitude and period against their published expansions, and converged where those end.
//!
//! For x'' - e (1 - x^2) x' + x = 0 (C. Andersen and J. Geer, SIAM J. Appl. Math. 42, 678, 1982):
//!
//!     angular frequency 1 - e^2/16 + 17 e^4/3072 + 35 e^6/884736 - ...
//!     amplitude 2 + e^2/96 - 1033 e^4/552960 + ...

use precess::value::{Value, parse};
use precess::{EventSpec, Plan, Scenario, run};
use std::f64::consts::PI;
use std::ops::ControlFlow;

/// Amplitude and period after the transient.
fn cycle(e: f64, method: &str, settings: &[(&str, &str)], until: f64) -> [f64; 2] {
    let mut scenario = Scenario::of("van_der_pol");
    scenario.method = Some(method.into());
    Scenario::set(&mut scenario.parameters, "b0", Value::number(e));
    Scenario::set(&mut scenario.start, "x", Value::number(2.0));
    Scenario::set(&mut scenario.start, "x_dot", Value::number(0.0));
    Scenario::set(&mut scenario.run, "until", Value::number(until));
    Scenario::set(&mut scenario.run, "every", Value::number(until));
    for (name, value) in settings {
        Scenario::set(&mut scenario.run, name, parse(value).expect("a value"));
    }
    let event = |when: &str, direction: &str| EventSpec {
        when: when.into(),
        direction: Some(direction.into()),
        ..EventSpec::default()
    };
    scenario.events = vec![event("x_dot = 0", "falling"), event("x = 0", "rising")];
    let outcome = run(&Plan::new(&scenario).expect("a plan"), &mut |_| ControlFlow::Continue(()));
    assert_eq!(outcome.failure, None);
    let met = |name: &str| outcome.trajectory.events.iter().filter(|e| e.name == name).collect::<Vec<_>>();
    let (tops, passages) = (met("x_dot = 0"), met("x = 0"));
    let [before, last] = passages[passages.len() - 2..] else { panic!("two passages") };
    [tops.last().expect("a top").state[0], last.t - before.t]
}

#[test]
fn small_cycles_are_those_of_the_expansion() {
    let tight = [("rtol", "1e-13"), ("atol", "1e-13")];
    for (e, until, bound) in [(0.05, 900.0, 1e-9), (0.1, 450.0, 2e-9), (0.2, 250.0, 5e-8)] {
        let [amplitude, period] = cycle(e, "dop853", &tight, until);
        let square: f64 = e * e;
        let frequency = 1.0 - square / 16.0
            + 17.0 * square * square / 3072.0
            + 35.0 * square * square * square / 884736.0;
        let expected = 2.0 + square / 96.0 - 1033.0 * square * square / 552960.0;
        println!("e = {e}: {:.2e} {:.2e}", amplitude - expected, period - 2.0 * PI / frequency);
        assert!((amplitude - expected).abs() < bound, "e = {e}: {amplitude} {expected}");
        assert!((period - 2.0 * PI / frequency).abs() < bound, "e = {e}: {period}");
    }
}

/// At e = 1.6 two methods of different kinds agree to 1e-10.
#[test]
fn the_largest_cycle_of_figure_15_is_converged() {
    let one = cycle(1.6, "dop853", &[("rtol", "1e-13"), ("atol", "1e-13")], 60.0);
    let two = cycle(1.6, "tsit5", &[("rtol", "1e-13"), ("atol", "1e-13")], 60.0);
    println!("{one:?} {two:?}");
    for (a, b) in one.iter().zip(&two) {
        assert!((a - b).abs() < 1e-10, "{one:?} {two:?}");
    }
}
