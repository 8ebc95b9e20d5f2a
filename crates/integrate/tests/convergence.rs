//! The fitted order of every method is the one on its card.
//!
//! In double-double, so that rounding stays below every error that is measured. The steps are halved; those
//! whose error (the largest at 16 equally spaced times) lies between 1e-20 and 1e-3 of the amplitude count, and
//! the last five of them give the slope by least squares.

mod toys;

use precess_integrate::{Needs, Options};
use precess_scalar::{DoubleDouble, Scalar};
use precess_system::Field;
use toys::{bind, harmonic, kepler, method, methods, mixed, pendulum, stepper, walk};

type Dd = DoubleDouble;

/// Parts of a trajectory at whose ends the error is looked at.
const PARTS: u32 = 16;

fn dd(x: f64) -> Dd {
    Dd::from(x)
}

/// The states at the ends of the parts, `steps` steps each.
fn trajectory(id: &str, field: &dyn Field<Dd>, start: &[Dd], until: f64, steps: u32) -> Vec<Vec<Dd>> {
    let options = Options { epsilon: 1e-24, ..Options::default() };
    let mut stepper = stepper::<Dd>(method(id), field, &options);
    let mut y: Vec<Dd> = start.to_vec();
    let part = dd(until) / f64::from(PARTS);
    let mut states = vec![];
    for k in 0..PARTS {
        walk(stepper.as_mut(), field, part * f64::from(k), &mut y, part / f64::from(steps), steps);
        states.push(y.clone());
    }
    states
}

fn distance(a: &[Vec<Dd>], b: &[Vec<Dd>]) -> f64 {
    let mut worst = 0.0;
    for (x, y) in a.iter().flatten().zip(b.iter().flatten()) {
        worst = (*x - *y).abs().to_f64().larger(worst);
    }
    worst
}

/// Least-squares slope of the error's logarithm against that of the step.
fn fitted_order(id: &str, field: &dyn Field<Dd>, start: &[Dd], until: f64, reference: &[Vec<Dd>]) -> f64 {
    let mut logs = vec![];
    for k in 0..13 {
        let error = distance(&trajectory(id, field, start, until, 1 << k), reference);
        if error < 1e-20 {
            break;
        }
        if error < 1e-3 {
            logs.push((-f64::from(k), Scalar::ln(error) / std::f64::consts::LN_2));
        }
    }
    let logs = &logs[logs.len().saturating_sub(5)..];
    assert!(logs.len() >= 3, "{id}: only {} steps in the window", logs.len());
    let count = logs.len() as f64;
    let (x, y) = logs.iter().fold((0.0, 0.0), |(x, y), l| (x + l.0 / count, y + l.1 / count));
    let (up, down) =
        logs.iter().fold((0.0, 0.0), |(u, d), l| (u + (l.0 - x) * (l.1 - y), d + (l.0 - x) * (l.0 - x)));
    up / down
}

fn check(
    name: &str,
    field: &dyn Field<Dd>,
    start: &[Dd],
    until: f64,
    reference: &[Vec<Dd>],
    separable: bool,
) {
    for m in methods() {
        if m.needs == Needs::Separable && !separable || m.order > 8 {
            continue;
        }
        let slope = fitted_order(m.id, field, start, until, reference);
        println!("{name:<18} {:<14} order {} fitted {slope:.3}", m.id, m.order);
        assert!((slope - f64::from(m.order)).abs() < 0.1, "{name}, {}: {slope}", m.id);
    }
}

#[test]
fn on_the_harmonic_oscillator() {
    let (x, v, until) = (0.6, 0.5, 2.0);
    let exact = (1..=PARTS).map(|k| {
        let (sin, cos) = (dd(until) * f64::from(k) / f64::from(PARTS)).sin_cos();
        vec![cos * x + sin * v, cos * v - sin * x]
    });
    check("harmonic", &harmonic(1.0), &[x, v].map(dd), until, &exact.collect::<Vec<_>>(), true);
}

