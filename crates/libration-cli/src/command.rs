//! The command line: all queries, with the commands and options of the terminal.

use crate::completions::Completions;
use crate::manual::Manual;
use clap::{Arg, ArgAction, ArgMatches, Args, ColorChoice, Command, FromArgMatches, value_parser};
use libration_queries::QueryError;
use std::io::Write;

/// The command line, with or without colours in help and error messages.
pub(crate) fn command(color: ColorChoice) -> Command {
    let completions = Completions::augment_args(Command::new("completions"));
    let manual = Manual::augment_args(Command::new("man"));
    libration_queries::command([completions, manual]).color(color).args(options())
}

/// The terminal's options, which every command has; `TerminalOptions` reads them.
fn options() -> [Arg; 2] {
    let quiet = Arg::new("quiet")
        .short('q')
        .long("quiet")
        .action(ArgAction::SetTrue)
        .help("Show no notes and no progress");
    let color = Arg::new("color")
        .long("color")
        .value_name("WHEN")
        .value_parser(value_parser!(ColorChoice))
        .hide_possible_values(true)
        .help("Colours of help and errors: always, never, or auto, which heeds NO_COLOR");
    [quiet.global(true), color.global(true)]
}

/// Writes the result of a terminal command; `None` if the words name a query.
pub(crate) fn written(
    matches: &ArgMatches,
    program: &mut Command,
    out: &mut dyn Write,
) -> Option<Result<(), QueryError>> {
    match matches.subcommand()? {
        ("completions", given) => Some(read::<Completions>(given).and_then(|it| it.write(program, out))),
        ("man", given) => Some(read::<Manual>(given).and_then(|it| it.write(program, out))),
        _ => None,
    }
}

fn read<C: FromArgMatches>(matches: &ArgMatches) -> Result<C, QueryError> {
    C::from_arg_matches(matches).map_err(|error| QueryError::refused(&error))
}
