//! The names of variables: a symbol with a subscript and primes.

use super::Formula;

/// A symbol with its subscript and primes: θ, θ₀, θ′, a₂ₙ₊₁.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Name {
    /// The letter itself, in Unicode; several letters are a word and printed upright.
    pub letter: String,
    /// Subscript.
    pub subscript: Option<Subscript>,
    /// Number of differentiations with respect to time.
    pub primes: u8,
}

/// The subscript of a letter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Subscript {
    /// A word, such as the first letters of an author's name.
    Word(String),
    /// A number or an index.
    Index(Box<Formula>),
}

impl Name {
    /// A symbol without subscript and primes.
    #[doc(hidden)]
    pub fn new(letter: &str) -> Self {
        Self { letter: letter.to_owned(), subscript: None, primes: 0 }
    }

    /// The name with a number or an index as subscript.
    #[doc(hidden)]
    pub fn index(mut self, index: impl Into<Formula>) -> Self {
        self.subscript = Some(Subscript::Index(Box::new(index.into())));
        self
    }

    /// The name with a word as subscript.
    pub(crate) fn word(mut self, word: &str) -> Self {
        self.subscript = Some(Subscript::Word(word.to_owned()));
        self
    }

    /// The name of the next time derivative.
    #[doc(hidden)]
    pub fn prime(mut self) -> Self {
        self.primes += 1;
        self
    }
}

impl From<Name> for Formula {
    fn from(name: Name) -> Self {
        Self::Name(name)
    }
}

impl From<&Name> for Formula {
    fn from(name: &Name) -> Self {
        Self::Name(name.clone())
    }
}
