//! Error bounds, defined values and the very bits of the elementary functions.

mod support;

use precess_scalar::{DoubleDouble, Scalar, elementary};
use std::f64::consts::FRAC_PI_2;
use support::{Random, error, steps};

const SAMPLES: usize = 40_000;

type Argument = fn(&mut Random) -> f64;
type Arguments = fn(&mut Random) -> (f64, f64);

/// Holds a function against its double-double twin (the true error) and against the correctly rounded one
/// (where the twin runs out of exponents). The first must stay within the bound, the second within a step.
fn measure(name: &str, bound: f64, case: impl Fn(&mut Random) -> Sample) -> f64 {
    let mut random = Random(20);
    let mut worst = 0.0;
    for _ in 0..SAMPLES {
        let Sample { x, computed, rounded, exact } = case(&mut random);
        assert!(steps(computed, rounded) <= 1, "{name}{x:?} = {computed:e}, but {rounded:e}");
        if (1e-270..1e290).contains(&rounded.abs()) {
            let error = error(computed, exact);
            assert!(error <= bound, "{name}{x:?} is {error} ulp off");
            worst = if error > worst { error } else { worst };
        }
    }
    worst
}

struct Sample {
    x: (f64, f64),
    computed: f64,
    rounded: f64,
    exact: DoubleDouble,
}

fn check(
    name: &str,
    bound: f64,
    ours: fn(f64) -> f64,
    twin: fn(DoubleDouble) -> DoubleDouble,
    rounded: fn(f64) -> f64,
    arguments: &[Argument],
) {
    let worst: Vec<String> = arguments
        .iter()
        .map(|argument| {
            let worst = measure(name, bound, |random| {
                let x = argument(random);
                let exact = twin(DoubleDouble::from(x));
                Sample { x: (x, 0.0), computed: ours(x), rounded: rounded(x), exact }
            });
            format!("{worst:.4}")
        })
        .collect();
    println!("{name:6} {} ulp", worst.join("  "));
}

fn check_pair(
    name: &str,
    bound: f64,
    ours: fn(f64, f64) -> f64,
    twin: fn(DoubleDouble, DoubleDouble) -> DoubleDouble,
    rounded: fn(f64, f64) -> f64,
    arguments: &[Arguments],
) {
    let worst: Vec<String> = arguments
        .iter()
        .map(|argument| {
            let worst = measure(name, bound, |random| {
                let (x, y) = argument(random);
                let exact = twin(DoubleDouble::from(x), DoubleDouble::from(y));
                Sample { x: (x, y), computed: ours(x, y), rounded: rounded(x, y), exact }
            });
            format!("{worst:.4}")
        })
        .collect();
    println!("{name:6} {} ulp", worst.join("  "));
}

/// A double at most two steps from `x`.
fn around(x: f64, random: &mut Random) -> f64 {
    f64::from_bits(x.to_bits().wrapping_add(random.bits() % 5).wrapping_sub(2))
}

const ANGLES: [Argument; 6] = [
    Random::finite,
    |r| r.between(-0.8, 0.8),
    |r| r.between(-10.0, 10.0),
    |r| r.between(-3e5, 3e5),
    |r| around((1 + r.bits() % 200_000) as f64 * FRAC_PI_2, r),
    |r| around((1 + r.bits() % (1 << 50)) as f64 * FRAC_PI_2, r),
];

#[test]
fn trigonometric() {
    check("sin", 1.0, |x| elementary::sin_cos(x).0, Scalar::sin, core_math::sin, &ANGLES);
    check("cos", 1.0, |x| elementary::sin_cos(x).1, Scalar::cos, core_math::cos, &ANGLES);
    check("tan", 2.0, elementary::tan, Scalar::tan, core_math::tan, &ANGLES);
}

/// The doubles nearest to multiples of pi/2, found by continued fractions (Muller, Elementary Functions,
/// chapter 11): down to `2^-60.5` for the ordinary reduction and `2^-60.9` for the huge one; and the border
/// between the two.
#[test]
fn nearest_to_multiples() {
    let nearest = [
        45.553093477052,
        91.106186954104,
        182.212373908208,
        364.424747816416,
        46066.74387591393,
        92133.48775182787,
        138200.2316277418,
        321307.9594422229,
        14461176.67027838,
        3.576149729694266e39,
        6381956970095103.0 * f64::from_bits((1023 + 797) << 52),
        1.0638745296653083e256,
        FRAC_PI_2,
        2.0 * FRAC_PI_2,
        1e22,
        262144.0,
        262143.99999999997,
    ];
    for x in nearest {
        for x in [x, -x] {
            let (sin, cos) = elementary::sin_cos(x);
            let exact = DoubleDouble::from(x);
            assert!(error(sin, exact.sin()) <= 1.0 && error(cos, exact.cos()) <= 1.0, "{x:e}");
            assert!(error(elementary::tan(x), exact.tan()) <= 2.0, "{x:e}");
            assert!(steps(cos, core_math::cos(x)) <= 1 && steps(sin, core_math::sin(x)) <= 1, "{x:e}");
        }
    }
}

