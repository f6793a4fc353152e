//! The command line: all queries, with the commands and options of the terminal.

use crate::completions::Completions;
use crate::manual::Manual;
use clap::{Arg, ArgAction, ArgMatches, Args, ColorChoice, Command, FromArgMatches, ValueHint, value_parser};
use libration_queries::{QueryError, Run};
use std::ffi::OsString;
use std::path::PathBuf;

/// The command line, with or without colours in help and error messages.
pub(crate) fn command(color: ColorChoice) -> Command {
    let completions = Completions::augment_args(Command::new("completions"));
    let manual = Manual::augment_args(Command::new("man"));
    with_output(libration_queries::command([completions, manual])).color(color).args(options())
}

/// The identifier of the option `--output` of the terminal; some queries have one of their own.
const OUTPUT: &str = "output_of_terminal";

/// The command line with `--output` for all commands that write to the standard output alone.
fn with_output(command: Command) -> Command {
    if command.has_subcommands() {
        return command.mut_subcommands(with_output);
    }
    let has_its_own = command.get_arguments().any(|argument| argument.get_long() == Some("output"));
    if has_its_own { command } else { command.arg(output()) }
}

fn output() -> Arg {
    Arg::new(OUTPUT)
        .short('o')
        .long("output")
        .value_name("FILE")
        .value_hint(ValueHint::FilePath)
        .value_parser(value_parser!(PathBuf))
        .help(
            "Write to this file instead of standard output, once the result is complete; .json and .csv choose the format where there is one",
        )
}

/// The file that takes the output, of a command without files of its own.
pub(crate) fn output_file(matches: &ArgMatches) -> Option<&PathBuf> {
    innermost(matches).0.try_get_one(OUTPUT).ok().flatten()
}

/// The option for the format that the extension of the file names, with its place among the words, if it is not one of them already.
pub(crate) fn format_by_extension(matches: &ArgMatches) -> Option<(usize, OsString)> {
    let extension = output_file(matches)?.extension()?.to_str()?;
    let (given, depth) = innermost(matches);
    let is_given = |name: &str| matches!(given.try_get_one::<bool>(name), Ok(Some(true)));
    let exists = matches!(given.try_get_one::<bool>(extension), Ok(Some(_)));
    let is_open = exists && FORMATS.contains(&extension) && !FORMATS.iter().any(|format| is_given(format));
    is_open.then(|| (depth, OsString::from(format!("--{extension}"))))
}

/// The options of format that an extension can choose.
const FORMATS: [&str; 2] = ["json", "csv"];

/// The parameters of the command, and the number of words that name it.
fn innermost(matches: &ArgMatches) -> (&ArgMatches, usize) {
    let (mut inner, mut depth) = (matches, 0);
    while let Some((_, below)) = inner.subcommand() {
        (inner, depth) = (below, depth + 1);
    }
    (inner, depth)
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

/// Writes the result of a command, to its file if it has one.
pub(crate) fn write(run: &Run, matches: &ArgMatches, program: &mut Command) -> Result<(), QueryError> {
    let file = output_file(matches).map(PathBuf::as_path);
    match matches.subcommand() {
        Some(("completions", given)) => {
            let completions: Completions = read(given)?;
            run.write_by(file, |out| completions.write(program, out))
        }
        Some(("man", given)) => {
            let manual: Manual = read(given)?;
            run.write_by(file, |out| manual.write(program, out))
        }
        _ => run.write(matches, file),
    }
}

fn read<C: FromArgMatches>(matches: &ArgMatches) -> Result<C, QueryError> {
    C::from_arg_matches(matches).map_err(|error| QueryError::refused(&error))
}
