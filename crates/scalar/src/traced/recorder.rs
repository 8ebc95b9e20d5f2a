//! The tapes being recorded on this thread: equal operations are recorded once.

use super::node::Node;
use super::{algebra, exact};
use std::cell::{Cell, RefCell};
use std::collections::HashMap;

/// What may be folded while recording.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Rules {
    /// Only what leaves every bit of the result as it is.
    Exact,
    /// What is true of real numbers.
    Algebraic,
}

/// A tape that grows.
pub(super) struct Recorder {
    pub(super) serial: u32,
    rules: Rules,
    nodes: Vec<Node>,
    /// For look-up only: the order of a `HashMap` must not reach any result.
    known: HashMap<Node, u32>,
}

thread_local! {
    static RECORDERS: RefCell<Vec<Recorder>> = const { RefCell::new(Vec::new()) };
    static SERIAL: Cell<u32> = const { Cell::new(0) };
}

impl Recorder {
    /// The node that computes this: an old one, a simpler one or a new one.
    pub(super) fn push(&mut self, node: Node) -> u32 {
        if let Some(simpler) = exact::fold(self, node) {
            return simpler;
        }
        if self.rules == Rules::Algebraic
            && let Some(simpler) = algebra::fold(self, node)
        {
            return simpler;
        }
        let Self { nodes, known, .. } = self;
        *known.entry(node.key()).or_insert_with(|| {
            nodes.push(node);
            nodes.len() as u32 - 1
        })
    }
    pub(super) fn literal(&mut self, x: f64) -> u32 {
        self.push(Node::constant(x))
    }
    pub(super) fn node(&self, at: u32) -> Node {
        self.nodes[at as usize]
    }
    /// The value of a node that is a literal.
    pub(super) fn value(&self, at: u32) -> Option<f64> {
        match self.node(at) {
            Node::Constant(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }
}

/// Does something with the innermost recording of this thread.
pub(super) fn with<R>(f: impl FnOnce(&mut Recorder) -> R) -> R {
    RECORDERS.with_borrow_mut(|stack| {
        let recorder = stack.last_mut();
        f(recorder.expect("a traced number was used where nothing records: use it inside Tape::record only"))
    })
}

/// A recording in progress; dropping it, a panic included, ends it.
pub(super) struct Recording {
    depth: usize,
}

impl Recording {
    pub(super) fn start(rules: Rules) -> Self {
        let serial = SERIAL.replace(SERIAL.get().wrapping_add(1));
        RECORDERS.with_borrow_mut(|stack| {
            stack.push(Recorder { serial, rules, nodes: Vec::new(), known: HashMap::new() });
            Self { depth: stack.len() - 1 }
        })
    }
    /// Ends it and gives what was recorded.
    pub(super) fn finish(self) -> Vec<Node> {
        RECORDERS.with_borrow_mut(|stack| stack.drain(self.depth..).next().map_or(Vec::new(), |r| r.nodes))
    }
}

impl Drop for Recording {
    fn drop(&mut self) {
        RECORDERS.with_borrow_mut(|stack| stack.truncate(self.depth));
    }
}
