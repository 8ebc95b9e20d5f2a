//! Sensitivities against closed forms and differences, and fits that find what the data were made with.

use precess::analyses::{Data, fit, sensitivities};
use precess::value::Value;
use precess::{Error, Plan, Scenario, catalogue, run};
use precess_scalar::Scalar;
use std::ops::ControlFlow;

fn go_on(_: f64) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

fn scenario(system: &str, start: &[(&str, f64)], parameters: &[(&str, f64)]) -> Scenario {
    let values = |list: &[(&str, f64)]| list.iter().map(|(n, x)| ((*n).into(), Value::number(*x))).collect();
    let mut scenario = Scenario::of(system);
    (scenario.start, scenario.parameters) = (values(start), values(parameters));
    scenario.run = values(&[("rtol", 1e-13), ("atol", 1e-13)]);
    scenario.method = Some("dop853".into());
    scenario
}

fn names(names: &[&str]) -> Vec<String> {
    names.iter().map(ToString::to_string).collect()
}

#[test]
fn an_oscillator_answers_as_its_closed_form() {
    let plan = Plan::new(&scenario("harmonic_oscillator", &[("x", 0.8), ("x_dot", 0.3)], &[("omega", 2.0)]));
    let plan = plan.expect("a plan");
    let times = [0.0, 0.7, 3.1];
    let along = names(&["x", "x_dot", "omega"]);
    let found = sensitivities(&plan, &along, &times, &mut go_on).expect("sensitivities");
    let width = plan.width() - 1;
    for (t, slopes) in times.iter().zip(found.slopes.chunks(3 * width)) {
        let (sin, cos) = Scalar::sin_cos(2.0 * t);
        // x = x0 cos wt + v0 sin wt / w.
        let by_omega = -0.8 * t * sin + 0.3 * (t * cos / 2.0 - sin / 4.0);
        for (k, wanted) in [cos, sin / 2.0, by_omega].into_iter().enumerate() {
            assert!(
                (slopes[k * width] - wanted).abs() < 1e-11,
                "t = {t}, direction {k}: {}",
                slopes[k * width]
            );
        }
    }
}

/// Numbers of a state beyond which a system is not held against differences here.
const MOST: usize = 50;

/// Every smooth system, every number of its start and every numeric parameter, against central differences.
#[test]
fn every_system_answers_as_its_differences() {
    for system in catalogue::systems() {
        let card = system.card();
        let mut scenario = scenario(card.id, &[], &[]);
        // Differences of two runs are to be larger than what the tolerance lets go.
        let settings = [("until", card.defaults.until / 100.0), ("rtol", 1e-13), ("atol", 1e-13)];
        scenario.run = settings.map(|(name, x)| (name.into(), Value::number(x))).into();
        let plan = Plan::new(&scenario).expect("defaults make sense");
        if plan.structure.hybrid {
            let refusal = sensitivities(&plan, &[], &[1.0], &mut go_on);
            assert!(matches!(refusal, Err(Error::Input(_))), "{}", card.id);
            continue;
        }
        let state: Vec<String> = plan.layout.state().into_iter().map(|q| q.name).collect();
        // Larger systems are the same few equations again and again.
        if state.len() > MOST {
            continue;
        }
        let parameters =
            card.parameters.iter().filter(|p| matches!(p.default, precess::system::Default::Number(_)));
        let along: Vec<String> =
            state.iter().cloned().chain(parameters.map(|p| p.quantity.name.clone())).collect();
        let found = sensitivities(&plan, &along, &[plan.until], &mut go_on).expect("sensitivities");
        let width = plan.width() - 1;
        let mut held = 0;
        for (k, name) in along.iter().enumerate() {
            let end = |move_by: f64| {
                let mut moved = plan.clone();
                moved.shift(name, move_by).ok()?;
                let outcome = run(&moved, &mut go_on);
                outcome.trajectory.rows().last().map(|row| row[1..=state.len()].to_vec())
            };
            let number = plan.number(name).abs();
            // A length of zero may be short beside others of its body.
            let h = if number == 0.0 { 2e-6 } else { 1e-4 * number };
            let (Some(a), Some(b), Some(c), Some(d)) = (end(-2.0 * h), end(-h), end(h), end(2.0 * h)) else {
                continue;
            };
            held += 1;
            let blur = a.iter().fold(1.0, |most: f64, x| x.abs().larger(most)) * 3e-13 / h;
            for (j, slope) in found.slopes[k * width..][..state.len()].iter().enumerate() {
                // Fourth order, of runs that tolerance and rounding blur.
                let difference = (8.0 * (c[j] - b[j]) - (d[j] - a[j])) / (12.0 * h);
                let size = slope.abs().larger(1.0);
                assert!(
                    (slope - difference).abs() < 1e-6 * size + blur,
                    "{}: d{}/d{name} is {slope}, by differences {difference}",
                    card.id,
                    state[j]
                );
            }
        }
        assert!(held > state.len() / 2, "{}: only {held} directions were held against differences", card.id);
    }
}

