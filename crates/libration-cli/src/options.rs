//! The options of the terminal: `--quiet` and `--color`.

use clap::{ColorChoice, ValueEnum};
use std::ffi::OsString;

/// The options of the terminal, taken out of a command line before its query is read.
///
/// A refusal has colours too, and a query in a report or a file of results is the same with and without them.
#[derive(Debug, Default)]
pub(crate) struct TerminalOptions {
    pub(crate) is_quiet: bool,
    pub(crate) color: ColorChoice,
}

impl TerminalOptions {
    /// Takes the options out of the words; those with a value that is not possible stay, and are refused with them.
    pub(crate) fn take(words: &mut Vec<OsString>) -> Self {
        let mut options = Self::default();
        let mut place = 0;
        while place < words.len() && words[place] != "--" {
            let taken = options.read(&words[place..]);
            place += usize::from(taken == 0);
            words.drain(place..place + taken);
        }
        options
    }

    /// The number of words, from the first on, that state an option.
    fn read(&mut self, words: &[OsString]) -> usize {
        let text = |place: usize| words.get(place).and_then(|it| it.to_str()).unwrap_or_default();
        let (value, length) = match text(0) {
            "-q" | "--quiet" => {
                self.is_quiet = true;
                return 1;
            }
            "--color" => (text(1), 2),
            word => (word.strip_prefix("--color=").unwrap_or_default(), 1),
        };
        match ColorChoice::from_str(value, true) {
            Ok(color) => {
                self.color = color;
                length
            }
            Err(_) => 0,
        }
    }
}
