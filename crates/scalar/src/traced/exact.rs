//! Folding that leaves every bit of every `f64` result as it is.

use super::node::{Binary, Node, Unary};
use super::recorder::Recorder;
use super::replay::{Value, compute};

/// A node that gives the same number, if there is a simpler one.
pub(super) fn fold(recorder: &mut Recorder, node: Node) -> Option<u32> {
    match node {
        Node::Unary(Unary::Neg, a) => {
            if let Node::Unary(Unary::Neg, inner) = recorder.node(a) {
                return Some(inner);
            }
        }
        Node::Binary(f, a, b) => {
            // Adding a positive zero, or 0 - x, would change the sign of a zero.
            let is = |at, x: f64| recorder.value(at).is_some_and(|y| y.to_bits() == x.to_bits());
            match f {
                Binary::Mul | Binary::Div if is(b, 1.0) => return Some(a),
                Binary::Mul if is(a, 1.0) => return Some(b),
                Binary::Sub if is(b, 0.0) => return Some(a),
                Binary::Add if is(b, -0.0) => return Some(a),
                Binary::Add if is(a, -0.0) => return Some(b),
                _ => {}
            }
        }
        Node::Not(a) => {
            if let Node::Not(inner) = recorder.node(a) {
                return Some(inner);
            }
        }
        Node::Select(_, a, b) if a == b => return Some(a),
        _ => {}
    }
    literal(recorder, node)
}

/// A number computed from numbers is computed now, by the functions a replay on `f64` would call.
fn literal(recorder: &mut Recorder, node: Node) -> Option<u32> {
    if !matches!(node, Node::Unary(..) | Node::Binary(..) | Node::Power(..)) {
        return None;
    }
    let operands: Option<Vec<f64>> = node.operands().map(|at| recorder.value(at)).collect();
    let values: Vec<Value<f64>> = operands?.into_iter().map(Value::Number).collect();
    // The operands stand at 0 and 1 now.
    let first = node.operands().next();
    let alone = node.renumbered(|at| u32::from(Some(at) != first));
    match compute(alone, &[], &values, &[]) {
        Value::Number(x) => Some(recorder.literal(x)),
        Value::Truth(_) => None,
    }
}
