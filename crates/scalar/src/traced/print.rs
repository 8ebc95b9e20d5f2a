//! Printing a tape.

use super::Tape;
use super::view::View;

/// How an expression is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Notation {
    /// In ASCII, for a terminal or a calculator: `-b * theta' - g / l * sin(theta)`.
    Text,
    /// For `KaTeX`, `MathJax` or LaTeX in mathematics mode.
    Latex,
}

/// A printed tape.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Printed {
    /// Names of long shared sub-expressions with their meaning, each using only earlier ones.
    pub definitions: Vec<(String, String)>,
    /// One expression for each output.
    pub outputs: Vec<String>,
}

/// Expressions longer than this are printed with definitions.
const LINE: usize = 40;

impl Tape {
    /// The expressions of the outputs, with a name for each input in the same notation.
    ///
    /// [Simplify](Self::simplified) a tape first unless every operation is to be seen.
    pub fn print(&self, names: &[String], notation: Notation) -> Printed {
        let mut view = View::new(self, names, notation);
        let nodes = view.define(&self.shared());
        let outputs = self.outputs.iter().map(|&at| view.output(at)).collect();
        Printed { definitions: view.definitions(nodes), outputs }
    }

    /// The expression of one node (see [`evaluate_with`](Self::evaluate_with)) as text, for a message.
    ///
    /// # Panics
    /// If there is no such node.
    pub fn text_of(&self, node: usize, names: &[String]) -> String {
        let mut view = View::new(self, names, Notation::Text);
        if self.lengths()[node] <= LINE {
            return view.whole(node as u32);
        }
        let needed = self.needed_by(&[node as u32]);
        let shared: Vec<bool> = self.shared().iter().zip(needed).map(|(&a, b)| a && b).collect();
        let definitions = view.define(&shared).into_iter().filter(|&at| at as usize != node);
        let mut parts = vec![view.whole(node as u32)];
        for (name, meaning) in view.definitions(definitions) {
            let link = if parts.len() == 1 { "where " } else { "" };
            parts.push([link, &name, " = ", &meaning].concat());
        }
        parts.join(", ")
    }
}
