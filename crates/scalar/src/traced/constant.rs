//! How a number is written: as an integer, a short decimal, a multiple of pi, a fraction or a root.

use super::Notation;
use super::product::Base;
use crate::Scalar;
use std::f64::consts::PI;

/// Decimals up to this length are nobody's rounded fraction.
const SHORT: usize = 6;

/// A positive number as a quotient of symbols; `(vec![Number(x)], vec![])` where nothing shorter is known.
///
/// Anything else is written only if its quotient has exactly the bits of `x`.
pub(super) fn written(x: f64, notation: Notation) -> (Vec<Base>, Vec<Base>) {
    // A half is a fraction on paper and a decimal on a calculator.
    if notation == Notation::Latex && [0.25, 0.5, 0.75, 1.5].contains(&x) {
        let below = if x % 0.5 == 0.0 { 2.0 } else { 4.0 };
        return quotient(&[], x * below, below);
    }
    if !x.is_finite() || digits(x) <= SHORT {
        return (vec![Base::Number(x)], Vec::new());
    }
    multiple_of_pi(x)
        .or_else(|| fraction(x))
        .or_else(|| root(x))
        .unwrap_or((vec![Base::Number(x)], Vec::new()))
}

/// `p / q` times what stands above, in lowest terms and without ones.
fn quotient(above: &[Base], p: f64, q: f64) -> (Vec<Base>, Vec<Base>) {
    let shared = divisor(p, q);
    let number = |x: f64| (x != shared).then_some(Base::Number(x / shared));
    (number(p).into_iter().chain(above.iter().copied()).collect(), number(q).into_iter().collect())
}

fn multiple_of_pi(x: f64) -> Option<(Vec<Base>, Vec<Base>)> {
    let q = [1.0, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 180.0];
    q.into_iter().find_map(|q| {
        let p = (x / PI * q).round();
        let fits = (1.0..=99.0).contains(&p) && (p * PI / q == x || PI / q * p == x);
        fits.then(|| quotient(&[Base::Pi], p, q))
    })
}

fn fraction(x: f64) -> Option<(Vec<Base>, Vec<Base>)> {
    (2..100).map(f64::from).find_map(|q| {
        let p = (x * q).round();
        let fits = (1.0..1000.0).contains(&p) && p / q == x;
        fits.then(|| quotient(&[], p, q))
    })
}

fn root(x: f64) -> Option<(Vec<Base>, Vec<Base>)> {
    (1..=4).map(f64::from).find_map(|q| {
        let n = (x * x * q * q).round();
        let fits = (2.0..100.0).contains(&n) && Scalar::sqrt(n) / q == x;
        fits.then(|| quotient(&[Base::Root(n as u32)], 1.0, q))
    })
}

/// The greatest common divisor of two positive integers.
pub(super) fn divisor(p: f64, q: f64) -> f64 {
    if q == 0.0 { p } else { divisor(q, p % q) }
}

/// How many digits its shortest decimal has.
fn digits(x: f64) -> usize {
    let all = format!("{x:e}");
    all.split('e').next().map_or(0, |mantissa| mantissa.bytes().filter(u8::is_ascii_digit).count())
}

/// Multiplies numbers as long as that makes them no longer: `2 * 3` becomes 6, `0.1 * 3` stays.
pub(super) fn merged(factors: &[f64]) -> Vec<f64> {
    let mut merged: Vec<f64> = Vec::new();
    for &x in factors {
        match merged.iter_mut().find(|y| tidy(**y, x)) {
            Some(y) => *y *= x,
            None => merged.push(x),
        }
    }
    merged.retain(|&x| x != 1.0);
    merged
}

fn tidy(x: f64, y: f64) -> bool {
    let product = x * y;
    let short = digits(product) <= digits(x).max(SHORT) && digits(product) <= digits(x) + digits(y);
    product.is_normal() && (short && digits(product) <= SHORT || multiple_of_pi(product).is_some())
}

/// The shortest decimal that gives the same bits, with a power of ten where zeros would have to be counted.
pub(super) fn decimal(x: f64, notation: Notation) -> String {
    if x.is_nan() {
        return if notation == Notation::Text { "NaN" } else { r"\mathrm{NaN}" }.into();
    }
    if x.is_infinite() {
        return if notation == Notation::Text { "inf" } else { r"\infty" }.into();
    }
    let scientific = format!("{x:e}");
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    if x == 0.0 || (1e-4..1e7).contains(&x) || (x.trunc() == x && x < 1e15 && digits(x) > SHORT) {
        return format!("{x}");
    }
    match notation {
        Notation::Text => scientific,
        Notation::Latex if mantissa == "1" => format!("10^{{{exponent}}}"),
        Notation::Latex => format!(r"{mantissa} \times 10^{{{exponent}}}"),
    }
}
