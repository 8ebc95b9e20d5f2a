//! Which sub-expressions deserve a name of their own.
//!
//! One that is written several times and is long does: what naming it saves must outweigh reading its
//! name. So does a choice between cases inside something else, which no line of text holds well.

use super::Tape;
use super::node::{Node, Unary};

/// Shorter than this, in symbols and operations, stays where it is.
const LONG: usize = 6;
/// So many symbols and operations must be saved.
const SAVED: usize = 8;

impl Tape {
    /// For each node, whether it is printed by a name.
    pub(super) fn shared(&self) -> Vec<bool> {
        let uses = self.uses();
        let chosen = self.nested_choices();
        let mut named = vec![false; self.nodes.len()];
        let mut weights: Vec<usize> = vec![0; self.nodes.len()];
        for (i, &node) in self.nodes.iter().enumerate() {
            let weight = weight(node, &weights);
            let saved = (weight - 1) * uses[i].saturating_sub(1);
            named[i] = is_number(node) && (weight >= LONG && saved >= SAVED || chosen[i]);
            weights[i] = if named[i] { 1 } else { weight };
        }
        named
    }

    /// How long each node is when nothing has a name.
    pub(super) fn lengths(&self) -> Vec<usize> {
        let mut lengths = Vec::with_capacity(self.nodes.len());
        for &node in &self.nodes {
            lengths.push(weight(node, &lengths));
        }
        lengths
    }

    /// By how many nodes and outputs each node is used; `x * x`, printed as a square, uses `x` once.
    fn uses(&self) -> Vec<usize> {
        let mut uses = vec![0; self.nodes.len()];
        for &node in &self.nodes {
            let mut last = None;
            for at in node.operands().filter(|&at| last.replace(at) != Some(at)) {
                uses[at as usize] += 1;
            }
        }
        for &at in &self.outputs {
            uses[at as usize] += 1;
        }
        uses
    }

    /// The selections that stand inside another expression, other than as "otherwise" of a selection.
    fn nested_choices(&self) -> Vec<bool> {
        let mut nested = vec![false; self.nodes.len()];
        for &node in &self.nodes {
            let otherwise = if let Node::Select(_, _, b) = node { Some(b) } else { None };
            for at in node.operands().filter(|&at| Some(at) != otherwise) {
                nested[at as usize] |= matches!(self.nodes[at as usize], Node::Select(..));
            }
        }
        nested
    }
}

fn is_number(node: Node) -> bool {
    !matches!(node, Node::Less(..) | Node::LessOrEqual(..) | Node::And(..) | Node::Or(..) | Node::Not(_))
}

fn weight(node: Node, weights: &[usize]) -> usize {
    let own = usize::from(!matches!(node, Node::Unary(Unary::Neg, _)));
    match node {
        Node::Binary(_, a, b) if a == b => own + weights[a as usize],
        _ => node.operands().fold(own, |sum, at| sum.saturating_add(weights[at as usize])),
    }
}