/// A pendulum that loses energy, with a small error of known pattern on every angle.
fn measured() -> Data {
    let truth = scenario("pendulum", &[("theta", 0.9)], &[("l", 0.8), ("b", 0.12)]);
    let times: Vec<f64> = (0..40).map(|k| 0.1 * f64::from(k) + 0.003 * f64::from(k % 3)).collect();
    let plan = Plan::new(&truth).expect("a plan");
    let found = sensitivities(&plan, &[], &times, &mut go_on).expect("a motion");
    let width = plan.width() - 1;
    let theta: Vec<f64> = found.values.chunks(width).map(|row| row[0]).collect();
    Data { times, columns: vec![("theta".into(), theta)], uncertainties: vec![] }
}

#[test]
fn a_fit_finds_what_the_data_were_made_with() {
    let guess = scenario("pendulum", &[("theta", 0.7)], &[("l", 1.0), ("b", 0.0)]);
    let exact = fit(&guess, &measured(), &names(&["theta", "l", "b"]), &mut go_on).expect("a fit");
    for (fitted, wanted) in exact.fitted.iter().zip([0.9, 0.8, 0.12]) {
        assert!((fitted.value - wanted).abs() < 1e-9, "{fitted:?}");
        assert!(fitted.error < 1e-9, "{fitted:?}");
    }
    // An error of 0.01 with changing sign: the scatter is found, and the truth lies within three standard errors.
    let mut noisy = measured();
    for (k, x) in noisy.columns[0].1.iter_mut().enumerate() {
        *x += if (k * k + k / 3) % 2 == 0 { 0.01 } else { -0.01 };
    }
    let found = fit(&guess, &noisy, &names(&["theta", "l", "b"]), &mut go_on).expect("a fit");
    assert!((found.scatter[0] - 0.01).abs() < 1e-3);
    for (fitted, wanted) in found.fitted.iter().zip([0.9, 0.8, 0.12]) {
        assert!((fitted.value - wanted).abs() < 3.0 * fitted.error && fitted.error < 0.01, "{fitted:?}");
    }
    // With the uncertainties given, chi squared is the number of the data.
    noisy.uncertainties = vec![0.01];
    let given = fit(&guess, &noisy, &names(&["theta", "l", "b"]), &mut go_on).expect("a fit");
    assert!((given.chi2 - 40.0).abs() < 4.0, "{}", given.chi2);
    assert!((given.fitted[1].value - found.fitted[1].value).abs() < 1e-9);
}

#[test]
fn a_fit_refuses_what_makes_no_sense() {
    let guess = scenario("pendulum", &[("theta", 0.7)], &[]);
    let refusal = |change: &dyn Fn(&mut Data), free: &[&str]| {
        let mut data = measured();
        change(&mut data);
        fit(&guess, &data, &names(free), &mut go_on).err().expect("a refusal").to_string()
    };
    let same = |_: &mut Data| {};
    assert!(refusal(&same, &["theta", "m"]).starts_with("the data do not determine m"));
    assert!(refusal(&same, &["l", "g"]).starts_with("the data do not determine g"));
    assert!(refusal(&same, &["lenght"]).contains("no start or numeric parameter of pendulum 'lenght'"));
    assert!(refusal(&same, &["l", "l"]).contains("free twice"));
    assert!(refusal(&same, &[]).contains("needs something free"));
    assert!(refusal(&|d| d.times[3] = d.times[2], &["l"]).contains("is there twice"));
    assert!(refusal(&|d| d.times[3] = 0.0, &["l"]).contains("comes after a later one"));
    assert!(refusal(&|d| d.columns[0].1[4] = f64::NAN, &["l"]).contains("theta has no value at t = "));
    assert!(refusal(&|d| d.columns[0].0 = "thetta".into(), &["l"]).contains("did you mean 'theta'"));
    assert!(refusal(&|d| d.uncertainties = vec![0.0], &["l"]).contains("above zero"));
    let few = |d: &mut Data| {
        d.times.truncate(2);
        d.columns[0].1.truncate(2);
    };
    assert!(refusal(&few, &["theta", "l"]).contains("2 measured numbers are too few"));
}
