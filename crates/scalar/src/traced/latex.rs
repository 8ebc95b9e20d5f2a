//! LaTeX as a book would set it: `-b\,\dot\theta - \frac{g}{l}\sin\theta`.

use super::constant;
use super::node::{Binary, Node, Unary};
use super::product::{Base, Factor, Piece, Product};
use super::view::View;
use std::mem;

impl View<'_> {
    /// A node as LaTeX.
    pub(super) fn latex(&self, at: u32) -> String {
        self.sum(at, |term| self.latex_product(term))
    }

    fn latex_product(&self, product: Product) -> String {
        let mut pieces = product.arranged(self);
        // `\sin\theta\,x` could be read as the sine of a product: functions come last.
        pieces.sort_by_key(|piece| piece.bottom.is_empty() && piece.top.iter().any(|&f| self.is_function(f)));
        let parts: Vec<String> = pieces.into_iter().map(|piece| self.latex_piece(piece)).collect();
        juxtaposed(&parts)
    }

    fn latex_piece(&self, Piece { top, bottom }: Piece) -> String {
        if bottom.is_empty() {
            return self.latex_factors(top);
        }
        // Under or above a bar a lone sum needs no parentheses.
        let side = |factors: Vec<Factor>| match factors[..] {
            [Factor { base: Base::Node(at), exponent: 1 }] if self.is_sum(at) => self.latex(at),
            _ => self.latex_factors(factors),
        };
        format!(r"\frac{{{}}}{{{}}}", side(top), side(bottom))
    }

    fn latex_factors(&self, mut factors: Vec<Factor>) -> String {
        factors.sort_by_key(|&factor| self.is_function(factor));
        let parts: Vec<String> = factors.into_iter().map(|factor| self.latex_factor(factor)).collect();
        juxtaposed(&parts)
    }

    fn latex_factor(&self, Factor { base, exponent }: Factor) -> String {
        let text = match base {
            Base::Number(x) => constant::decimal(x, self.notation),
            Base::Pi => r"\pi".into(),
            Base::Root(n) => format!(r"\sqrt{{{n}}}"),
            Base::Node(at) => {
                if let (None, Node::Unary(f, a)) = (self.name(at), self.node(at))
                    && let Some(operator) = operator(f)
                {
                    return self.latex_call(operator, a, exponent);
                }
                self.latex_atom(at, exponent != 1)
            }
        };
        if exponent == 1 { text } else { format!("{}^{{{exponent}}}", script_base(text)) }
    }

    /// `\sin\theta`, `\sin^{2}\theta` or `\sin(a + b)`.
    fn latex_call(&self, operator: &str, argument: u32, exponent: i32) -> String {
        let inner = self.latex(argument);
        let simple = self.name(argument).is_some();
        let inner = match inner.starts_with(|c: char| c.is_ascii_alphanumeric()) {
            _ if !simple => parenthesised(&inner),
            true => format!(" {inner}"),
            false => inner,
        };
        match exponent {
            1 => format!("{operator}{inner}"),
            // The power -1 of a sine would be read as its inverse.
            n if n > 1 && !operator.starts_with(r"\arc") => format!("{operator}^{{{n}}}{inner}"),
            n => format!("{}^{{{n}}}", parenthesised(&format!("{operator}{inner}"))),
        }
    }

    /// A node as a factor, or as the base of a power.
    fn latex_atom(&self, at: u32, is_base: bool) -> String {
        if let Some(name) = self.name(at) {
            return name;
        }
        let text = match self.node(at) {
            Node::Unary(Unary::Sqrt, a) => return format!(r"\sqrt{{{}}}", self.latex(a)),
            Node::Unary(Unary::Cbrt, a) => return format!(r"\sqrt[3]{{{}}}", self.latex(a)),
            Node::Unary(Unary::Abs, a) => return format!(r"\left|{}\right|", self.latex(a)),
            Node::Unary(Unary::Exp, a) => format!(r"\mathrm{{e}}^{{{}}}", self.latex(a)),
            Node::Binary(Binary::Hypot, a, b) => {
                return format!(r"\sqrt{{{}^{{2}} + {}^{{2}}}}", self.latex_base(a), self.latex_base(b));
            }
            Node::Binary(Binary::Powf, a, b) => {
                format!("{}^{{{}}}", self.latex_base(a), self.latex_exponent(b))
            }
            Node::Power(a, 0) => format!("{}^{{0}}", self.latex_base(a)),
            Node::Binary(f @ (Binary::Atan2 | Binary::Larger | Binary::Smaller), a, b) => {
                let inner = parenthesised(&format!("{}, {}", self.latex(a), self.latex(b)));
                format!("{}{inner}", operator_of_two(f).unwrap_or_default())
            }
            Node::Select(..) => self.latex_cases(at),
            _ => return parenthesised(&self.latex(at)),
        };
        if is_base { parenthesised(&text) } else { text }
    }

    /// What a superscript is put on: in parentheses unless it is one symbol.
    fn latex_base(&self, at: u32) -> String {
        match self.symbol(at) {
            Some(Base::Node(inner)) if !self.is_function(Base::Node(inner).into()) => {
                script_base(self.latex_atom(inner, true))
            }
            Some(Base::Pi | Base::Root(_)) => self.latex(at),
            Some(Base::Number(x)) if x.fract() == 0.0 && x < 1e6 => self.latex(at),
            _ => parenthesised(&self.latex(at)),
        }
    }

    /// An exponent; a fraction in it lies flat.
    fn latex_exponent(&self, at: u32) -> String {
        let [product] = &mut self.terms(at)[..] else { return self.latex(at) };
        let sign = if product.negative { "-" } else { "" };
        match &mem::take(product).arranged(self)[..] {
            [Piece { top, bottom }] if !bottom.is_empty() && top.len() < 2 && bottom.len() < 2 => {
                let [top, bottom] = [top, bottom].map(|side| self.latex_factors(side.clone()));
                format!("{sign}{top}/{bottom}")
            }
            _ => self.latex(at),
        }
    }

    fn latex_cases(&self, mut at: u32) -> String {
        let mut text = String::from(r"\begin{cases} ");
        while let Node::Select(mask, a, b) = self.node(at) {
            text += &[&self.latex(a), r" & \text{if } ", &self.condition(mask), r" \\ "].concat();
            at = b;
            if self.name(at).is_some() {
                break;
            }
        }
        text + &format!(r"{} & \text{{otherwise}} \end{{cases}}", self.latex(at))
    }

    /// Whether it is a named function, whose argument may stand without parentheses.
    fn is_function(&self, factor: Factor) -> bool {
        let Base::Node(at) = factor.base else { return false };
        self.name(at).is_none()
            && match self.node(at) {
                Node::Unary(f, _) => operator(f).is_some(),
                Node::Binary(f, ..) => operator_of_two(f).is_some(),
                _ => false,
            }
    }
}

