//! Products and quotients arranged for the eye: `g / l * sin(theta)` is a fraction and a sine.
//!
//! Factors stay in the order in which they were written, except that numbers come first.

use super::constant;
use super::node::{Binary, Node, Unary};
use super::view::View;

/// What is raised to a power in a product.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Base {
    /// A positive number (or zero, or NaN).
    Number(f64),
    Pi,
    /// The square root of an integer.
    Root(u32),
    Node(u32),
}

/// A base and its integer power.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Factor {
    pub(super) base: Base,
    pub(super) exponent: i32,
}

impl From<Base> for Factor {
    fn from(base: Base) -> Self {
        Self { base, exponent: 1 }
    }
}

/// Factors above and below a fraction bar, or a single factor without one.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Piece {
    pub(super) top: Vec<Factor>,
    pub(super) bottom: Vec<Factor>,
}

impl Piece {
    /// The factor that it is, if it has no bar.
    fn plain(&mut self) -> Option<&mut Factor> {
        if self.bottom.is_empty() { self.top.first_mut() } else { None }
    }
}

/// A product with its sign, its numbers and the rest.
#[derive(Clone, Debug, Default)]
pub(super) struct Product {
    pub(super) negative: bool,
    above: Vec<f64>,
    below: Vec<f64>,
    pieces: Vec<Piece>,
}

impl View<'_> {
    /// A node as a product; a node with a name is a factor of its own.
    pub(super) fn product(&self, node: u32) -> Product {
        let mut product = Product::default();
        if self.name(node).is_some() {
            product.append(Base::Node(node).into());
            return product;
        }
        match self.node(node) {
            Node::Constant(bits) => product.number(f64::from_bits(bits)),
            Node::Unary(Unary::Neg, a) => {
                product = self.product(a);
                product.negative ^= true;
            }
            Node::Binary(Binary::Mul, a, b) if a == b => product = self.power(a, 2),
            Node::Binary(Binary::Mul, a, b) => {
                product = self.product(a);
                product.times(self.product(b));
            }
            Node::Binary(Binary::Div, a, b) => {
                product = self.product(a);
                product.over(self.product(b));
            }
            Node::Power(a, n) if n != 0 => product = self.power(a, n),
            _ => product.append(Base::Node(node).into()),
        }
        product
    }

    /// The one symbol that a node is written as.
    pub(super) fn symbol(&self, node: u32) -> Option<Base> {
        match self.product(node).arranged_alone(self)? {
            Factor { base, exponent: 1 } => Some(base),
            Factor { .. } => None,
        }
    }

    /// `(x^2)^3` is `x^6`; whatever is not a single factor keeps its parentheses.
    fn power(&self, node: u32, n: i32) -> Product {
        let mut inner = self.product(node);
        let lone = inner.lone().and_then(|f| Some((f.base, f.exponent.checked_mul(n)?)));
        let (base, exponent) = lone.unwrap_or((Base::Node(node), n));
        let mut product = Product::default();
        product.append(Factor { base, exponent });
        product
    }
}

impl Product {
    fn number(&mut self, x: f64) {
        self.negative ^= x.is_sign_negative() && !x.is_nan();
        self.above.push(if x.is_nan() { x } else { x.abs() });
    }

    fn append(&mut self, factor: Factor) {
        let mut plain = self.pieces.iter_mut().filter_map(Piece::plain);
        if !plain.any(|known| known.absorb(factor)) {
            self.pieces.push(Piece { top: vec![factor], bottom: Vec::new() });
        }
    }

    fn times(&mut self, o: Self) {
        self.negative ^= o.negative;
        self.above.extend(o.above);
        self.below.extend(o.below);
        for mut piece in o.pieces {
            match piece.plain() {
                Some(&mut factor) => self.append(factor),
                None => self.pieces.push(piece),
            }
        }
    }

