//! From the operations of a tape to rules.

use super::rule::{Condition, Law, Rule, Start};
use crate::traced::node::{Binary, Node, Unary};

/// Rules under construction.
#[derive(Default)]
pub(super) struct Rules {
    pub rules: Vec<Rule>,
    /// The row of each node translated so far.
    pub place: Vec<usize>,
}

impl Rules {
    pub fn push(&mut self, rule: Rule) -> usize {
        self.rules.push(rule);
        self.rules.len() - 1
    }

    fn literal(&self, row: usize) -> Option<f64> {
        if let Rule::Constant(x) = self.rules[row] { Some(x) } else { None }
    }

    /// The row of a node whose operands have theirs.
    pub fn translate(&mut self, node: Node, smooth: bool) -> Result<usize, &'static str> {
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
            Binary::Powf => {
                if let Some(exponent) = self.literal(b) {
                    return Ok(self.power(Start::Both(f, a, b), a, exponent, 1.0));
                }
                let logarithm = self.unary(Unary::Ln, a)?;
                let exponent = self.push(Rule::Product(b, logarithm));
                self.unary(Unary::Exp, exponent)?
            }
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
