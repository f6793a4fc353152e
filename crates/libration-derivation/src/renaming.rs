//! Other symbols for those of an equation that have another meaning in a derivation.

use crate::check::DerivationError;
use crate::document::Block;
use crate::formula::{Formula, Name};
use crate::prose::Prose;
use libration::expression::Symbol;
use std::str::FromStr;

/// Symbols that no derivation has.
const FREE: [&str; 10] = ["alpha", "beta", "gamma", "kappa", "mu", "nu", "rho", "sigma", "chi", "eta"];

/// The symbols of an equation that are replaced, each with the one in its place.
#[derive(Debug, Default)]
pub(crate) struct Renaming(Vec<(String, String)>);

impl Renaming {
    /// Free symbols with the same numbers, other than the variable, for those that are taken.
    pub(crate) fn new<'a>(
        symbols: impl Iterator<Item = &'a String> + Clone,
        variable: &str,
        is_taken: impl Fn(&str) -> bool,
    ) -> Result<Self, DerivationError> {
        let mut renaming = Self::default();
        for given in symbols.clone().filter(|name| is_taken(name)) {
            let number = given.trim_start_matches(|c: char| !c.is_ascii_digit());
            let is_free = |name: &String| {
                name != variable
                    && !is_taken(name)
                    && symbols.clone().all(|other| other != name)
                    && renaming.0.iter().all(|(_, written)| written != name)
            };
            let written = FREE.iter().map(|letter| format!("{letter}{number}")).find(is_free);
            let taken = || DerivationError::TakenLetter { letter: given.clone() };
            renaming.0.push((given.clone(), written.ok_or_else(taken)?));
        }
        Ok(renaming)
    }

    /// Returns `true` if nothing is replaced.
    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// An equation or a formula in the other symbols.
    pub(crate) fn of<T: ToString + FromStr>(&self, formula: &T) -> Result<T, DerivationError> {
        let what = "a formula and the same with other symbols";
        self.replaced(&formula.to_string()).parse().map_err(|_| DerivationError::Disagreement { what })
    }

    /// A text in which names are replaced.
    pub(crate) fn replaced(&self, text: &str) -> String {
        let is_inside = |c: char| c.is_alphanumeric() || c == '_';
        let (mut written, mut rest) = (String::new(), text);
        while let Some(first) = rest.chars().next() {
            let length = match first {
                first if is_inside(first) => rest.find(|c| !is_inside(c)).unwrap_or(rest.len()),
                other => other.len_utf8(),
            };
            let (word, after) = rest.split_at(length);
            let other = self.0.iter().find(|(given, _)| given == word);
            written.push_str(other.map_or(word, |(_, other)| other));
            rest = after;
        }
        written
    }

    /// A paragraph for each symbol that is replaced.
    pub(crate) fn told(&self) -> impl Iterator<Item = Block> {
        let formula = |name: &str| Formula::from(Name::from(&Symbol::plain(name)));
        self.0.iter().map(move |(given, written)| {
            let (given, written) = (formula(given), formula(written));
            let sentence =
                "The symbol {} of the given equation is written {}, as {} has another meaning here.";
            Block::Paragraph(Prose::new(sentence, [given.clone(), written, given]))
        })
    }
}
