//! ASCII text that a calculator reads: `-b * theta' - g / l * sin(theta)`.

use super::constant;
use super::node::{Binary, Node, Unary};
use super::product::{Base, Factor, Piece, Product};
use super::view::View;

impl View<'_> {
    /// A node as text.
    pub(super) fn text(&self, at: u32) -> String {
        self.sum(at, |term| self.text_product(term))
    }

    fn text_product(&self, product: Product) -> String {
        let mut text = String::new();
        for Piece { top, bottom } in product.arranged(self) {
            for factor in top {
                text += if text.is_empty() { "" } else { " * " };
                text += &self.text_factor(factor);
            }
            if text.is_empty() {
                text.push('1');
            }
            let below: Vec<String> = bottom.into_iter().map(|factor| self.text_factor(factor)).collect();
            match &below[..] {
                [] => {}
                [one] => text += &[" / ", one].concat(),
                several => text += &[" / (", &several.join(" * "), ")"].concat(),
            }
        }
        if text.is_empty() { "1".into() } else { text }
    }

    fn text_factor(&self, Factor { base, exponent }: Factor) -> String {
        let text = match base {
            Base::Number(x) => constant::decimal(x, self.notation),
            Base::Pi => "pi".into(),
            Base::Root(n) => format!("sqrt({n})"),
            Base::Node(at) => self.text_atom(at, exponent != 1),
        };
        match exponent {
            1 => text,
            n if n < 0 => format!("{text}^({n})"),
            n => format!("{text}^{n}"),
        }
    }

    /// A node as a factor, or as the base of a power.
    fn text_atom(&self, at: u32, is_base: bool) -> String {
        if let Some(name) = self.name(at) {
            return name;
        }
        match self.node(at) {
            Node::Unary(f, a) if f != Unary::Neg => format!("{}({})", function(f), self.text(a)),
            Node::Binary(Binary::Powf, a, b) if !is_base => {
                format!("{}^{}", self.text_operand(a), self.text_operand(b))
            }
            Node::Binary(f @ (Binary::Atan2 | Binary::Hypot | Binary::Larger | Binary::Smaller), a, b) => {
                format!("{}({}, {})", function_of_two(f), self.text(a), self.text(b))
            }
            Node::Power(a, 0) if !is_base => format!("{}^0", self.text_operand(a)),
            Node::Select(mask, a, b) => {
                format!("if({}, {}, {})", self.condition(mask), self.text(a), self.text(b))
            }
            Node::Binary(Binary::Powf, ..) | Node::Power(_, 0) => format!("({})", self.text_atom(at, false)),
            _ => format!("({})", self.text(at)),
        }
    }

    /// A base or an exponent: in parentheses unless it is one symbol, number or call.
    fn text_operand(&self, at: u32) -> String {
        let text = self.text(at);
        let mut depth = 0;
        let joined = |c: char| {
            depth += i32::from(c == '(') - i32::from(c == ')');
            depth == 0 && matches!(c, ' ' | '^' | '-')
        };
        if text.contains(joined) && self.name(at).is_none() { format!("({text})") } else { text }
    }
}

fn function(f: Unary) -> &'static str {
    match f {
        Unary::Neg => "-",
        Unary::Sqrt => "sqrt",
        Unary::Sin => "sin",
        Unary::Cos => "cos",
        Unary::Tan => "tan",
        Unary::Asin => "asin",
        Unary::Acos => "acos",
        Unary::Exp => "exp",
        Unary::Ln => "ln",
        Unary::Sinh => "sinh",
        Unary::Cosh => "cosh",
        Unary::Tanh => "tanh",
        Unary::Cbrt => "cbrt",
        Unary::Abs => "abs",
        Unary::Sign => "sign",
    }
}

fn function_of_two(f: Binary) -> &'static str {
    match f {
        Binary::Add => "+",
        Binary::Sub => "-",
        Binary::Mul => "*",
        Binary::Div => "/",
        Binary::Powf => "^",
        Binary::Atan2 => "atan2",
        Binary::Hypot => "hypot",
        Binary::Larger => "max",
        Binary::Smaller => "min",
    }
}
