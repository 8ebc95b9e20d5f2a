//! Values at zeros, infinities and NaN: those of C99, Annex F.

mod support;

use precess_scalar::elementary::{
    acos, asin, atan2, cbrt, cosh, exp, hypot, ln, powf, powi, sin_cos, sinh, tan, tanh,
};
use support::SPECIAL;

const INF: f64 = f64::INFINITY;

/// Equal with the sign of zero; any NaN equals any other.
fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan()
}

#[track_caller]
fn table(name: &str, function: fn(f64) -> f64, rows: &[(f64, f64)]) {
    for (x, value) in rows {
        assert!(same(function(*x), *value), "{name}({x:?}) is {:?}, not {value:?}", function(*x));
    }
    assert!(function(f64::NAN).is_nan(), "{name}(NaN)");
}

#[test]
fn of_one_argument() {
    let nan = f64::NAN;
    let odd = [(0.0, 0.0), (-0.0, -0.0), (5e-324, 5e-324), (-5e-324, -5e-324)];
    for (name, function) in [
        ("sin", (|x| sin_cos(x).0) as fn(f64) -> f64),
        ("tan", tan),
        ("asin", asin),
        ("sinh", sinh),
        ("tanh", tanh),
    ] {
        table(name, function, &odd);
    }
    table("sin", |x| sin_cos(x).0, &[(INF, nan), (-INF, nan)]);
    table("cos", |x| sin_cos(x).1, &[(0.0, 1.0), (-0.0, 1.0), (INF, nan), (-INF, nan)]);
    table("tan", tan, &[(INF, nan), (-INF, nan)]);
    table("exp", exp, &[(0.0, 1.0), (-0.0, 1.0), (INF, INF), (-INF, 0.0), (709.8, INF), (-745.2, 0.0)]);
    table("ln", ln, &[(0.0, -INF), (-0.0, -INF), (1.0, 0.0), (INF, INF), (-1.0, nan), (-INF, nan)]);
    let (right, straight) = (std::f64::consts::FRAC_PI_2, std::f64::consts::PI);
    table("asin", asin, &[(1.0, right), (-1.0, -right), (1.0000000000000002, nan), (INF, nan), (-INF, nan)]);
    table(
        "acos",
        acos,
        &[(1.0, 0.0), (-1.0, straight), (0.0, right), (-1.0000000000000002, nan), (INF, nan)],
    );
    table("sinh", sinh, &[(INF, INF), (-INF, -INF), (711.0, INF)]);
    table("cosh", cosh, &[(0.0, 1.0), (-0.0, 1.0), (INF, INF), (-INF, INF), (-711.0, INF)]);
    table("tanh", tanh, &[(INF, 1.0), (-INF, -1.0), (30.0, 1.0)]);
    table("cbrt", cbrt, &[(0.0, 0.0), (-0.0, -0.0), (INF, INF), (-INF, -INF), (-8.0, -2.0), (27.0, 3.0)]);
}

/// Where the correctly rounded functions are exact or special, ours agree with them; elsewhere a step.
#[test]
fn of_two_arguments() {
    for y in SPECIAL {
        for x in SPECIAL {
            for (name, ours, theirs) in [
                ("atan2", atan2(y, x), core_math::atan2(y, x)),
                ("powf", powf(y, x), core_math::pow(y, x)),
                ("hypot", hypot(y, x), core_math::hypot(y, x)),
            ] {
                let special = !theirs.is_finite() || theirs == 0.0 || theirs == 1.0;
                let close = support::steps(ours, theirs) <= u64::from(!special);
                let signs = ours.is_nan() || ours.is_sign_negative() == theirs.is_sign_negative();
                assert!(close && signs, "{name}({y:?}, {x:?}) is {ours:?}, not {theirs:?}");
            }
        }
    }
    assert_eq!(hypot(INF, f64::NAN), INF);
    assert_eq!(hypot(f64::NAN, -INF), INF);
    assert_eq!(powf(1.0, f64::NAN), 1.0);
    assert_eq!(powf(f64::NAN, 0.0), 1.0);
    assert_eq!(powf(-1.0, INF), 1.0);
    assert!(same(powf(-0.0, -3.0), -INF) && same(powf(-0.0, 3.0), -0.0) && same(powf(-INF, -3.0), -0.0));
    assert!(powf(-2.0, 0.5).is_nan() && powf(-INF, 0.5) == INF && powf(-0.0, 0.5).to_bits() == 0);
    assert_eq!(hypot(3.0, -4.0), 5.0);
}

#[test]
fn of_integer_powers() {
    assert_eq!(powi(f64::NAN, 0), 1.0);
    assert_eq!(powi(0.0, 0), 1.0);
    assert!(same(powi(-0.0, -3), -INF) && same(powi(-0.0, 3), -0.0) && same(powi(-INF, -3), -0.0));
    assert_eq!(powi(2.0, i32::MIN), 0.0);
    assert_eq!(powi(-1.0, i32::MAX), -1.0);
    assert_eq!(powi(10.0, 15), 1e15);
}
