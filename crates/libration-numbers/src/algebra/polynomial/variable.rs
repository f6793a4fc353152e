//! The unknowns of a polynomial: letters with an optional index.

use std::cmp::Ordering;
use std::fmt;
use std::sync::Arc;

/// A variable of a [`Polynomial`](super::Polynomial): letters, possibly with an index, such as `a1`, `B3` or `Delta`. Variables are ordered as
/// in the index of a book: by letter regardless of case, then by number: a1, a3, a11, B3, Delta.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Variable {
    letters: Arc<str>,
    index: Option<u32>,
}

impl Variable {
    /// The variable with these letters and this index.
    #[must_use]
    pub fn indexed(letters: &str, index: u32) -> Self {
        Self { letters: letters.into(), index: Some(index) }
    }

    /// The name without its index.
    #[must_use]
    pub fn letters(&self) -> &str {
        &self.letters
    }

    /// The index at the end of the name.
    #[must_use]
    pub const fn index(&self) -> Option<u32> {
        self.index
    }

    /// The name in LaTeX: `a_1`, `B_{11}`, `\Delta`.
    #[must_use]
    pub fn to_latex(&self) -> String {
        let letters = latex_letters(&self.letters);
        match self.index {
            None => letters,
            Some(index @ 0..=9) => format!("{letters}_{index}"),
            Some(index) => format!("{letters}_{{{index}}}"),
        }
    }

    fn book_order(&self) -> (String, Option<u32>, &str) {
        (self.letters.to_lowercase(), self.index, &self.letters)
    }
}

/// The digits at the end become the index, unless they begin with a superfluous zero.
impl From<&str> for Variable {
    fn from(name: &str) -> Self {
        let letters = name.trim_end_matches(|letter: char| letter.is_ascii_digit());
        match name[letters.len()..].parse::<u32>() {
            Ok(index) if format!("{letters}{index}") == name => Self::indexed(letters, index),
            _ => Self { letters: name.into(), index: None },
        }
    }
}

/// Writes `a1`, for example.
impl fmt::Display for Variable {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.letters)?;
        self.index.map_or(Ok(()), |index| write!(formatter, "{index}"))
    }
}

impl Ord for Variable {
    fn cmp(&self, other: &Self) -> Ordering {
        if self == other { Ordering::Equal } else { self.book_order().cmp(&other.book_order()) }
    }
}

impl PartialOrd for Variable {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

fn latex_letters(letters: &str) -> String {
    const GREEK: [&str; 12] = [
        "alpha", "beta", "gamma", "delta", "Delta", "epsilon", "theta", "lambda", "mu", "nu", "omega",
        "Omega",
    ];
    if GREEK.contains(&letters) {
        format!("\\{letters}")
    } else if letters.chars().count() > 1 {
        format!("\\mathrm{{{letters}}}")
    } else {
        letters.to_owned()
    }
}
