//! A recorded expression.

use super::Traced;
use super::node::{Node, Unary};
use super::recorder::{Recording, Rules};
use std::convert::Infallible;

/// An expression: what was done with the inputs, each operation once, up to the outputs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tape {
    pub(super) inputs: usize,
    pub(super) nodes: Vec<Node>,
    pub(super) outputs: Vec<u32>,
}

impl Tape {
    /// Records what `f` does with this many inputs.
    ///
    /// Recordings nest, and a tape may be [evaluated](Self::evaluate) on [`Traced`] inside another recording.
    /// Only what leaves each `f64` bit alone is folded; operations that reach no output are dropped. Literals
    /// combine as `f64`: to a replay with more digits, `1 / 3` has no more of them than `0.1` has.
    pub fn record(inputs: usize, f: impl FnOnce(&[Traced]) -> Vec<Traced>) -> Self {
        let Ok(tape) = Self::record_by(Rules::Exact, inputs, |x| Ok::<_, Infallible>(f(x)));
        tape
    }

    /// As [`record`](Self::record), for a function that may fail, such as a parser of typed-in equations.
    ///
    /// # Errors
    /// The error of `f`.
    pub fn try_record<E>(
        inputs: usize,
        f: impl FnOnce(&[Traced]) -> Result<Vec<Traced>, E>,
    ) -> Result<Self, E> {
        Self::record_by(Rules::Exact, inputs, f)
    }

    /// The expression for reading: folded by what is true of real numbers (`0 x = 0`, `a + (-b) = a - b`).
    ///
    /// Its values agree to rounding wherever no intermediate value is infinite, undefined or on a cut (the
    /// sign of a zero, which `atan2` tells, may be lost).
    #[must_use]
    pub fn simplified(&self) -> Self {
        let Ok(tape) =
            Self::record_by(Rules::Algebraic, self.inputs, |x| Ok::<_, Infallible>(self.evaluate(x)));
        tape
    }

    fn record_by<E>(
        rules: Rules,
        inputs: usize,
        f: impl FnOnce(&[Traced]) -> Result<Vec<Traced>, E>,
    ) -> Result<Self, E> {
        let recording = Recording::start(rules);
        let x: Vec<Traced> = (0..inputs).map(Traced::input).collect();
        let outputs = f(&x)?.into_iter().map(Traced::position).collect();
        let nodes = recording.finish();
        Ok(Self { inputs, nodes, outputs }.compacted())
    }

    /// Without the nodes that no output needs, and with the sine and the cosine of an angle side by side.
    fn compacted(self) -> Self {
        const GONE: u32 = u32::MAX;
        let needed = self.needed_by(&self.outputs);
        let mut partner = vec![(None, None); self.nodes.len()];
        for (i, &node) in self.nodes.iter().enumerate().filter(|&(i, _)| needed[i]) {
            match node {
                Node::Unary(Unary::Sin, a) => partner[a as usize].0 = Some(i),
                Node::Unary(Unary::Cos, a) => partner[a as usize].1 = Some(i),
                _ => {}
            }
        }
        let mut place = vec![GONE; self.nodes.len()];
        let mut nodes = Vec::new();
        for (i, &node) in self.nodes.iter().enumerate().filter(|&(i, _)| needed[i]) {
            let group = match node {
                Node::Unary(Unary::Sin | Unary::Cos, a) => partner[a as usize],
                _ => (Some(i), None),
            };
            for j in [group.0, group.1].into_iter().flatten().filter(|&j| needed[j]) {
                if place[j] == GONE {
                    place[j] = nodes.len() as u32;
                    nodes.push(self.nodes[j].renumbered(|at| place[at as usize]));
                }
            }
        }
        let outputs = self.outputs.iter().map(|&at| place[at as usize]).collect();
        Self { inputs: self.inputs, nodes, outputs }
    }

    /// For each node, whether one of these is computed from it.
    pub(super) fn needed_by(&self, roots: &[u32]) -> Vec<bool> {
        let mut needed = vec![false; self.nodes.len()];
        for &root in roots {
            needed[root as usize] = true;
        }
        for i in (0..self.nodes.len()).rev() {
            if needed[i] {
                self.nodes[i].operands().for_each(|at| needed[at as usize] = true);
            }
        }
        needed
    }

    /// For each node, whether an output is computed from it other than by a condition.
    pub(super) fn beside_conditions(&self) -> Vec<bool> {
        let mut needed = vec![false; self.nodes.len()];
        for &root in &self.outputs {
            needed[root as usize] = true;
        }
        for i in (0..self.nodes.len()).rev() {
            match self.nodes[i] {
                _ if !needed[i] => {}
                Node::Select(_, a, b) => (needed[a as usize], needed[b as usize]) = (true, true),
                node => node.operands().for_each(|at| needed[at as usize] = true),
            }
        }
        needed
    }

    /// Whether an output is computed from an input (as written: `0 * x` depends on `x`).
    ///
    /// # Panics
    /// If there is no such output.
    pub fn depends_on(&self, output: usize, input: usize) -> bool {
        let needed = self.needed_by(&[self.outputs[output]]);
        let is_input = |node: &Node| matches!(*node, Node::Input(i) if i as usize == input);
        self.nodes.iter().zip(needed).any(|(node, needed)| needed && is_input(node))
    }

    /// How many inputs it takes.
    pub fn inputs(&self) -> usize {
        self.inputs
    }
    /// The positions of the nodes that are its outputs.
    pub fn outputs(&self) -> impl ExactSizeIterator<Item = usize> + '_ {
        self.outputs.iter().map(|&at| at as usize)
    }
    /// How many nodes there are, inputs and literals that are used included.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }
    /// Whether there is nothing on it.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }
    /// How many operations a replay carries out.
    pub fn operations(&self) -> usize {
        self.nodes.iter().filter(|node| node.is_operation()).count()
    }
}