/// Twice as fine as the finest steps that count.
fn fine(field: &dyn Field<Dd>, start: &[Dd], until: f64) -> Vec<Vec<Dd>> {
    trajectory("dop853", field, start, until, 128)
}

#[test]
fn on_a_damped_pendulum() {
    let (field, start, until) = (pendulum(0.2), [1.2, 0.3].map(dd), 2.0);
    check("damped pendulum", &field, &start, until, &fine(&field, &start, until), false);
}

#[test]
fn on_a_pendulum() {
    let (field, start, until) = (pendulum(0.0), [1.2, 0.3].map(dd), 2.0);
    check("pendulum", &field, &start, until, &fine(&field, &start, until), true);
}

#[test]
fn with_time_and_a_coordinate_of_first_order() {
    let (field, start, until) = (mixed(), [0.4, 1.0, 0.7].map(dd), 2.0);
    check("mixed", &field, &start, until, &fine(&field, &start, until), false);
}

/// The ellipse of Kepler from his equation, `M = E - e sin E`, solved by Newton.
fn ellipse(e: f64, mean: Dd) -> Vec<Dd> {
    let mut anomaly = mean;
    for _ in 0..20 {
        let (sin, cos) = anomaly.sin_cos();
        anomaly = anomaly - (anomaly - sin * e - mean) / (dd(1.0) - cos * e);
    }
    let (sin, cos) = anomaly.sin_cos();
    let (minor, rate) = ((dd(1.0) - dd(e) * e).sqrt(), dd(1.0) / (dd(1.0) - cos * e));
    vec![cos - e, minor * sin, -(sin * rate), minor * cos * rate]
}

#[test]
fn on_a_planet() {
    let (e, from, until) = (0.3, 0.5, 2.0);
    let start = ellipse(e, dd(from));
    let exact: Vec<Vec<Dd>> =
        (1..=PARTS).map(|k| ellipse(e, dd(from) + dd(until) * f64::from(k) / f64::from(PARTS))).collect();
    check("kepler", &kepler(), &start, until, &exact, true);
}

/// A method of order 16 leaves no room between 1e-20 and 1e-3: from steps of a third of a period on, down to 1e-27.
#[test]
fn of_order_sixteen() {
    let (field, start, until) = (harmonic(1.0), [0.6, 0.5].map(dd), 32.0);
    let exact: Vec<Vec<Dd>> = (1..=PARTS)
        .map(|k| {
            let (sin, cos) = (dd(until) * f64::from(k) / f64::from(PARTS)).sin_cos();
            vec![cos * 0.6 + sin * 0.5, cos * 0.5 - sin * 0.6]
        })
        .collect();
    let errors = [1, 2, 4]
        .map(|steps| distance(&trajectory("gauss_legendre16", &field, &start, until, steps), &exact));
    for pair in errors.windows(2) {
        let slope = Scalar::ln(pair[0] / pair[1]) / std::f64::consts::LN_2;
        println!("gauss_legendre16: {:.2e}, {:.2e}: {slope:.3}", pair[0], pair[1]);
        assert!((slope - 16.0).abs() < 0.2 && pair[1] > 1e-27, "{slope}");
    }
}

/// `y' = y` has the solution that every order condition of a linear equation meets: a check of the check.
#[test]
fn an_order_that_is_wrong_is_seen() {
    struct Growth;
    impl toys::Toy for Growth {
        fn rate<S: Scalar>(&self, _t: S, y: &[S], dy: &mut [S]) {
            dy[0] = y[0];
        }
    }
    let field = bind(Growth, 0, 1, 0);
    let exact: Vec<Vec<Dd>> = (1..=PARTS).map(|k| vec![dd(f64::from(k) / f64::from(PARTS)).exp()]).collect();
    let slope = fitted_order("rk4", &field, &[dd(1.0)], 1.0, &exact);
    assert!((slope - 4.0).abs() < 0.1 && (slope - 5.0).abs() > 0.5, "{slope}");
}
