//! Folding that is true of real numbers: for reading, not for computing.
//!
//! `0 x = 0` forgets an infinite `x`, and a rounding or the sign of a zero may change.

use super::node::{Binary, Node, Unary};
use super::recorder::Recorder;
use Binary::{Add, Div, Hypot, Larger, Mul, Powf, Smaller, Sub};
use Unary::{Abs, Asin, Cbrt, Cos, Cosh, Neg, Sign, Sin, Sinh, Sqrt, Tan, Tanh};

/// A node equal to this one in algebra, if there is a simpler one.
pub(super) fn fold(r: &mut Recorder, node: Node) -> Option<u32> {
    match node {
        Node::Unary(f, a) => unary(r, f, a),
        Node::Binary(Add, a, b) => sum(r, a, b),
        Node::Binary(Sub, a, b) => difference(r, a, b),
        Node::Binary(Mul, a, b) => product(r, a, b),
        Node::Binary(Div, a, b) => quotient(r, a, b),
        Node::Binary(Powf, a, b) => real_power(r, a, b),
        Node::Binary(Larger | Smaller, a, b) => (a == b).then_some(a),
        Node::Binary(Hypot, a, b) => match (r.value(a), r.value(b)) {
            (_, Some(0.0)) => Some(r.push(Node::Unary(Abs, a))),
            (Some(0.0), _) => Some(r.push(Node::Unary(Abs, b))),
            _ => None,
        },
        Node::Power(a, n) => power(r, a, n),
        Node::Select(mask, a, b) => truth(r, mask).map(|holds| if holds { a } else { b }),
        _ => None,
    }
}

/// What a node is the negative of.
fn negated(r: &Recorder, at: u32) -> Option<u32> {
    match r.node(at) {
        Node::Unary(Neg, inner) => Some(inner),
        _ => None,
    }
}

fn negative(r: &mut Recorder, node: Node) -> u32 {
    let inner = r.push(node);
    r.push(Node::Unary(Neg, inner))
}

fn unary(r: &mut Recorder, f: Unary, a: u32) -> Option<u32> {
    if f == Neg {
        return match r.node(a) {
            Node::Binary(Sub, x, y) => Some(r.push(Node::Binary(Sub, y, x))),
            _ => None,
        };
    }
    let inner = negated(r, a)?;
    match f {
        Sin | Tan | Asin | Sinh | Tanh | Cbrt | Sign => Some(negative(r, Node::Unary(f, inner))),
        Cos | Cosh | Abs => Some(r.push(Node::Unary(f, inner))),
        _ => None,
    }
}

fn sum(r: &mut Recorder, a: u32, b: u32) -> Option<u32> {
    if r.value(a) == Some(0.0) {
        return Some(b);
    }
    if r.value(b) == Some(0.0) {
        return Some(a);
    }
    if a == b {
        let two = r.literal(2.0);
        return Some(r.push(Node::Binary(Mul, two, a)));
    }
    // `-x + 1`, which a literal on the right forces on us, reads `1 - x`.
    if let (Some(inner), Some(_)) = (negated(r, a), r.value(b)) {
        return Some(r.push(Node::Binary(Sub, b, inner)));
    }
    negated(r, b).map(|inner| r.push(Node::Binary(Sub, a, inner)))
}

fn difference(r: &mut Recorder, a: u32, b: u32) -> Option<u32> {
    if a == b {
        return Some(r.literal(0.0));
    }
    if r.value(b) == Some(0.0) {
        return Some(a);
    }
    if r.value(a) == Some(0.0) {
        return Some(r.push(Node::Unary(Neg, b)));
    }
    negated(r, b).map(|inner| r.push(Node::Binary(Add, a, inner)))
}

fn product(r: &mut Recorder, a: u32, b: u32) -> Option<u32> {
    for (one, other) in [(a, b), (b, a)] {
        match r.value(one) {
            Some(0.0) => return Some(r.literal(0.0)),
            Some(-1.0) => return Some(r.push(Node::Unary(Neg, other))),
            _ => {}
        }
        if let Some(inner) = negated(r, one) {
            let (left, right) = if one == a { (inner, other) } else { (other, inner) };
            return Some(negative(r, Node::Binary(Mul, left, right)));
        }
        if let Node::Binary(Div, unit, below) = r.node(one)
            && r.value(unit) == Some(1.0)
        {
            return Some(r.push(Node::Binary(Div, other, below)));
        }
    }
    (a == b).then(|| r.push(Node::Power(a, 2)))
}

fn quotient(r: &mut Recorder, a: u32, b: u32) -> Option<u32> {
    if a == b {
        return Some(r.literal(1.0));
    }
    if r.value(a) == Some(0.0) {
        return Some(a);
    }
    if r.value(b) == Some(-1.0) {
        return Some(r.push(Node::Unary(Neg, a)));
    }
    if let Some(inner) = negated(r, a) {
        return Some(negative(r, Node::Binary(Div, inner, b)));
    }
    negated(r, b).map(|inner| negative(r, Node::Binary(Div, a, inner)))
}

fn power(r: &mut Recorder, a: u32, n: i32) -> Option<u32> {
    match n {
        0 => return Some(r.literal(1.0)),
        1 => return Some(a),
        _ => {}
    }
    let inner = negated(r, a)?;
    let power = Node::Power(inner, n);
    Some(if n % 2 == 0 { r.push(power) } else { negative(r, power) })
}

fn real_power(r: &mut Recorder, a: u32, exponent: u32) -> Option<u32> {
    let exponent = r.value(exponent)?;
    if exponent == 0.5 {
        return Some(r.push(Node::Unary(Sqrt, a)));
    }
    let whole = exponent.abs() <= 64.0 && exponent.trunc() == exponent;
    whole.then(|| r.push(Node::Power(a, exponent as i32)))
}

/// A condition between literals.
fn truth(r: &Recorder, mask: u32) -> Option<bool> {
    match r.node(mask) {
        Node::Less(a, b) => Some(r.value(a)? < r.value(b)?),
        Node::LessOrEqual(a, b) => Some(r.value(a)? <= r.value(b)?),
        Node::Not(a) => truth(r, a).map(|holds| !holds),
        Node::And(a, b) => Some(truth(r, a)? & truth(r, b)?),
        Node::Or(a, b) => Some(truth(r, a)? | truth(r, b)?),
        _ => None,
    }
}
