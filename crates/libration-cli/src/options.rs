//! The options of the terminal: `--quiet` and `--color`.

use clap::{ColorChoice, ValueEnum};
use std::ffi::OsString;

/// The terminal's options, taken from a command line before its query is parsed.
///
/// Colours thus also apply to error messages, and a query in a report or a result file does not depend on these options.
#[derive(Debug, Default)]
pub(crate) struct TerminalOptions {
    pub(crate) is_quiet: bool,
    pub(crate) color: ColorChoice,
}

impl TerminalOptions {
    /// Removes the options from the words; options with invalid values stay, and are rejected when the query is parsed.
    pub(crate) fn take(words: &mut Vec<OsString>) -> Self {
        let mut options = Self::default();
        let mut index = 0;
        while index < words.len() && words[index] != "--" {
            let taken = options.read(&words[index..]);
            index += usize::from(taken == 0);
            words.drain(index..index + taken);
        }
        options
    }

    /// Number of words, from the first on, that form an option.
    fn read(&mut self, words: &[OsString]) -> usize {
        let text = |index: usize| words.get(index).and_then(|word| word.to_str()).unwrap_or_default();
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
