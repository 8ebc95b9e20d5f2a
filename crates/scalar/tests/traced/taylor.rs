//! Taylor coefficients against the functions themselves.

use precess_scalar::{DoubleDouble, Scalar, Tape, Taylor, Traced};

const ORDER: usize = 30;

/// `x' = 1, y' = f(x)` from x = 0.4: the rate of y inside a step, by its series, is f.
fn check(name: &str, f: impl Fn(Traced) -> Traced, g: impl Fn(DoubleDouble) -> DoubleDouble) {
    let tape = Tape::record(3, |x| vec![Traced::from(1.0), f(x[1])]);
    let mut series = Taylor::<DoubleDouble>::new(&tape, ORDER).expect(name);
    let (start, h) = (DoubleDouble::from(0.4), DoubleDouble::from(0.03125));
    series.expand(DoubleDouble::from(0.0), &[start, DoubleDouble::from(0.0)]);
    let rates = series.of(1)[1..].iter().enumerate().map(|(k, c)| *c * (k + 1) as f64);
    let sum = rates.rev().fold(DoubleDouble::from(0.0), |sum, c| sum * h + c);
    let error = (sum - g(start + h)).to_f64();
    println!("{name:<10} {error:.1e}");
    assert!(error.abs() < 1e-28, "{name}: {error:e}");
}

#[test]
fn every_function_has_its_series() {
    check("sin", Scalar::sin, Scalar::sin);
    check("cos", Scalar::cos, Scalar::cos);
    check("both", |x| x.sin() * x.cos(), |x| x.sin() * x.cos());
    check("tan", Scalar::tan, Scalar::tan);
    check("asin", Scalar::asin, Scalar::asin);
    check("acos", Scalar::acos, Scalar::acos);
    check("exp", Scalar::exp, Scalar::exp);
    check("ln", Scalar::ln, Scalar::ln);
    check("sinh", Scalar::sinh, Scalar::sinh);
    check("cosh", Scalar::cosh, Scalar::cosh);
    check("tanh", Scalar::tanh, Scalar::tanh);
    check("sqrt", Scalar::sqrt, Scalar::sqrt);
    check("cbrt", Scalar::cbrt, Scalar::cbrt);
    check("powi", |x| x.powi(7) + x.powi(-3) + x.powi(0), |x| x.powi(7) + x.powi(-3) + 1.0);
    check("powf", |x| x.powf(Traced::from(1.5)), |x| x * x.sqrt());
    check("to itself", |x| x.powf(x), |x| (x * x.ln()).exp());
    check("hypot", |x| x.hypot(x * x), |x| (x * x + x.powi(4)).sqrt());
    check("atan2", |x| x.atan2(x * x + 0.5), |x| x.atan2(x * x + 0.5));
    check("algebra", |x| (-x + 2.0) / (x * 3.0 - 7.0) - x / 4.0, |x| (-x + 2.0) / (x * 3.0 - 7.0) - x / 4.0);
}

/// A choice between cases is that of the start.
#[test]
fn a_choice_has_the_series_of_its_case() {
    let tape = Tape::record(2, |x| vec![Traced::select(x[1].abs().lt(Traced::from(1.0)), x[1], -x[1])]);
    let mut series = Taylor::<f64>::new(&tape, 3).unwrap();
    series.expand(0.0, &[-0.5]);
    assert_eq!(series.of(0), [-0.5, -0.5, -0.25, -0.25 / 3.0]);
    series.expand(0.0, &[-1.5]);
    assert_eq!(series.of(0), [-1.5, 1.5, -0.75, 0.25]);
}

/// Powers of whole exponent need no base that is not zero.
#[test]
fn a_square_has_its_series_at_zero() {
    let tape = Tape::record(2, |x| vec![x[1].powi(2) + x[0].powi(3) + 1.0]);
    let mut series = Taylor::<f64>::new(&tape, 7).unwrap();
    series.expand(0.0, &[0.0]);
    // y' = 1 + y^2 + t^3: the tangent, and t^4 / 4.
    assert_eq!(series.of(0), [0.0, 1.0, 0.0, 1.0 / 3.0, 0.25, 2.0 / 15.0, 0.25 / 3.0, series.of(0)[7]]);
}

#[test]
fn what_has_no_series_is_refused() {
    let refusal = |f: fn(Traced) -> Traced| Taylor::<f64>::new(&Tape::record(2, |x| vec![f(x[1])]), 4).err();
    assert_eq!(refusal(Scalar::abs), Some("an absolute value"));
    assert_eq!(refusal(Scalar::sign), Some("a sign"));
    assert_eq!(refusal(|x| x.larger(x * x)), Some("the larger or smaller of two"));
    assert_eq!(refusal(|x| Traced::select(x.abs().lt(x * x), x, -x)), None);
    assert_eq!(refusal(|x| x * x), None);
}
