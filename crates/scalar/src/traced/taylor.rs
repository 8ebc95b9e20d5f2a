//! The Taylor coefficients of the solution of a differential equation, from its recorded right-hand side.
//!
//! With `x_k` the coefficient of `t^k`, each operation gives its coefficient `k` from those of its operands up to `k`: a product
//! is a convolution, and a function follows from the differential equation that it solves (R. E. Moore, *Interval
//! Analysis*, 1966; A. Jorba, M. Zou, *Experimental Mathematics* 14, 99, 2005). The equation itself then gives the
//! next coefficient of the state, `y_{k+1} = f_k / (k + 1)`, so that all orders cost little more than a square of their number.
//!
//! A choice between cases is made at the start and holds: where cases change, a step must end. Products with derivatives are written with the series of `t x'`, whose coefficients are `k x_k`.

use super::Tape;
use super::node::{Binary, Node, Unary};
use crate::Scalar;

/// How a coefficient follows. Rows are named by their place; those of higher places are asked for lower orders only.
#[derive(Clone, Copy, Debug)]
enum Rule {
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
enum Start {
    Of(Unary, usize),
    Both(Binary, usize, usize),
}

/// What holds at order zero.
#[derive(Clone, Copy, Debug)]
enum Condition {
    Less(usize, usize),
    LessOrEqual(usize, usize),
    And(usize, usize),
    Or(usize, usize),
    Not(usize),
}

/// The differential equation of a function y of x. `slope` is the row of the slope of x, `own` that of y.
#[derive(Clone, Copy, Debug)]
enum Law {
    /// `y' = z x'`, with z the partner, or its negative: exponential, sine and cosine, hyperbolic ones.
    Partner { slope: usize, partner: usize, negative: bool },
    /// `y' = (1 + y^2) x'`, or with a minus, from the square of y: the tangents.
    Tangent { slope: usize, square: usize, negative: bool },
    /// `w y' = x'`, with w below: logarithm and inverse functions.
    Inverse { slope: usize, below: usize, own: usize },
    /// `r x y' = e y x'`: the power `e / r`.
    Power { exponent: f64, root: f64, of: usize, slope: usize, own: usize },
}

/// The Taylor coefficients of a solution.
#[derive(Clone, Debug)]
pub struct Taylor<S: Scalar> {
    rules: Vec<Rule>,
    /// Row after row, each with all coefficients of one operation.
    coefficients: Vec<S>,
    /// Whether the condition of a row holds.
    holds: Vec<S::Mask>,
    terms: usize,
    /// The rows of time and the state, and those that give the state's rates.
    inputs: Vec<usize>,
    outputs: Vec<usize>,
}

impl<S: Scalar> Taylor<S> {
    /// For `y' = f(t, y)`, recorded with the inputs `t, y` and the outputs `f`, up to the coefficient of `t^order`.
    ///
    /// # Errors
    /// The function that has no Taylor series: an absolute value, a sign, the larger or smaller of two.
    ///
    /// # Panics
    /// If the tape does not have one output for each input but the first.
    pub fn new(tape: &Tape, order: usize) -> Result<Self, &'static str> {
        assert_eq!(tape.inputs, tape.outputs.len() + 1, "a rate for each number of the state");
        let mut rules = Rules { rules: vec![], place: vec![] };
        let smooth = tape.beside_conditions();
        let inputs = (0..tape.inputs).map(|_| rules.push(Rule::Input)).collect();
        for (&node, smooth) in tape.nodes.iter().zip(smooth) {
            let at = rules.translate(node, smooth)?;
            rules.place.push(at);
        }
        let outputs = tape.outputs.iter().map(|&at| rules.place[at as usize]).collect();
        let terms = order + 1;
        let coefficients = vec![S::from(0.0); rules.rules.len() * terms];
        let holds = vec![!S::always(); rules.rules.len()];
        Ok(Self { rules: rules.rules, coefficients, holds, terms, inputs, outputs })
    }

