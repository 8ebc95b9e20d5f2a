//! Orders of convergence, measured.

mod common;

use common::{Driven, Kepler, Mixed, Oscillator, field, layout, method, needs_separable};
use precess_integrate::{METHODS, Options, Stepper, Steps};
use precess_scalar::{DoubleDouble, Scalar};
use precess_system::{Field, System};

/// The states at the sixteen sixteenths of a span after so many steps of equal length.
fn path<S: Scalar>(
    mut stepper: Box<dyn Stepper<S>>,
    field: &dyn Field<S>,
    start: &[f64],
    span: f64,
    steps: u32,
    to_f64: impl Fn(&S) -> f64,
) -> Vec<f64> {
    let mut y: Vec<S> = start.iter().map(|x| S::from(*x)).collect();
    let mut next = y.clone();
    let h = S::from(span) / f64::from(steps);
    let mut path = vec![];
    for n in 0..steps {
        stepper.step(field, h * f64::from(n), &y, h, &mut next).expect("small steps converge");
        stepper.accept();
        std::mem::swap(&mut y, &mut next);
        if (n + 1) % (steps / 16) == 0 {
            path.extend(y.iter().map(&to_f64));
        }
    }
    path
}

/// Maximum errors for halved steps, as far as they lie in the window where the leading term rules: below a
/// thousandth of the motion, above the rounding. From order 5 on f64 leaves no window, so double-double computes.
fn errors(id: &str, system: &impl System) -> Vec<(f64, f64)> {
    let start = layout(system).start();
    let (plain, double) = (field::<f64>(system), field::<DoubleDouble>(system));
    let twice = method(id).card().order >= 5;
    // Methods of order 5 are tuned to a small leading term: it rules only at short steps, where a longer run
    // keeps the error above the rounding of the coefficients.
    let span = if twice { 20.0 } else { 2.0 };
    let options = Options { epsilon: 1e-15, ..Options::default() };
    let accurate = Steps::<DoubleDouble>::stepper(method("dop853"), plain.shape(), &options);
    let reference = path(accurate, double.as_ref(), &start, span, 4096, |x| x.to_f64());
    let mut errors = vec![];
    for halving in 4..=17 {
        let steps = 1 << halving;
        let found = if twice {
            let stepper = Steps::<DoubleDouble>::stepper(method(id), plain.shape(), &options);
            path(stepper, double.as_ref(), &start, span, steps, |x| x.to_f64())
        } else {
            let stepper = Steps::<f64>::stepper(method(id), plain.shape(), &options);
            path(stepper, plain.as_ref(), &start, span, steps, |x| *x)
        };
        let distances = found.iter().zip(&reference).map(|(a, b)| (a - b).abs());
        let error = distances.fold(0.0, Scalar::larger);
        if error < if twice { 2e-13 } else { 3e-12 } {
            break;
        }
        if error < 1e-3 {
            errors.push((f64::from(steps), error));
        }
    }
    errors
}

/// Least-squares slope of ln(error) against ln(steps) over the last three points: the finest steps.
fn order(errors: &[(f64, f64)]) -> f64 {
    assert!(errors.len() >= 3, "too few points in the window: {errors:?}");
    let last = &errors[errors.len().saturating_sub(3)..];
    let points: Vec<(f64, f64)> = last.iter().map(|(n, e)| (Scalar::ln(*n), Scalar::ln(*e))).collect();
    let n = points.len() as f64;
    let mean = |f: &dyn Fn(&(f64, f64)) -> f64| points.iter().map(f).sum::<f64>() / n;
    let (x, y) = (mean(&|p| p.0), mean(&|p| p.1));
    -mean(&|p| (p.0 - x) * (p.1 - y)) / mean(&|p| (p.0 - x) * (p.0 - x))
}