/// Factors side by side; a thin space where LaTeX would set none.
fn juxtaposed(parts: &[String]) -> String {
    let mut text = String::new();
    for part in parts {
        let number = text.bytes().all(|b| b.is_ascii_digit() || b == b'.') && !part.starts_with(r"\frac");
        let digit = part.starts_with(|c: char| c.is_ascii_digit());
        let spaced = [r"\sin", r"\cos", r"\tan", r"\ln", r"\arc", r"\max", r"\min", r"\operatorname"];
        text += match text.is_empty() {
            true => "",
            false if digit => r" \cdot ",
            false if number || spaced.iter().any(|operator| part.starts_with(operator)) => "",
            false => r"\,",
        };
        text += part;
    }
    if text.is_empty() { "1".into() } else { text }
}

/// Parentheses as tall as what they hold.
fn parenthesised(text: &str) -> String {
    let tall = [r"\frac", r"\sqrt", r"\left", r"\begin"].iter().any(|high| text.contains(high));
    if tall { format!(r"\left({text}\right)") } else { format!("({text})") }
}

/// A symbol that has a superscript takes another only in braces.
fn script_base(text: String) -> String {
    if text.contains('^') && !text.starts_with('(') && !text.starts_with(r"\left") {
        format!("{{{text}}}")
    } else {
        text
    }
}

fn operator(f: Unary) -> Option<&'static str> {
    match f {
        Unary::Sin => Some(r"\sin"),
        Unary::Cos => Some(r"\cos"),
        Unary::Tan => Some(r"\tan"),
        Unary::Asin => Some(r"\arcsin"),
        Unary::Acos => Some(r"\arccos"),
        Unary::Ln => Some(r"\ln"),
        Unary::Sinh => Some(r"\sinh"),
        Unary::Cosh => Some(r"\cosh"),
        Unary::Tanh => Some(r"\tanh"),
        Unary::Sign => Some(r"\operatorname{sign}"),
        _ => None,
    }
}

fn operator_of_two(f: Binary) -> Option<&'static str> {
    match f {
        Binary::Atan2 => Some(r"\operatorname{atan2}"),
        Binary::Larger => Some(r"\max"),
        Binary::Smaller => Some(r"\min"),
        _ => None,
    }
}
