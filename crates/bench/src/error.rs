//! What can go wrong while measuring.

use std::fmt;

/// One clear sentence.
#[derive(Clone, Debug, PartialEq)]
pub enum Error {
    /// The command was wrong: a name, a set of registers, a peer.
    Wrong(String),
    /// The program was: two sets of registers do not agree.
    Failed(String),
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (Self::Wrong(sentence) | Self::Failed(sentence)) = self;
        f.write_str(sentence)
    }
}
impl std::error::Error for Error {}

impl From<precess::Error> for Error {
    fn from(error: precess::Error) -> Self {
        Self::Wrong(error.to_string())
    }
}
