//! The program: command line, standard output, exit status.

use crate::command;
use crate::heartbeat::Heartbeat;
use crate::options::TerminalOptions;
use crate::terminal::Terminal;
use clap::{ArgMatches, Command};
use libration_queries::{QueryError, Run, refusal};
use std::ffi::OsString;
use std::io::{Write, stderr, stdout};
use std::sync::Arc;

/// Runs a command line, given without the name of the program, on the standard streams; returns the exit status.
///
/// The first Ctrl-C cancels long work and keeps the completed part; the second ends the process at once.
pub fn program(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    let mut words: Vec<OsString> = arguments.into_iter().collect();
    let options = TerminalOptions::take(&mut words);
    let mut command = command::command(options.color);
    let terminal = Arc::new(Terminal::new(options.is_quiet));
    let run = Run::new(words, terminal.clone());
    match run.matches(&mut command) {
        Ok(matches) => {
            written(&run, &matches, &mut command, &terminal).map_or_else(|error| report(&error), |()| 0)
        }
        Err(error) => refuse(&error),
    }
}

fn written(
    run: &Run,
    matches: &ArgMatches,
    program: &mut Command,
    terminal: &Arc<Terminal>,
) -> Result<(), QueryError> {
    if let Some(written) = command::written(matches, program, &mut stdout()) {
        return written;
    }
    let heartbeat = Heartbeat::begin(terminal);
    let written = run.write(matches);
    heartbeat.end();
    written
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
