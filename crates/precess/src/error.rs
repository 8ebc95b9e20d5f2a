//! What can go wrong between a file and a picture.

use std::fmt;

/// An error that a user sees: one clear sentence.
#[derive(Clone, Debug, PartialEq)]
pub enum Error {
    /// What was asked for makes no sense: what, where, the nearest right thing.
    Input(String),
    /// A file could not be read or written.
    File(String),
    /// The work was begun and could not be ended: what happened, when, what to try.
    Failed(String),
}

impl Error {
    /// Puts the place in front of the sentence (`pendulum.toml, line 3`).
    #[must_use]
    pub fn at(self, place: &str) -> Self {
        match self {
            Self::Input(sentence) => Self::Input(format!("{place}: {sentence}")),
            Self::File(sentence) => Self::File(format!("{place}: {sentence}")),
            Self::Failed(sentence) => Self::Failed(format!("{place}: {sentence}")),
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (Self::Input(sentence) | Self::File(sentence) | Self::Failed(sentence)) = self;
        f.write_str(sentence)
    }
}
impl std::error::Error for Error {}

/// An input error from a sentence.
pub(crate) fn input<T>(sentence: impl Into<String>) -> Result<T, Error> {
    Err(Error::Input(sentence.into()))
}

/// A user's own text, made fit for one line of a message.
pub(crate) fn quoted(text: &str) -> String {
    let mut short: String = text.chars().take(60).flat_map(char::escape_debug).collect();
    if text.chars().count() > 60 {
        short.push('…');
    }
    format!("'{short}'")
}

/// "no parameter 'lenght' in pendulum: did you mean 'l'?", from the names that exist.
pub fn unknown<'a>(what: &str, name: &str, names: impl IntoIterator<Item = &'a str>) -> Error {
    let names: Vec<&str> = names.into_iter().collect();
    let distance = |candidate: &str| {
        let lower = name.to_ascii_lowercase();
        // A name that begins like the one meant is nearer than any other.
        let prefix = candidate.starts_with(&lower) || (!candidate.is_empty() && lower.starts_with(candidate));
        let edits = strsim::damerau_levenshtein(&lower, candidate) * 2;
        if prefix && edits > 1 { edits / 2 } else { edits }
    };
    // A very long name is no misspelling, and the distance is quadratic in its length.
    let nearest = if name.len() > 100 { None } else { names.iter().min_by_key(|n| distance(n)) };
    let hint = match nearest {
        None => "there are none".to_string(),
        Some(n) if names.len() > 1 && distance(n) <= n.len().max(name.len()) => {
            format!("did you mean '{n}'?")
        }
        Some(_) if names.len() <= 12 => format!("known are {}", names.join(", ")),
        Some(n) => format!("did you mean '{n}'?"),
    };
    let hint = if name.len() > 100 { "the name is too long".into() } else { hint };
    Error::Input(format!("no {what} {}: {hint}", quoted(name)))
}