    /// Expands the solution that is at `y` at time `t`.
    ///
    /// # Panics
    /// If the state is not of the recorded size.
    #[inline(always)]
    pub fn expand(&mut self, t: S, y: &[S]) {
        assert_eq!(y.len(), self.outputs.len(), "a state of another size");
        let terms = self.terms;
        let time = self.inputs[0] * terms;
        self.coefficients[time] = t;
        if terms > 1 {
            self.coefficients[time + 1] = S::from(1.0);
        }
        for (&row, y) in self.inputs[1..].iter().zip(y) {
            self.coefficients[row * terms] = *y;
        }
        for k in 0..terms - 1 {
            self.order(k);
            for (&row, &rate) in self.inputs[1..].iter().zip(&self.outputs) {
                self.coefficients[row * terms + k + 1] = self.coefficients[rate * terms + k] / (k + 1) as f64;
            }
        }
    }

    /// The coefficients of number `i` of the state, from that of `t^0` on.
    pub fn of(&self, i: usize) -> &[S] {
        &self.coefficients[self.inputs[i + 1] * self.terms..][..self.terms]
    }

    /// Coefficient `k` of every operation.
    #[inline(always)]
    fn order(&mut self, k: usize) {
        let terms = self.terms;
        for (row, rule) in self.rules.iter().enumerate() {
            let from = |row: usize| &self.coefficients[row * terms..][..terms];
            let value = match *rule {
                Rule::Condition(condition) if k == 0 => {
                    self.holds[row] = self.condition(condition);
                    None
                }
                Rule::Choice(mask, a, b) => Some(S::select(self.holds[mask], from(a)[k], from(b)[k])),
                rule if k == 0 => zeroth(rule, &from),
                rule => later(rule, row, k, &from),
            };
            if let Some(value) = value {
                self.coefficients[row * terms + k] = value;
            }
        }
    }
}

impl<S: Scalar> Taylor<S> {
    #[inline(always)]
    fn condition(&self, condition: Condition) -> S::Mask {
        let at = |row: usize| self.coefficients[row * self.terms];
        let holds = |row: usize| self.holds[row];
        match condition {
            Condition::Less(a, b) => at(a).lt(at(b)),
            Condition::LessOrEqual(a, b) => at(a).le(at(b)),
            Condition::And(a, b) => holds(a) & holds(b),
            Condition::Or(a, b) => holds(a) | holds(b),
            Condition::Not(a) => !holds(a),
        }
    }
}

/// The value itself; none for what is given, or no number.
#[inline(always)]
fn zeroth<'a, S: Scalar>(rule: Rule, row: &impl Fn(usize) -> &'a [S]) -> Option<S> {
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
        Rule::Function(Start::Of(f, a), _) | Rule::Value(Start::Of(f, a)) => super::replay::unary(f, at(a)),
        Rule::Function(Start::Both(f, a, b), _) | Rule::Value(Start::Both(f, a, b)) => {
            super::replay::binary(f, at(a), at(b))
        }
    })
}

