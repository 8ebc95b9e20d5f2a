//! A number that writes down what is done with it.
//!
//! Run an equation on [`Traced`] inside [`Tape::record`] and the [`Tape`] holds the expression. It replays on
//! any other number (to the bit on `f64`), tells what depends on what, and prints itself as text or LaTeX.
//!
//! * `number` is the number the equation sees, `node` what one operation is,
//! * `recorder` shares equal operations, `exact` and `algebra` fold what folds,
//! * `tape` is the finished expression, `replay` runs it, `taylor` expands the solution of an equation with it,
//! * `listing` shows it to others,
//! * `print` asks `definitions` what deserves a name, `view`, `product` and `constant` how terms are arranged,
//!   and `text` or `latex` (and `condition` for both) to write them.

mod algebra;
mod condition;
mod constant;
mod definitions;
mod exact;
mod latex;
mod listing;
mod node;
mod number;
mod print;
mod product;
mod recorder;
mod replay;
mod tape;
mod taylor;
mod text;
mod view;

pub use listing::Entry;
pub use number::Traced;
pub use print::{Notation, Printed};
pub use replay::Workspace;
pub use tape::Tape;
pub use taylor::Taylor;
