//! The program: command line, standard output, exit status.

use crate::command;
use crate::heartbeat::Heartbeat;
use crate::options::TerminalOptions;
use crate::terminal::Terminal;
use clap::{ArgMatches, Command};
use libration_queries::{QueryError, Run, refusal};
use std::ffi::OsString;
use std::io::{Write, stderr};
use std::sync::Arc;

/// Runs a command line, given without the name of the program, on the standard streams; returns the exit status.
///
/// The first Ctrl-C cancels long work and keeps the completed part; the second ends the process at once.
pub fn program(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    let mut words: Vec<OsString> = arguments.into_iter().collect();
    let options = TerminalOptions::take(&mut words);
    let mut command = command::command(options.color);
    if words
        .iter()
        .filter_map(|word| word.to_str())
        .any(|argument| argument.starts_with("-o") || argument.starts_with("--output"))
    {
        // What is noted about these words is noted when they are read again.
        let read = Reading::new(words.clone(), true, &mut command);
        words = read.with_format_of_file().unwrap_or(words);
    }
    let read = Reading::new(words, options.is_quiet, &mut command);
    match &read.matches {
        Ok(matches) => read.written(matches, &mut command).map_or_else(|error| report(&error), |()| 0),
        Err(error) => refuse(error),
    }
}

/// A command line that was read.
struct Reading {
    words: Vec<OsString>,
    terminal: Arc<Terminal>,
    run: Run,
    matches: Result<ArgMatches, clap::Error>,
}

impl Reading {
    fn new(words: Vec<OsString>, is_quiet: bool, command: &mut Command) -> Self {
        let terminal = Arc::new(Terminal::new(is_quiet));
        let run = Run::new(words.clone(), terminal.clone());
        let matches = run.matches(command);
        Self { words, terminal, run, matches }
    }

    /// The words with the option for the format that the extension of the file names.
    fn with_format_of_file(&self) -> Option<Vec<OsString>> {
        let (index, option) = command::format_by_extension(self.matches.as_ref().ok()?)?;
        let mut words = self.words.clone();
        words.insert(index, option);
        Some(words)
    }

    fn written(&self, matches: &ArgMatches, program: &mut Command) -> Result<(), QueryError> {
        let heartbeat = Heartbeat::begin(&self.terminal);
        let written = command::write(&self.run, matches, program);
        heartbeat.end();
        written
    }
}

/// Shows the help, or clap's error message.
fn refuse(error: &clap::Error) -> u8 {
    let shown = refusal(error);
    // A closed stream needs no further action.
    let _ = match !error.use_stderr() || shown == error.render().to_string() {
        true => error.print(),
        false => write!(stderr(), "{shown}"),
    };
    u8::try_from(error.exit_code()).unwrap_or(1)
}

/// Writes the message to the error stream and returns the exit status.
fn report(error: &QueryError) -> u8 {
    if !error.is_closed_pipe() {
        // A closed error stream needs no further action.
        let _ = writeln!(stderr(), "error: {error}");
    }
    error.status()
}
