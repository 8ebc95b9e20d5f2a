//! What the operations of a tape say about coefficients.

use crate::traced::node::{Binary, Unary};

/// How a coefficient follows. Rows are named by their place; those of higher places are asked for lower orders only.
#[derive(Clone, Copy, Debug)]
pub(super) enum Rule {
    /// The same for ever.
    Constant(f64),
    /// Time and the state.
    Input,
    Sum(usize, usize),
    Difference(usize, usize),
    Negative(usize),
    /// Times a literal.
    Multiple(usize, f64),
    Product(usize, usize),
    Square(usize),
    Quotient(usize, usize),
    Root(usize),
    /// `k x_k`.
    Slope(usize),
    /// The function is at order zero what its name says; later:
    Function(Start, Law),
    /// A number that only conditions ask for: its value will do.
    Value(Start),
    /// A truth value.
    Condition(Condition),
    /// The second where the condition of the first row holds, else the third.
    Choice(usize, usize, usize),
}

/// Order zero of a function.
#[derive(Clone, Copy, Debug)]
pub(super) enum Start {
    Of(Unary, usize),
    Both(Binary, usize, usize),
}

/// What holds at order zero.
#[derive(Clone, Copy, Debug)]
pub(super) enum Condition {
    Less(usize, usize),
    LessOrEqual(usize, usize),
    And(usize, usize),
    Or(usize, usize),
    Not(usize),
}

/// The differential equation of a function y of x. `slope` is the row of the slope of x, `own` that of y.
#[derive(Clone, Copy, Debug)]
pub(super) enum Law {
    /// `y' = z x'`, with z the partner, or its negative: exponential, sine and cosine, hyperbolic ones.
    Partner { slope: usize, partner: usize, negative: bool },
    /// `y' = (1 + y^2) x'`, or with a minus, from the square of y: the tangents.
    Tangent { slope: usize, square: usize, negative: bool },
    /// `w y' = x'`, with w below: logarithm and inverse functions.
    Inverse { slope: usize, below: usize, own: usize },
    /// `r x y' = e y x'`: the power `e / r`.
    Power { exponent: f64, root: f64, of: usize, slope: usize, own: usize },
}
