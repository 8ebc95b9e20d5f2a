//! A coefficient from those before it.

use super::rule::{Law, Rule, Start};
use crate::Scalar;
use crate::traced::replay::{binary, unary};

/// The value itself; none for what is given, or no number.
#[inline(always)]
pub(super) fn zeroth<'a, S: Scalar>(rule: Rule, row: &impl Fn(usize) -> &'a [S]) -> Option<S> {
    let at = |i: usize| row(i)[0];
    Some(match rule {
        Rule::Constant(x) => S::from(x),
        Rule::Input | Rule::Condition(_) | Rule::Choice(..) => return None,
        Rule::Sum(a, b) => at(a) + at(b),
        Rule::Difference(a, b) => at(a) - at(b),
        Rule::Negative(a) => -at(a),
        Rule::Multiple(a, x) => at(a) * x,
        Rule::Product(a, b) => at(a) * at(b),
        Rule::Square(a) => at(a).squared(),
        Rule::Quotient(a, b) => at(a) / at(b),
        Rule::Root(a) => at(a).sqrt(),
        Rule::Slope(_) => S::from(0.0),
        Rule::Function(Start::Of(f, a), _) | Rule::Value(Start::Of(f, a)) => unary(f, at(a)),
        Rule::Function(Start::Both(f, a, b), _) | Rule::Value(Start::Both(f, a, b)) => {
            binary(f, at(a), at(b))
        }
    })
}

/// A later coefficient; none for what stays or is given.
#[inline(always)]
pub(super) fn later<'a, S: Scalar>(
    rule: Rule,
    own_row: usize,
    k: usize,
    row: &impl Fn(usize) -> &'a [S],
) -> Option<S> {
    let at = |i: usize| row(i)[k];
    let order = k as f64;
    // The sum of x_j y_{k-j} over j from 1 to k, and over those between.
    let from_first = |x: usize, y: usize| convolution(&row(x)[1..=k], &row(y)[..k]);
    let between = |x: usize, y: usize| convolution(&row(x)[1..k], &row(y)[1..k]);
    Some(match rule {
        Rule::Constant(_) | Rule::Input | Rule::Value(_) | Rule::Condition(_) | Rule::Choice(..) => {
            return None;
        }
        Rule::Sum(a, b) => at(a) + at(b),
        Rule::Difference(a, b) => at(a) - at(b),
        Rule::Negative(a) => -at(a),
        Rule::Multiple(a, x) => at(a) * x,
        Rule::Product(a, b) => convolution(&row(a)[..=k], &row(b)[..=k]),
        Rule::Square(a) => square(&row(a)[..=k]),
        Rule::Quotient(a, b) => (at(a) - from_first(b, own_row)) / row(b)[0],
        Rule::Root(a) => (at(a) - square_between(&row(own_row)[..k])) / (row(own_row)[0] * 2.0),
        Rule::Slope(a) => at(a) * order,
        Rule::Function(_, Law::Partner { slope, partner, negative }) => {
            let sum = from_first(slope, partner) / order;
            if negative { -sum } else { sum }
        }
        Rule::Function(_, Law::Tangent { slope, square, negative }) => {
            let sum = from_first(slope, square);
            (if negative { at(slope) - sum } else { at(slope) + sum }) / order
        }
        Rule::Function(_, Law::Inverse { slope, below, own }) => {
            (at(slope) - between(own, below)) / (row(below)[0] * order)
        }
        Rule::Function(_, Law::Power { exponent, root, of, slope, own }) => {
            (from_first(slope, own_row) * exponent / root - between(own, of)) / (row(of)[0] * order)
        }
    })
}

/// The sum of `a_j b_{n-1-j}`: two sums, so that one addition need not wait for the other.
#[inline(always)]
pub(super) fn convolution<S: Scalar>(a: &[S], b: &[S]) -> S {
    let n = a.len();
    let (mut even, mut odd) = (S::from(0.0), S::from(0.0));
    let mut j = 0;
    while j + 1 < n {
        even = even + a[j] * b[n - 1 - j];
        odd = odd + a[j + 1] * b[n - 2 - j];
        j += 2;
    }
    if j < n {
        even = even + a[j] * b[n - 1 - j];
    }
    even + odd
}

/// The convolution of a series with itself, at its last order.
#[inline(always)]
pub(super) fn square<S: Scalar>(a: &[S]) -> S {
    let n = a.len();
    let half = n / 2;
    let twice = convolution(&a[..half], &a[n - half..]) * 2.0;
    if n % 2 == 1 { twice + a[half].squared() } else { twice }
}

/// The same without its ends, of a series that lacks its last term.
#[inline(always)]
pub(super) fn square_between<S: Scalar>(a: &[S]) -> S {
    if a.len() < 2 { S::from(0.0) } else { square(&a[1..]) }
}
