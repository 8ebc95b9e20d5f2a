//! How a command ends that did not succeed.

use std::io::{self, Write};
use std::process::ExitCode;

/// Why a command did not succeed.
pub enum Failure {
    /// The command was wrong: exit status 2.
    Wrong(String),
    /// The command was right and the run failed: exit status 1.
    Failed(String),
    /// Nobody reads the output any more (`| head`): no failure at all.
    NobodyListens,
}

impl Failure {
    /// Says why on standard error and gives the exit status.
    pub fn report(self) -> ExitCode {
        let (sentence, status) = match self {
            Self::Wrong(sentence) => (sentence, 2),
            Self::Failed(sentence) => (sentence, 1),
            Self::NobodyListens => return ExitCode::SUCCESS,
        };
        // Where even standard error is closed, the exit status says it.
        let _ = writeln!(io::stderr(), "precess: {sentence}");
        ExitCode::from(status)
    }

    /// A failure to write the results.
    pub fn of_writing(place: &str, error: &io::Error) -> Self {
        if error.kind() == io::ErrorKind::BrokenPipe {
            return Self::NobodyListens;
        }
        Self::Failed(format!("cannot write {place}: {}", reason(error)))
    }
}

impl From<precess::Error> for Failure {
    fn from(error: precess::Error) -> Self {
        match error {
            precess::Error::Failed(sentence) => Self::Failed(sentence),
            wrong => Self::Wrong(wrong.to_string()),
        }
    }
}

impl From<precess_bench::Error> for Failure {
    fn from(error: precess_bench::Error) -> Self {
        match error {
            precess_bench::Error::Wrong(sentence) => Self::Wrong(sentence),
            precess_bench::Error::Failed(sentence) => Self::Failed(sentence),
        }
    }
}

/// An error of the operating system without its number.
pub fn reason(error: &io::Error) -> String {
    let text = error.to_string();
    let words = text.split(" (os error").next().unwrap_or(&text);
    let mut letters = words.chars();
    letters.next().map_or(String::new(), |first| first.to_lowercase().chain(letters).collect())
}