/// A later coefficient; none for what stays or is given.
#[inline(always)]
fn later<'a, S: Scalar>(rule: Rule, own_row: usize, k: usize, row: &impl Fn(usize) -> &'a [S]) -> Option<S> {
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
fn convolution<S: Scalar>(a: &[S], b: &[S]) -> S {
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
fn square<S: Scalar>(a: &[S]) -> S {
    let n = a.len();
    let half = n / 2;
    let twice = convolution(&a[..half], &a[n - half..]) * 2.0;
    if n % 2 == 1 { twice + a[half].squared() } else { twice }
}

/// The same without its ends, of a series that lacks its last term.
#[inline(always)]
fn square_between<S: Scalar>(a: &[S]) -> S {
    if a.len() < 2 { S::from(0.0) } else { square(&a[1..]) }
}

/// Rules under construction.
struct Rules {
    rules: Vec<Rule>,
    /// The row of each node translated so far.
    place: Vec<usize>,
}

impl Rules {
    fn push(&mut self, rule: Rule) -> usize {
        self.rules.push(rule);
        self.rules.len() - 1
    }

    fn literal(&self, row: usize) -> Option<f64> {
        if let Rule::Constant(x) = self.rules[row] { Some(x) } else { None }
    }

    /// The row of a node whose operands have theirs.
    fn translate(&mut self, node: Node, smooth: bool) -> Result<usize, &'static str> {
        let at = |rules: &Self, i: u32| rules.place[i as usize];
        Ok(match node {
            Node::Constant(bits) => self.push(Rule::Constant(f64::from_bits(bits))),
            Node::Input(i) => i as usize,
            Node::Unary(f, a) if !smooth => {
                let start = Start::Of(f, at(self, a));
                self.push(Rule::Value(start))
            }
            Node::Binary(f, a, b) if !smooth => {
                let start = Start::Both(f, at(self, a), at(self, b));
                self.push(Rule::Value(start))
            }
            Node::Unary(f, a) => {
                let a = at(self, a);
                self.unary(f, a)?
            }
            Node::Binary(f, a, b) => {
                let (a, b) = (at(self, a), at(self, b));
                self.binary(f, a, b)?
            }
            Node::Power(a, n) => {
                let a = at(self, a);
                self.whole_power(a, n)
            }
            Node::Less(a, b) => {
                let condition = Condition::Less(at(self, a), at(self, b));
                self.push(Rule::Condition(condition))
            }
            Node::LessOrEqual(a, b) => {
                let condition = Condition::LessOrEqual(at(self, a), at(self, b));
                self.push(Rule::Condition(condition))
            }
            Node::And(a, b) => {
                let condition = Condition::And(at(self, a), at(self, b));
                self.push(Rule::Condition(condition))
            }
            Node::Or(a, b) => {
                let condition = Condition::Or(at(self, a), at(self, b));
                self.push(Rule::Condition(condition))
            }
            Node::Not(a) => {
                let condition = Condition::Not(at(self, a));
                self.push(Rule::Condition(condition))
            }
            Node::Select(mask, a, b) => {
                let choice = Rule::Choice(at(self, mask), at(self, a), at(self, b));
                self.push(choice)
            }
        })
    }

    fn unary(&mut self, f: Unary, a: usize) -> Result<usize, &'static str> {
        Ok(match f {
            Unary::Neg => self.push(Rule::Negative(a)),
            Unary::Sqrt => self.push(Rule::Root(a)),
            Unary::Exp => {
                let slope = self.push(Rule::Slope(a));
                let partner = self.rules.len();
                self.push(Rule::Function(Start::Of(f, a), Law::Partner { slope, partner, negative: false }))
            }
            Unary::Sin => self.pair(Unary::Sin, Unary::Cos, true, a),
            Unary::Cos => self.pair(Unary::Cos, Unary::Sin, false, a),
            Unary::Sinh => self.pair(Unary::Sinh, Unary::Cosh, false, a),
            Unary::Cosh => self.pair(Unary::Cosh, Unary::Sinh, false, a),
            Unary::Tan | Unary::Tanh => {
                let slope = self.push(Rule::Slope(a));
                let own = self.rules.len();
                let negative = f == Unary::Tanh;
                self.push(Rule::Function(Start::Of(f, a), Law::Tangent { slope, square: own + 1, negative }));
                self.push(Rule::Square(own));
                own
            }
            Unary::Ln => {
                let slope = self.push(Rule::Slope(a));
                self.inverse(Start::Of(f, a), slope, a)
            }
            Unary::Asin | Unary::Acos => {
                let mut slope = self.push(Rule::Slope(a));
                if f == Unary::Acos {
                    slope = self.push(Rule::Negative(slope));
                }
                let (one, square) = (self.push(Rule::Constant(1.0)), self.push(Rule::Square(a)));
                let rest = self.push(Rule::Difference(one, square));
                let root = self.push(Rule::Root(rest));
                self.inverse(Start::Of(f, a), slope, root)
            }
            Unary::Cbrt => self.power(Start::Of(f, a), a, 1.0, 3.0),
            Unary::Abs => return Err("an absolute value"),
            Unary::Sign => return Err("a sign"),
        })
    }

    fn binary(&mut self, f: Binary, a: usize, b: usize) -> Result<usize, &'static str> {
        Ok(match f {
            Binary::Add => self.push(Rule::Sum(a, b)),
            Binary::Sub => self.push(Rule::Difference(a, b)),
            Binary::Mul if a == b => self.push(Rule::Square(a)),
            Binary::Mul => match (self.literal(a), self.literal(b)) {
                (Some(x), _) => self.push(Rule::Multiple(b, x)),
                (_, Some(x)) => self.push(Rule::Multiple(a, x)),
                _ => self.push(Rule::Product(a, b)),
            },
            Binary::Div => match self.literal(b) {
                Some(x) => self.push(Rule::Multiple(a, 1.0 / x)),
                None => self.push(Rule::Quotient(a, b)),
            },
            Binary::Hypot => {
                let squares = self.squares(a, b);
                self.push(Rule::Root(squares))
            }
            Binary::Atan2 => {
                // (x^2 + y^2) theta' = x y' - y x'
                let (rise, run) = (self.push(Rule::Slope(a)), self.push(Rule::Slope(b)));
                let (plus, minus) = (self.push(Rule::Product(b, rise)), self.push(Rule::Product(a, run)));
                let slope = self.push(Rule::Difference(plus, minus));
                let squares = self.squares(a, b);
                self.inverse(Start::Both(f, a, b), slope, squares)
            }
            Binary::Powf => match self.literal(b) {
                Some(exponent) => self.power(Start::Both(f, a, b), a, exponent, 1.0),
                None => {
                    let logarithm = self.unary(Unary::Ln, a)?;
                    let exponent = self.push(Rule::Product(b, logarithm));
                    self.unary(Unary::Exp, exponent)?
                }
            },
            Binary::Larger | Binary::Smaller => return Err("the larger or smaller of two"),
        })
    }

    fn squares(&mut self, a: usize, b: usize) -> usize {
        let (a, b) = (self.push(Rule::Square(a)), self.push(Rule::Square(b)));
        self.push(Rule::Sum(a, b))
    }

    /// A function and its partner, each the other's derivative up to a sign; the first one's row. Who asks for both gets
    /// the same two rows.
    fn pair(&mut self, first: Unary, second: Unary, plus: bool, a: usize) -> usize {
        let known = self
            .rules
            .iter()
            .position(|rule| matches!(*rule, Rule::Function(Start::Of(f, of), _) if f == first && of == a));
        if let Some(row) = known {
            return row;
        }
        let slope = self.push(Rule::Slope(a));
        let own = self.rules.len();
        // sin' = cos, cos' = -sin; both hyperbolic ones without the sign.
        let circular = matches!(first, Unary::Sin | Unary::Cos);
        self.push(Rule::Function(
            Start::Of(first, a),
            Law::Partner { slope, partner: own + 1, negative: circular && !plus },
        ));
        self.push(Rule::Function(
            Start::Of(second, a),
            Law::Partner { slope, partner: own, negative: circular && plus },
        ));
        own
    }

    /// A function with `below y' = slope'`.
    fn inverse(&mut self, start: Start, slope: usize, below: usize) -> usize {
        let row = self.rules.len();
        self.push(Rule::Function(start, Law::Inverse { slope, below, own: row + 1 }));
        self.push(Rule::Slope(row));
        row
    }

    fn power(&mut self, start: Start, of: usize, exponent: f64, root: f64) -> usize {
        let slope = self.push(Rule::Slope(of));
        let row = self.rules.len();
        self.push(Rule::Function(start, Law::Power { exponent, root, of, slope, own: row + 1 }));
        self.push(Rule::Slope(row));
        row
    }

    /// By repeated squaring, which needs no logarithm and no base that is not zero.
    fn whole_power(&mut self, a: usize, n: i32) -> usize {
        let (mut base, mut rest, mut product) = (a, n.unsigned_abs(), None);
        while rest > 0 {
            if rest % 2 == 1 {
                product = Some(product.map_or(base, |p| self.push(Rule::Product(p, base))));
            }
            rest /= 2;
            if rest > 0 {
                base = self.push(Rule::Square(base));
            }
        }
        let one = |rules: &mut Self| rules.push(Rule::Constant(1.0));
        match product {
            Some(product) if n > 0 => product,
            Some(product) => {
                let one = one(self);
                self.push(Rule::Quotient(one, product))
            }
            None => one(self),
        }
    }
}