#[test]
fn exponential_and_logarithm() {
    check(
        "exp",
        1.0,
        elementary::exp,
        Scalar::exp,
        core_math::exp,
        &[Random::finite, |r| r.between(-746.0, 710.0), |r| r.between(-1.0, 1.0), |r| r.between(-0.35, 0.35)],
    );
    check(
        "ln",
        1.0,
        elementary::ln,
        Scalar::ln,
        core_math::log,
        &[
            |r| r.finite().abs(),
            |r| r.between(0.5, 2.0),
            |r| r.between(0.999, 1.001),
            |r| f64::from_bits(r.bits() >> 12 >> (r.bits() % 50)),
            |r| around(1.0, r),
        ],
    );
}

/// Subnormal results have no double-double twin: they are compared with `exp(x/2)^2`, brought up by `2^1000`.
#[test]
fn subnormal_exponentials() {
    let two500 = f64::from_bits((1023 + 500) << 52);
    let mut random = Random(5);
    let mut worst = 0.0;
    for _ in 0..SAMPLES {
        let x = random.between(-745.2, -708.4);
        let root = DoubleDouble::from(x * 0.5).exp() * two500;
        let exact = root * root;
        let raised = elementary::exp(x) * two500 * two500;
        let error = (((raised - exact.hi()) - exact.lo()) / (two500 * (two500 * 5e-324))).abs();
        worst = if error > worst { error } else { worst };
        assert!(error <= 1.0, "exp({x:?}) is {error} ulp off");
    }
    println!("exp    {worst:.4} ulp where subnormal");
}

#[test]
fn arc_functions() {
    let unit: [Argument; 3] = [|r| r.between(-1.0, 1.0), |r| 1.0 - r.unit() * 1e-5, Random::finite];
    check("asin", 2.0, elementary::asin, Scalar::asin, core_math::asin, &unit);
    check("acos", 2.0, elementary::acos, Scalar::acos, core_math::acos, &unit);
    let plane: [Arguments; 3] = [
        |r| (r.finite(), r.finite()),
        |r| (r.between(-1.0, 1.0), r.between(-1.0, 1.0)),
        |r| {
            let x = r.finite();
            (x, x * r.between(-3.0, 3.0))
        },
    ];
    check_pair("atan2", 2.0, elementary::atan2, Scalar::atan2, core_math::atan2, &plane);
    check_pair("hypot", 1.0, elementary::hypot, Scalar::hypot, core_math::hypot, &plane);
}

#[test]
fn hyperbolic_functions() {
    let range: [Argument; 5] = [
        |r| r.between(-711.0, 711.0),
        |r| r.between(-1.0, 1.0),
        |r| r.between(-5.0, 5.0),
        |r| r.between(-40.0, 40.0),
        Random::finite,
    ];
    check("sinh", 2.0, elementary::sinh, Scalar::sinh, core_math::sinh, &range);
    check("cosh", 2.0, elementary::cosh, Scalar::cosh, core_math::cosh, &range);
    check("tanh", 2.0, elementary::tanh, Scalar::tanh, core_math::tanh, &range);
}

#[test]
fn powers() {
    let cubes: [Argument; 3] =
        [Random::finite, |r| r.between(-10.0, 10.0), |r| f64::from_bits(r.bits() >> 12)];
    check("cbrt", 1.0, elementary::cbrt, Scalar::cbrt, core_math::cbrt, &cubes);
    let pairs: [Arguments; 5] = [
        |r| (r.finite(), r.finite()),
        |r| {
            let x = r.finite().abs();
            (x, r.between(-745.0, 710.0) / core_math::log(x))
        },
        |r| {
            let x = r.between(0.999, 1.001);
            (x, r.between(-745.0, 710.0) / core_math::log(x))
        },
        |r| (r.between(0.1, 10.0), r.between(-10.0, 10.0)),
        |r| (r.between(-10.0, 10.0), (r.bits() % 100) as f64 - 50.0),
    ];
    check_pair("powf", 2.0, elementary::powf, Scalar::powf, core_math::pow, &pairs);
}

/// `powi` errs by at most `|n| 2^-53` of its value, and its reciprocal rule is exact.
#[test]
fn integer_powers() {
    let mut random = Random(3);
    for _ in 0..SAMPLES {
        let x = random.between(-3.0, 3.0);
        let n = (random.bits() % 81) as i32 - 40;
        let power = elementary::powi(x, n);
        let exact = DoubleDouble::from(x).powi(n);
        let relative = (((power - exact.hi()) - exact.lo()) / exact.hi()).abs();
        assert!(relative <= f64::from(n.abs()) * 1.1102230246251566e-16, "{x:?}^{n}: {relative:e}");
        assert!(n >= 0 || power == 1.0 / elementary::powi(x, -n));
    }
    assert_eq!(elementary::powi(f64::NAN, 0), 1.0);
    assert_eq!(elementary::powi(2.0, i32::MIN), 0.0);
}
