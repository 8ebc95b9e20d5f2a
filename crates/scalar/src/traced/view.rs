//! A tape as a reader sees it: names, sums of products.

use super::node::{Binary, Node};
use super::product::Product;
use super::{Notation, Tape};

/// A tape as it is being printed.
pub(super) struct View<'a> {
    tape: &'a Tape,
    inputs: &'a [String],
    names: Vec<Option<String>>,
    pub(super) notation: Notation,
}

impl<'a> View<'a> {
    pub(super) fn new(tape: &'a Tape, inputs: &'a [String], notation: Notation) -> Self {
        Self { tape, inputs, names: vec![None; tape.nodes.len()], notation }
    }

    /// Gives names to these nodes, none of them an input's.
    pub(super) fn define(&mut self, shared: &[bool]) -> Vec<u32> {
        let mut count = 0;
        let nodes: Vec<u32> = (0..).zip(shared).filter_map(|(at, &shared)| shared.then_some(at)).collect();
        for &at in &nodes {
            let name = loop {
                count += 1;
                let name = match self.notation {
                    Notation::Text => format!("s{count}"),
                    Notation::Latex if count < 10 => format!("s_{count}"),
                    Notation::Latex => format!("s_{{{count}}}"),
                };
                if !self.inputs.contains(&name) {
                    break name;
                }
            };
            self.names[at as usize] = Some(name);
        }
        nodes
    }

    /// The names of these nodes with what they stand for.
    pub(super) fn definitions(&mut self, nodes: impl IntoIterator<Item = u32>) -> Vec<(String, String)> {
        let name = |view: &Self, at| view.name(at).unwrap_or_default();
        nodes.into_iter().map(|at| (name(self, at), self.whole(at))).collect()
    }

    /// An expression itself, even if it has a name.
    pub(super) fn whole(&mut self, at: u32) -> String {
        let name = self.names[at as usize].take();
        let text = self.output(at);
        self.names[at as usize] = name;
        text
    }

    /// An expression, or its name.
    pub(super) fn output(&self, at: u32) -> String {
        match (self.node(at), self.notation) {
            (Node::Less(..) | Node::LessOrEqual(..) | Node::And(..) | Node::Or(..) | Node::Not(_), _) => {
                self.condition(at)
            }
            (_, Notation::Text) => self.text(at),
            (_, Notation::Latex) => self.latex(at),
        }
    }

    pub(super) fn node(&self, at: u32) -> Node {
        self.tape.nodes[at as usize]
    }

    /// The name of an input or of a definition.
    pub(super) fn name(&self, at: u32) -> Option<String> {
        match self.node(at) {
            Node::Input(i) => Some(self.inputs.get(i as usize).cloned().unwrap_or_else(|| format!("x_{i}"))),
            _ => self.names[at as usize].clone(),
        }
    }

    /// A node as a sum of products, in the order written.
    pub(super) fn terms(&self, mut at: u32) -> Vec<Product> {
        let mut last_first = Vec::new();
        loop {
            match self.node(at) {
                Node::Binary(Binary::Add, a, b) if self.name(at).is_none() => {
                    last_first.extend(self.terms(b).into_iter().rev());
                    at = a;
                }
                Node::Binary(Binary::Sub, a, b) if self.name(at).is_none() => {
                    let mut product = self.product(b);
                    product.negative ^= true;
                    last_first.push(product);
                    at = a;
                }
                _ => break,
            }
        }
        last_first.push(self.product(at));
        last_first.reverse();
        last_first
    }

    /// Joins terms with their signs.
    pub(super) fn sum(&self, at: u32, write: impl Fn(Product) -> String) -> String {
        let mut text = String::new();
        for term in self.terms(at) {
            text += match (term.negative, text.is_empty()) {
                (true, true) => "-",
                (true, false) => " - ",
                (false, true) => "",
                (false, false) => " + ",
            };
            text += &write(term);
        }
        text
    }

    /// Whether a node is written as a sum.
    pub(super) fn is_sum(&self, at: u32) -> bool {
        self.name(at).is_none() && matches!(self.node(at), Node::Binary(Binary::Add | Binary::Sub, ..))
    }
}
