//! Running a tape on numbers.

use super::Tape;
use super::node::{Binary, Node, Unary};
use crate::Scalar;

/// What a node gave.
#[derive(Clone, Copy)]
pub(super) enum Value<S: Scalar> {
    Number(S),
    Truth(S::Mask),
}

/// The intermediate values of a replay, kept so that a loop of replays does not allocate.
#[derive(Clone)]
pub struct Workspace<S: Scalar> {
    values: Vec<Value<S>>,
}

impl<S: Scalar> Default for Workspace<S> {
    fn default() -> Self {
        Self { values: Vec::new() }
    }
}

impl Tape {
    /// The outputs for these inputs.
    ///
    /// The operations are those of the recorded function in an order that changes nothing, so on `f64` the
    /// results are those of the function itself, to the bit (except for the payload of a NaN).
    ///
    /// # Panics
    /// If the number of inputs is not the one recorded.
    pub fn evaluate<S: Scalar>(&self, inputs: &[S]) -> Vec<S> {
        self.evaluate_with(inputs, |_, _| ())
    }

    /// As [`evaluate`](Self::evaluate), calling `after` behind every node with its position and its value (none
    /// for a comparison).
    ///
    /// # Panics
    /// If the number of inputs is not the one recorded.
    pub fn evaluate_with<S: Scalar>(&self, inputs: &[S], after: impl FnMut(usize, Option<&S>)) -> Vec<S> {
        let mut workspace = Workspace::default();
        self.run(&mut workspace, inputs, after);
        self.outputs.iter().map(|&at| number(&workspace.values, at)).collect()
    }

    /// As [`evaluate`](Self::evaluate), into `outputs` and without allocating once the workspace has grown.
    ///
    /// # Panics
    /// If the number of inputs or outputs is not the one recorded.
    pub fn evaluate_into<S: Scalar>(&self, workspace: &mut Workspace<S>, inputs: &[S], outputs: &mut [S]) {
        assert_eq!(outputs.len(), self.outputs.len(), "a tape was asked for another number of outputs");
        self.run(workspace, inputs, |_, _| ());
        for (output, &at) in outputs.iter_mut().zip(&self.outputs) {
            *output = number(&workspace.values, at);
        }
    }

    fn run<S: Scalar>(
        &self,
        workspace: &mut Workspace<S>,
        inputs: &[S],
        mut after: impl FnMut(usize, Option<&S>),
    ) {
        assert_eq!(inputs.len(), self.inputs, "a tape was given another number of inputs");
        let values = &mut workspace.values;
        values.clear();
        values.reserve(self.nodes.len());
        while let Some(&node) = self.nodes.get(values.len()) {
            let first = values.len();
            match (node, self.nodes.get(first + 1)) {
                // Sine and cosine of one angle stand side by side and share the argument reduction.
                (Node::Unary(Unary::Sin, a), Some(&Node::Unary(Unary::Cos, b))) if a == b => {
                    let (sin, cos) = number(values, a).sin_cos();
                    values.extend([Value::Number(sin), Value::Number(cos)]);
                }
                _ => values.push(compute(node, &self.nodes, values, inputs)),
            }
            for (at, value) in values.iter().enumerate().skip(first) {
                match value {
                    Value::Number(x) => after(at, Some(x)),
                    Value::Truth(_) => after(at, None),
                }
            }
        }
    }
}

fn number<S: Scalar>(values: &[Value<S>], at: u32) -> S {
    match values[at as usize] {
        Value::Number(x) => x,
        Value::Truth(_) => unreachable!("a condition is not a number: their types differ while recording"),
    }
}

fn truth<S: Scalar>(values: &[Value<S>], at: u32) -> S::Mask {
    match values[at as usize] {
        Value::Truth(mask) => mask,
        Value::Number(_) => unreachable!("a number is not a condition: their types differ while recording"),
    }
}

/// One operation; `nodes` tells which operands are literals.
pub(super) fn compute<S: Scalar>(node: Node, nodes: &[Node], values: &[Value<S>], inputs: &[S]) -> Value<S> {
    let at = |i| number(values, i);
    let holds = |i| truth(values, i);
    Value::Number(match node {
        Node::Constant(bits) => S::from(f64::from_bits(bits)),
        Node::Input(i) => inputs[i as usize],
        Node::Unary(f, a) => unary(f, at(a)),
        Node::Binary(f, a, b) => match nodes.get(b as usize) {
            Some(&Node::Constant(bits)) => with_literal(f, at(a), f64::from_bits(bits)),
            _ => binary(f, at(a), at(b)),
        },
        Node::Power(a, n) => at(a).powi(n),
        Node::Select(mask, a, b) => S::select(holds(mask), at(a), at(b)),
        Node::Less(a, b) => return Value::Truth(at(a).lt(at(b))),
        Node::LessOrEqual(a, b) => return Value::Truth(at(a).le(at(b))),
        Node::And(a, b) => return Value::Truth(holds(a) & holds(b)),
        Node::Or(a, b) => return Value::Truth(holds(a) | holds(b)),
        Node::Not(a) => return Value::Truth(!holds(a)),
    })
}

#[inline(always)]
pub(super) fn unary<S: Scalar>(f: Unary, x: S) -> S {
    match f {
        Unary::Neg => -x,
        Unary::Sqrt => x.sqrt(),
        Unary::Sin => x.sin(),
        Unary::Cos => x.cos(),
        Unary::Tan => x.tan(),
        Unary::Asin => x.asin(),
        Unary::Acos => x.acos(),
        Unary::Exp => x.exp(),
        Unary::Ln => x.ln(),
        Unary::Sinh => x.sinh(),
        Unary::Cosh => x.cosh(),
        Unary::Tanh => x.tanh(),
        Unary::Cbrt => x.cbrt(),
        Unary::Abs => x.abs(),
        Unary::Sign => x.sign(),
    }
}

#[inline(always)]
pub(super) fn binary<S: Scalar>(f: Binary, x: S, y: S) -> S {
    match f {
        Binary::Add => x + y,
        Binary::Sub => x - y,
        Binary::Mul => x * y,
        Binary::Div => x / y,
        Binary::Atan2 => x.atan2(y),
        Binary::Powf => x.powf(y),
        Binary::Hypot => x.hypot(y),
        Binary::Larger => x.larger(y),
        Binary::Smaller => x.smaller(y),
    }
}

/// `x * 0.5` costs a dual number two products; with 0.5 as a dual number it would cost three.
fn with_literal<S: Scalar>(f: Binary, x: S, y: f64) -> S {
    match f {
        Binary::Add => x + y,
        Binary::Sub => x - y,
        Binary::Mul => x * y,
        Binary::Div => x / y,
        _ => binary(f, x, S::from(y)),
    }
}
