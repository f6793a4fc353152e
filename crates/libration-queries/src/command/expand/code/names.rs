//! Names in the functions of an expansion.

use crate::output::language::{FreeNames, Language};

/// The names of letters and variables, changed where the language has them for itself.
pub(super) struct Names {
    /// Each letter with its name in the program.
    pub(super) letters: Vec<(String, String)>,
    /// The name of ω0 in coefficients, and its name in the program.
    pub(super) root: Option<(String, String)>,
    arguments: Vec<(&'static str, String)>,
    pub(super) sum: String,
    pub(super) phase: String,
    pub(super) displacement: String,
}

impl Names {
    pub(super) fn new(language: Language, letters: &[String], root: Option<&str>) -> Self {
        let mut names = FreeNames::new(language);
        let mut free = |name: &str| names.free(name);
        let letters = letters.iter().map(|letter| (letter.clone(), free(letter))).collect();
        let root = root.map(|name| (name.to_owned(), free(name)));
        let arguments = ["amplitude", "strength", "time"].map(|name| (name, free(name))).to_vec();
        let (sum, phase, displacement) = (free("series"), free("phase"), free("x"));
        Self { letters, root, arguments, sum, phase, displacement }
    }

    /// The name of a letter in the program.
    pub(super) fn letter(&self, name: &str) -> String {
        let mut letters = self.letters.iter().chain(&self.root);
        letters
            .find(|(letter, _)| letter == name)
            .map_or_else(|| name.to_owned(), |(_, changed)| changed.clone())
    }

    /// The name of an argument that is not a letter.
    pub(super) fn argument(&self, name: &str) -> String {
        let argument = self.arguments.iter().find(|(letter, _)| *letter == name);
        argument.map_or_else(|| name.to_owned(), |(_, changed)| changed.clone())
    }
}
