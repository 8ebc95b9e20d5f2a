//! Comparisons, and what combines them.

use super::Notation;
use super::node::Node;
use super::view::View;

impl View<'_> {
    /// A comparison or a combination of comparisons.
    pub(super) fn condition(&self, at: u32) -> String {
        self.either(at, false)
    }

    fn either(&self, at: u32, inverted: bool) -> String {
        let latex = self.notation == Notation::Latex;
        let number = |at| if latex { self.latex(at) } else { self.text(at) };
        let compare = |a: u32, b: u32, [straight, flipped]: [usize; 2]| {
            // `x > 0` reads better than `0 < x`.
            let flip =
                matches!(self.node(a), Node::Constant(_)) && !matches!(self.node(b), Node::Constant(_));
            let (a, b, sign) = if flip { (b, a, flipped) } else { (a, b, straight) };
            let signs = if latex { ["<", r"\le", ">", r"\ge"] } else { ["<", "<=", ">", ">="] };
            format!("{} {} {}", number(a), signs[sign], number(b))
        };
        let join = |a: u32, b: u32, and: bool| {
            // A De Morgan law moves an inversion inwards: "and" becomes "or".
            let part = |at| {
                let text = self.either(at, inverted);
                if self.is_combined(at) { format!("({text})") } else { text }
            };
            match (and ^ inverted, latex) {
                (true, false) => format!("{} and {}", part(a), part(b)),
                (false, false) => format!("{} or {}", part(a), part(b)),
                (true, true) => format!(r"{} \text{{ and }} {}", part(a), part(b)),
                (false, true) => format!(r"{} \text{{ or }} {}", part(a), part(b)),
            }
        };
        match self.node(at) {
            Node::Less(a, b) => compare(a, b, if inverted { [3, 1] } else { [0, 2] }),
            Node::LessOrEqual(a, b) => compare(a, b, if inverted { [2, 0] } else { [1, 3] }),
            Node::And(a, b) => join(a, b, true),
            Node::Or(a, b) => join(a, b, false),
            Node::Not(a) => self.either(a, !inverted),
            _ => number(at),
        }
    }

    /// Whether "and" or "or" stands in it, inverted or not.
    fn is_combined(&self, at: u32) -> bool {
        match self.node(at) {
            Node::And(..) | Node::Or(..) => true,
            Node::Not(a) => self.is_combined(a),
            _ => false,
        }
    }
}
