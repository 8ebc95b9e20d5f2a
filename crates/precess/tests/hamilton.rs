//! The method that works in momenta, on Hamiltonians that are not separable.

use precess::scalar::Scalar;
use precess::value::{Value, parse};
use precess::{Plan, Scenario, run};
use std::ops::ControlFlow;

fn plan(system: &str, method: &str, start: &[(&str, f64)], dt: f64, until: f64) -> Plan {
    let mut scenario = Scenario::of(system);
    scenario.method = Some(method.into());
    scenario.start = start.iter().map(|(name, x)| ((*name).into(), Value::number(*x))).collect();
    let settings = [("dt", dt), ("until", until), ("every", dt.larger(until / 100.0))];
    scenario.run = settings.iter().map(|(name, x)| ((*name).into(), Value::number(*x))).collect();
    Plan::new(&scenario).expect("a plan")
}

fn last(plan: &Plan) -> Vec<f64> {
    let outcome = run(plan, &mut |_| ControlFlow::Continue(()));
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    outcome.trajectory.rows().last().expect("a row").to_vec()
}

const DOUBLE: [(&str, f64); 4] =
    [("theta1", 1.0), ("theta2", 0.4), ("theta1_dot", 0.3), ("theta2_dot", -0.2)];

#[test]
fn its_order_is_one() {
    let exact = {
        let mut scenario = Scenario::of("double_pendulum");
        scenario.start = DOUBLE.iter().map(|(name, x)| ((*name).into(), Value::number(*x))).collect();
        scenario.run = vec![("until".into(), Value::number(0.5)), ("rtol".into(), Value::number(1e-13))];
        last(&Plan::new(&scenario).expect("a plan"))
    };
    let error = |dt: f64| {
        let end = last(&plan("double_pendulum", "euler_cromer_implicit", &DOUBLE, dt, 0.5));
        (1..5).fold(0.0, |worst: f64, i| (end[i] - exact[i]).abs().larger(worst))
    };
    let order = Scalar::ln(error(1e-3) / error(1e-4)) / std::f64::consts::LN_10;
    assert!((order - 1.0).abs() < 0.05, "{order}");
}

/// The area of two displacements in positions and momenta, before and after a step: kept where a method is symplectic.
fn area_error(method: &str) -> f64 {
    let plan = plan("double_pendulum", method, &DOUBLE, 0.1, 0.1);
    let momenta =
        precess::system::momenta(plan.system, &plan.values, &plan.layout).expect("it has a Lagrangian");
    let canonical = |y: &[f64]| {
        let at: Vec<f64> = std::iter::once(0.0).chain(y.iter().copied()).collect();
        let p = momenta.evaluate(&at);
        [y[0], y[1], p[0], p[1]]
    };
    let step = |y: &[f64]| {
        let mut plan = plan.clone();
        plan.start = y.to_vec();
        canonical(&last(&plan)[1..5])
    };
    let h = 1e-5;
    let along = |f: &dyn Fn(&[f64]) -> [f64; 4], direction: [f64; 4]| {
        let shifted =
            |s: f64| -> Vec<f64> { plan.start.iter().zip(direction).map(|(x, d)| x + s * d).collect() };
        let (plus, minus) = (f(&shifted(h)), f(&shifted(-h)));
        [0, 1, 2, 3].map(|i| (plus[i] - minus[i]) / (2.0 * h))
    };
    let area = |f: &dyn Fn(&[f64]) -> [f64; 4]| {
        let (a, b) = (along(f, [1.0, 0.3, -0.4, 0.2]), along(f, [-0.2, 0.7, 0.5, 1.0]));
        (0..2).map(|i| a[i] * b[i + 2] - a[i + 2] * b[i]).sum::<f64>()
    };
    (area(&step) / area(&canonical) - 1.0).abs()
}

#[test]
fn it_keeps_the_area_of_phase_space_where_its_explicit_cousin_does_not() {
    let (implicit, explicit) = (area_error("euler_cromer_implicit"), area_error("euler_cromer"));
    println!("{implicit:.1e}, {explicit:.1e}");
    assert!(implicit < 1e-8, "{implicit:e}");
    assert!(explicit > 1e-4, "{explicit:e}");
}

#[test]
fn the_energy_of_the_cone_stays_where_it_was() {
    let drift = |method: &str, until: f64| {
        let plan = plan("gyroscope", method, &[], 1e-3, until);
        let columns = plan.columns();
        let energy = columns.iter().position(|c| c.name == "energy").expect("a column");
        let outcome = run(&plan, &mut |_| ControlFlow::Continue(()));
        let energies: Vec<f64> = outcome.trajectory.rows().map(|row| row[energy]).collect();
        energies.iter().fold(0.0, |worst: f64, e| (e / energies[0] - 1.0).abs().larger(worst))
    };
    let [short, long] = [1.0, 10.0].map(|until| drift("euler_cromer_implicit", until));
    let explicit = drift("euler_cromer", 1.0);
    println!("{short:.1e}, {long:.1e}, {explicit:.1e}");
    // Of order h = 1e-3 and bounded; the explicit one drifts away.
    assert!(short < 0.02 && long < 1.2 * short && explicit > 0.2, "{short}, {long}, {explicit}");
}

#[test]
fn friction_and_a_missing_lagrangian_are_refused() {
    let refusal = |system: &str, parameters: &[(&str, &str)], method: &str| {
        let mut scenario = Scenario::of(system);
        scenario.method = Some(method.into());
        scenario.parameters =
            parameters.iter().map(|(name, x)| ((*name).into(), parse(x).expect("a value"))).collect();
        Plan::new(&scenario).err().map(|e| e.to_string()).unwrap_or_default()
    };
    let implicit = "euler_cromer_implicit";
    assert!(refusal("pendulum", &[("b", "0.1")], implicit).contains("forces that are all in the Lagrangian"));
    assert!(refusal("lorenz", &[], implicit).contains("lorenz has none"));
    assert_eq!(refusal("pendulum", &[], implicit), "");
    assert!(
        refusal("tippe_top", &[("friction", "drilling"), ("spot", "1e-3")], "taylor")
            .contains("contain an absolute value")
    );
    // Its sign is that of the motion since the last event.
    assert_eq!(refusal("pendulum", &[("dry", "0.1")], "taylor"), "");
    assert_eq!(refusal("pendulum", &[("b", "0.1")], "taylor"), "");
}

/// Recorded equations hold their parameters as literals.
#[test]
fn a_parameter_that_is_moved_moves_in_the_recorded_equations_too() {
    let by = |l: f64| {
        let mut scenario = Scenario::of("pendulum");
        scenario.method = Some("taylor".into());
        scenario.parameters = vec![("l".into(), Value::number(l))];
        Plan::new(&scenario).expect("a plan")
    };
    let mut moved = by(1.0);
    moved.shift("l", 1.0).expect("it may move");
    assert_eq!(last(&moved), last(&by(2.0)));
}

/// Tangent vectors have equations of their own, which nobody recorded.
#[test]
fn analyses_refuse_a_method_that_knows_the_equations_of_the_motion_alone() {
    let mut scenario = Scenario::of("double_pendulum");
    for method in ["taylor", "euler_cromer_implicit"] {
        scenario.method = Some(method.into());
        let refused = precess::analyses::lyapunov(&scenario, &mut |_| ControlFlow::Continue(()));
        let sentence = refused.err().map(|e| e.to_string()).unwrap_or_default();
        assert!(sentence.contains("its neighbours"), "{method}: {sentence}");
    }
}
