//! The number that records.

use super::node::{Binary, Node, Unary};
use super::recorder::{self, Recorder};
use crate::Scalar;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// A number of a recording in progress; see [`Tape::record`](super::Tape::record).
///
/// It is a position on the tape that the innermost recording of this thread writes. Using it after that
/// recording, or inside another, is a mistake in the program and panics.
#[derive(Clone, Copy, Debug)]
pub struct Traced(Place);

/// A truth value of a recording in progress.
#[derive(Clone, Copy, Debug)]
pub struct Condition(Place);

#[derive(Clone, Copy, Debug)]
struct Place {
    recording: u32,
    node: u32,
}

impl Place {
    fn on(self, recorder: &Recorder) -> u32 {
        assert!(
            self.recording == recorder.serial,
            "a traced number was used in another recording than its own"
        );
        self.node
    }
}

/// Records the node that `operation` builds from the operands' positions.
fn record<const N: usize>(operands: [Place; N], operation: impl FnOnce([u32; N]) -> Node) -> Place {
    recorder::with(|recorder| {
        let node = operation(operands.map(|place| place.on(recorder)));
        Place { recording: recorder.serial, node: recorder.push(node) }
    })
}

impl Traced {
    pub(super) fn input(i: usize) -> Self {
        Self(record([], |[]| Node::Input(i as u32)))
    }
    /// Its position on the tape that records now.
    pub(super) fn position(self) -> u32 {
        recorder::with(|recorder| self.0.on(recorder))
    }
    fn unary(self, f: Unary) -> Self {
        Self(record([self.0], |[a]| Node::Unary(f, a)))
    }
    fn binary(self, f: Binary, o: Self) -> Self {
        Self(record([self.0, o.0], |[a, b]| Node::Binary(f, a, b)))
    }
}

impl From<f64> for Traced {
    fn from(x: f64) -> Self {
        Self(record([], |[]| Node::constant(x)))
    }
}
impl Neg for Traced {
    type Output = Self;
    fn neg(self) -> Self {
        self.unary(Unary::Neg)
    }
}
macro_rules! operators {
    ($($operation:ident $method:ident),*) => {$(
        impl $operation for Traced {
            type Output = Self;
            fn $method(self, o: Self) -> Self {
                self.binary(Binary::$operation, o)
            }
        }
        impl $operation<f64> for Traced {
            type Output = Self;
            fn $method(self, o: f64) -> Self {
                self.binary(Binary::$operation, Self::from(o))
            }
        }
    )*};
}
operators!(Add add, Sub sub, Mul mul, Div div);

impl BitAnd for Condition {
    type Output = Self;
    fn bitand(self, o: Self) -> Self {
        Self(record([self.0, o.0], |[a, b]| Node::And(a, b)))
    }
}
impl BitOr for Condition {
    type Output = Self;
    fn bitor(self, o: Self) -> Self {
        Self(record([self.0, o.0], |[a, b]| Node::Or(a, b)))
    }
}
impl Not for Condition {
    type Output = Self;
    fn not(self) -> Self {
        Self(record([self.0], |[a]| Node::Not(a)))
    }
}

macro_rules! unary {
    ($($method:ident $function:ident),* $(,)?) => {$(
        fn $method(self) -> Self {
            self.unary(Unary::$function)
        }
    )*};
}
macro_rules! binary {
    ($($method:ident $function:ident),* $(,)?) => {$(
        fn $method(self, o: Self) -> Self {
            self.binary(Binary::$function, o)
        }
    )*};
}

impl Scalar for Traced {
    type Mask = Condition;
    type Abreast = Self;

    fn lt(self, o: Self) -> Condition {
        Condition(record([self.0, o.0], |[a, b]| Node::Less(a, b)))
    }
    fn le(self, o: Self) -> Condition {
        Condition(record([self.0, o.0], |[a, b]| Node::LessOrEqual(a, b)))
    }
    fn select(mask: Condition, a: Self, b: Self) -> Self {
        Self(record([mask.0, a.0, b.0], |[mask, a, b]| Node::Select(mask, a, b)))
    }
    fn sin_cos(self) -> (Self, Self) {
        (self.sin(), self.cos())
    }
    fn powi(self, n: i32) -> Self {
        Self(record([self.0], |[a]| Node::Power(a, n)))
    }
    unary!(sin Sin, cos Cos, tan Tan, asin Asin, acos Acos, sinh Sinh, cosh Cosh, tanh Tanh);
    unary!(sqrt Sqrt, cbrt Cbrt, exp Exp, ln Ln, abs Abs, sign Sign);
    binary!(atan2 Atan2, powf Powf, hypot Hypot, larger Larger, smaller Smaller);
}
