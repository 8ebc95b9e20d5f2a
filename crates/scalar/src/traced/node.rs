//! One operation of a recorded expression.

/// An operation; its operands are positions of earlier nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(in crate::traced) enum Node {
    /// A literal, by its bits, so that two zeros differ and a NaN equals itself.
    Constant(u64),
    Input(u32),
    Unary(Unary, u32),
    Binary(Binary, u32, u32),
    Power(u32, i32),
    // These four give a truth value ...
    Less(u32, u32),
    LessOrEqual(u32, u32),
    And(u32, u32),
    Or(u32, u32),
    Not(u32),
    /// ... which this one takes first.
    Select(u32, u32, u32),
}

/// What takes one number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Unary {
    Neg,
    Sqrt,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Exp,
    Ln,
    Sinh,
    Cosh,
    Tanh,
    Cbrt,
    Abs,
    Sign,
}

/// What takes two.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Binary {
    Add,
    Sub,
    Mul,
    Div,
    Atan2,
    Powf,
    Hypot,
    Larger,
    Smaller,
}

impl Node {
    pub(super) fn constant(x: f64) -> Self {
        Self::Constant(x.to_bits())
    }

    /// The nodes it is computed from, in order.
    pub(super) fn operands(self) -> impl Iterator<Item = u32> {
        let operands = match self {
            Self::Constant(_) | Self::Input(_) => [None; 3],
            Self::Unary(_, a) | Self::Power(a, _) | Self::Not(a) => [Some(a), None, None],
            Self::Binary(_, a, b)
            | Self::Less(a, b)
            | Self::LessOrEqual(a, b)
            | Self::And(a, b)
            | Self::Or(a, b) => [Some(a), Some(b), None],
            Self::Select(mask, a, b) => [Some(mask), Some(a), Some(b)],
        };
        operands.into_iter().flatten()
    }

    /// The same operation on other nodes.
    pub(super) fn renumbered(self, at: impl Fn(u32) -> u32) -> Self {
        match self {
            Self::Constant(_) | Self::Input(_) => self,
            Self::Unary(f, a) => Self::Unary(f, at(a)),
            Self::Power(a, n) => Self::Power(at(a), n),
            Self::Not(a) => Self::Not(at(a)),
            Self::Binary(f, a, b) => Self::Binary(f, at(a), at(b)),
            Self::Less(a, b) => Self::Less(at(a), at(b)),
            Self::LessOrEqual(a, b) => Self::LessOrEqual(at(a), at(b)),
            Self::And(a, b) => Self::And(at(a), at(b)),
            Self::Or(a, b) => Self::Or(at(a), at(b)),
            Self::Select(mask, a, b) => Self::Select(at(mask), at(a), at(b)),
        }
    }

    /// What it is looked up by: `a + b` and `b + a` are one node, written as it first was.
    pub(super) fn key(self) -> Self {
        match self {
            Self::Binary(f @ (Binary::Add | Binary::Mul), a, b) => Self::Binary(f, a.min(b), a.max(b)),
            other => other,
        }
    }

    /// Whether it computes something, rather than being given.
    pub(super) fn is_operation(self) -> bool {
        !matches!(self, Self::Constant(_) | Self::Input(_))
    }
}