    /// Everything comes above or below one bar.
    fn over(&mut self, o: Self) {
        self.negative ^= o.negative;
        self.above.extend(o.below);
        self.below.extend(o.above);
        let mut all = Piece::default();
        for piece in self.pieces.drain(..) {
            piece.top.into_iter().for_each(|factor| insert(&mut all.top, factor));
            piece.bottom.into_iter().for_each(|factor| insert(&mut all.bottom, factor));
        }
        for piece in o.pieces {
            piece.top.into_iter().for_each(|factor| insert(&mut all.bottom, factor));
            piece.bottom.into_iter().for_each(|factor| insert(&mut all.top, factor));
        }
        if all.bottom.is_empty() {
            all.top.into_iter().for_each(|factor| self.append(factor));
        } else {
            self.pieces.push(all);
        }
    }

    /// The single factor that it is.
    fn lone(&mut self) -> Option<Factor> {
        let numbers = self.above.iter().chain(&self.below).any(|&x| x != 1.0);
        match &mut self.pieces[..] {
            [piece] if !numbers && !self.negative => piece.plain().copied(),
            _ => None,
        }
    }

    /// The single factor that is left of it, a sum excepted.
    fn arranged_alone(self, view: &View) -> Option<Factor> {
        let negative = self.negative;
        let mut pieces = self.arranged(view);
        let [piece] = &mut pieces[..] else { return None };
        piece.plain().copied().filter(|f| !negative && !matches!(f.base, Base::Node(at) if view.is_sum(at)))
    }

    /// The pieces from left to right, the numbers in their places.
    pub(super) fn arranged(self, view: &View) -> Vec<Piece> {
        let Self { above, below, mut pieces, .. } = self;
        let (top, bottom, coefficient) = numbers(&above, &below, view);
        if let Some(fraction) = pieces.iter_mut().find(|piece| !piece.bottom.is_empty()) {
            fraction.top.splice(..0, top);
            fraction.bottom.splice(..0, bottom);
        } else if bottom.is_empty() {
            let plain = |factor| Piece { top: vec![factor], bottom: Vec::new() };
            pieces.splice(..0, top.into_iter().map(plain));
        } else if coefficient {
            pieces.insert(0, Piece { top, bottom });
        } else {
            let factors = pieces.into_iter().flat_map(|piece| piece.top);
            pieces = vec![Piece { top: top.into_iter().chain(factors).collect(), bottom }];
        }
        pieces
    }
}

impl Factor {
    /// `x^2` takes up an `x`; `x^-1` does not, it is no business of printing to cancel.
    fn absorb(&mut self, o: Self) -> bool {
        let together = self.exponent.checked_add(o.exponent);
        let fits = self.base == o.base && (self.exponent > 0) == (o.exponent > 0);
        if let (true, Some(exponent)) = (fits, together) {
            self.exponent = exponent;
        }
        fits && together.is_some()
    }
}

fn insert(factors: &mut Vec<Factor>, factor: Factor) {
    if !factors.iter_mut().any(|known| known.absorb(factor)) {
        factors.push(factor);
    }
}

/// The numbers above and below the bar, and whether they are a coefficient such as 1/2 rather than a divisor
/// that somebody wrote.
fn numbers(above: &[f64], below: &[f64], view: &View) -> (Vec<Factor>, Vec<Factor>, bool) {
    let (mut above, mut below) = (constant::merged(above), constant::merged(below));
    let coefficient = below.is_empty();
    if let ([p], [q]) = (&mut above[..], &mut below[..]) {
        let whole = |x: f64| (1.0..1e15).contains(&x) && x.trunc() == x;
        if p == q && p.is_normal() {
            (*p, *q) = (1.0, 1.0);
        } else if whole(*p) && whole(*q) {
            let divisor = constant::divisor(*p, *q);
            (*p, *q) = (*p / divisor, *q / divisor);
        }
    }
    let (mut top, mut bottom, mut divisors) = (Vec::new(), Vec::new(), Vec::new());
    for x in above {
        let (over, under) = constant::written(x, view.notation);
        top.extend(over);
        divisors.extend(under);
    }
    for base in divisors {
        match base {
            Base::Number(x) => below.push(x),
            other => bottom.push(other),
        }
    }
    for x in constant::merged(&below) {
        let (over, under) = constant::written(x, super::Notation::Text);
        bottom.extend(over);
        top.extend(under);
    }
    let factors = |bases: Vec<Base>| bases.into_iter().filter(|&b| b != Base::Number(1.0)).map(Factor::from);
    (factors(top).collect(), factors(bottom).collect(), coefficient)
}
