//! A tape as a list that others can read.

use super::Tape;
use super::node::Node;

/// One entry of a tape; operands are positions of earlier entries.
#[derive(Clone, Debug, PartialEq)]
pub enum Entry {
    /// A literal.
    Constant(f64),
    /// The input of this number.
    Input(usize),
    /// A whole power.
    Power(usize, i32),
    /// Any other operation: `sin`, `add`, `less`, `select` (condition, then, else).
    Operation(String, Vec<usize>),
}

impl Tape {
    /// All entries in order.
    pub fn entries(&self) -> impl Iterator<Item = Entry> + '_ {
        self.nodes.iter().map(|&node| {
            let name = match node {
                Node::Constant(bits) => return Entry::Constant(f64::from_bits(bits)),
                Node::Input(k) => return Entry::Input(k as usize),
                Node::Power(a, n) => return Entry::Power(a as usize, n),
                Node::Unary(f, _) => format!("{f:?}"),
                Node::Binary(f, _, _) => format!("{f:?}"),
                Node::Less(..) => "less".into(),
                Node::LessOrEqual(..) => "less_or_equal".into(),
                Node::And(..) => "and".into(),
                Node::Or(..) => "or".into(),
                Node::Not(..) => "not".into(),
                Node::Select(..) => "select".into(),
            };
            Entry::Operation(name.to_lowercase(), node.operands().map(|at| at as usize).collect())
        })
    }
}