fn check(system: &impl System, separable: bool) {
    for candidate in METHODS {
        let card = candidate.card();
        // Above order 6 the window is too narrow in f64: the exact order conditions take over.
        if card.order > 6 || (needs_separable(*candidate) && !separable) {
            continue;
        }
        let found = order(&errors(card.id, system));
        println!("{:>14} on {:<12} {found:.3}", card.id, System::card(system).id);
        assert!(
            (found - f64::from(card.order)).abs() < 0.1,
            "{}: order {found}, not {}",
            card.id,
            card.order
        );
    }
}

#[test]
fn orders_on_a_linear_system() {
    check(&Oscillator, true);
}

#[test]
fn orders_on_a_pendulum_with_friction_and_drive() {
    check(&Driven { friction: 0.02 }, false);
}

#[test]
fn orders_on_a_driven_pendulum_without_friction() {
    check(&Driven { friction: 0.0 }, true);
}

#[test]
fn orders_on_a_planet() {
    check(&Kepler, true);
}

#[test]
fn orders_on_a_system_of_mixed_order() {
    check(&Mixed, false);
}

/// The largest error inside one step from the start, for steps 2^-k; the order of dense output is one less than
/// that of this local error.
fn dense_order(id: &str) -> f64 {
    let system = Driven { friction: 0.2 };
    let start = layout(&system).start();
    let fine = field::<DoubleDouble>(&system);
    let plain = field::<f64>(&system);
    let exact = |t: f64| {
        let mut stepper = Steps::<DoubleDouble>::stepper(method("dop853"), fine.shape(), &Options::default());
        let mut y: Vec<DoubleDouble> = start.iter().map(|x| DoubleDouble::from(*x)).collect();
        let mut next = y.clone();
        let h = DoubleDouble::from(t) / 16.0;
        for n in 0..16 {
            stepper.step(fine.as_ref(), h * f64::from(n), &y, h, &mut next).expect("explicit");
            stepper.accept();
            std::mem::swap(&mut y, &mut next);
        }
        y.iter().map(|x| x.to_f64()).collect::<Vec<_>>()
    };
    let mut errors = vec![];
    for k in 0..12 {
        let h = 2.0 * Scalar::powf(1.5, -f64::from(k));
        let mut stepper = Steps::<f64>::stepper(method(id), plain.shape(), &Options::default());
        let mut end = start.clone();
        stepper.step(plain.as_ref(), 0.0, &start, h, &mut end).expect("explicit");
        let dense = stepper.dense(plain.as_ref(), 0.0, &start, h, &end);
        let mut inside = start.clone();
        let mut worst = 0.0;
        for part in 1..8 {
            let t = h * f64::from(part) / 8.0;
            dense.at(t, &mut inside);
            for (a, b) in inside.iter().zip(exact(t)) {
                worst = Scalar::larger((a - b).abs(), worst);
            }
        }
        if (1e-12..1e-3).contains(&worst) {
            errors.push((1.0 / h, worst));
        }
    }
    order(&errors) - 1.0
}

#[test]
fn dense_output_has_its_order() {
    for (id, expected) in [("rk4", 3.0), ("dopri5", 4.0), ("dop853", 7.0)] {
        let found = dense_order(id);
        println!("{id}: dense output of order {found:.2}");
        assert!((found - expected).abs() < 0.35, "{id}: dense output of order {found}");
    }
}

#[test]
fn dense_output_is_exact_at_the_ends() {
    let system = Driven { friction: 0.2 };
    let (plain, start) = (field::<f64>(&system), layout(&system).start());
    for candidate in METHODS {
        let mut stepper = Steps::<f64>::stepper(*candidate, plain.shape(), &Options::default());
        let (mut end, mut y) = (start.clone(), start.clone());
        stepper.step(plain.as_ref(), 0.3, &start, 0.1, &mut end).expect("a small step converges");
        let dense = stepper.dense(plain.as_ref(), 0.3, &start, 0.1, &end);
        dense.at(0.3, &mut y);
        assert_eq!(y, start, "{}", candidate.card().id);
        dense.at(0.3 + 0.1, &mut y);
        assert_eq!(y, end, "{}", candidate.card().id);
    }
}
