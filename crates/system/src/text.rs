//! A text in the languages of the laboratory.

/// The same sentence in English and in French.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Text {
    /// English.
    pub en: String,
    /// French.
    pub fr: String,
}

impl Text {
    /// Both languages at once, so that neither is forgotten.
    pub fn new(en: &str, fr: &str) -> Self {
        Self { en: en.into(), fr: fr.into() }
    }
    /// True where a language is missing.
    pub fn is_incomplete(&self) -> bool {
        self.en.trim().is_empty() || self.fr.trim().is_empty()
    }
}
