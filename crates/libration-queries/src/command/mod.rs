//! The queries, one file or folder each, and the command line that names them.

mod backbone;
mod bifurcation;
mod decay;
mod derive;
pub(crate) mod expand;
mod fields;
pub(crate) mod figure;
mod fit_amplitudes;
mod fit_gates;
mod fit_lengths;
mod fit_periods;
pub(crate) mod fit_report;
mod fit_response;
pub(crate) mod fit_trace;
mod formulas;
mod fourier;
mod inspect;
mod list;
mod lyapunov;
mod melnikov;
mod modes;
mod motion;
mod orbit;
mod oscillators;
pub(crate) mod page;
mod paper;
pub(crate) mod parameter_type;
mod period;
mod plan;
mod registry;
mod resonance;
pub(crate) mod response;
mod section;
pub(crate) mod simulate;
mod stability;
pub(crate) mod sweep;
mod systems;

pub(crate) use sweep::{
    Axis as SweepAxis, Plan as SweepPlanned, SweepRequest, axis as sweep_axis, outcomes as sweep_outcomes,
};

use crate::arguments::{protect_negative_values, sweep_options_first};
use crate::output::description::{Answers, Description};
use crate::query_error::QueryError;
use clap::{ArgMatches, Command, FromArgMatches};
use libration::systems::Model;
use libration::taylor::Ensemble;
use registry::{FAMILIES, HIDDEN, Query, groups};
use std::cell::RefCell;
use std::ffi::OsString;
use std::io::Write;

const ABOUT: &str = "The pendulum at any amplitude, and the oscillators and systems beyond it: exact results, each with its error";

/// The width of all help texts, independent of the terminal, so that examples can be copied as they are printed.
const HELP_WIDTH: usize = 80;

const EXAMPLES: &str = "\
Examples:
  libration period 60deg                     # exact, and by every formula
  libration expand duffing --order 9         # exact perturbation series
  libration simulate pendulum --initial theta=179deg --times 0:20:1
  libration fit trace examples/swing_synthetic.csv --length 0.56m±0.002m

Angles: 60deg, 60°, 1.2rad, 1.2 (radians), pi-1e-6, 180deg-1e-9deg. Tables are
as wide as the terminal, or as COLUMNS says; files and pipes get 80 columns.
Exit status: 0 success, 1 no result, 2 usage error, 130 interrupted.";

/// The command line of all queries, with further commands of a front end.
///
/// # Examples
/// ```
/// let command = libration_queries::command([clap::Command::new("completions")]);
/// assert!(command.find_subcommand("period").is_some() && command.find_subcommand("completions").is_some());
/// ```
#[must_use]
pub fn command(further: impl IntoIterator<Item = Command>) -> Command {
    let further: Vec<Command> = further.into_iter().collect();
    let families = FAMILIES.map(|[word, _, about, examples]| {
        needing_a_command(Command::new(word)).about(about).after_help(examples)
    });
    let program = needing_a_command(Command::new("libration"))
        .version(env!("CARGO_PKG_VERSION"))
        .about(ABOUT)
        .term_width(HELP_WIDTH)
        .after_help(EXAMPLES)
        .help_template(help_template(&further))
        .subcommands(families);
    queries().into_iter().fold(program, with_query).subcommands(further)
}

fn needing_a_command(command: Command) -> Command {
    command.subcommand_required(true).arg_required_else_help(true)
}

fn with_query(program: Command, query: Query) -> Command {
    let is_hidden = query.line == HIDDEN && family(&query).is_none();
    let described = |name: &'static str| (query.with_parameters)(Command::new(name)).hide(is_hidden);
    match query.words.split_once(' ') {
        Some((family, name)) => program.mut_subcommand(family, |family| family.subcommand(described(name))),
        None => program.subcommand(described(query.words)),
    }
}

fn queries() -> Vec<Query> {
    groups().into_iter().flat_map(|(_, queries)| queries).collect()
}

/// The groups of queries as clap's template of the help, with the commands of a front end among the tools.
fn help_template(further: &[Command]) -> String {
    let mut template = "{about}\n\n{usage-heading} {usage}\n".to_owned();
    for (title, queries) in groups() {
        template += &format!("\n{title}:\n");
        let mut lines: Vec<_> = queries.iter().map(help_line).collect();
        lines.dedup();
        template += &lines.concat();
    }
    for command in further {
        let about = command.get_about().map(ToString::to_string).unwrap_or_default();
        template += &line(command.get_name(), &lower_case_first(&about));
    }
    template += &line("help", "help of a command");
    template + "\nOptions:\n{options}{after-help}"
}

/// The line of a query in the help, or of its family.
fn help_line(query: &Query) -> String {
    match (family(query), query.line) {
        (Some([word, text, ..]), _) => line(word, text),
        (None, HIDDEN) => String::new(),
        (None, text) => line(query.words, text),
    }
}

/// The family of a query, if it shares its first word with others.
fn family(query: &Query) -> Option<&'static [&'static str; 4]> {
    FAMILIES.iter().find(|[word, ..]| query.words.split(' ').next() == Some(word))
}

fn line(name: &str, text: &str) -> String {
    format!("  {name:<12} {text}\n")
}

fn lower_case_first(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map(|first| first.to_ascii_lowercase()).into_iter().chain(letters).collect()
}

/// The words of a command line, which begin after the name of the program, as `command` reads them.
pub(crate) fn matches(command: &mut Command, arguments: Vec<OsString>) -> Result<ArgMatches, clap::Error> {
    let named = std::iter::once(OsString::from("libration")).chain(sweep_options_first(arguments));
    command.try_get_matches_from_mut(protect_negative_values(named))
}

/// The matches of a command line in the command line of all queries.
pub(crate) fn matches_of_query(arguments: Vec<OsString>) -> Result<ArgMatches, QueryError> {
    with_command(|command| matches(command, arguments)).map_err(|error| QueryError::refused(&error))
}

/// Passes the command line of all queries to `work`; it is built once on each thread.
pub(crate) fn with_command<R>(work: impl FnOnce(&mut Command) -> R) -> R {
    COMMAND.with(|shared| match shared.try_borrow_mut() {
        Ok(mut shared) => work(&mut shared),
        // A host that runs a query while it receives a note on how another was read.
        Err(_) => work(&mut command([])),
    })
}

thread_local! {
    // It takes longer to build than many queries take.
    static COMMAND: RefCell<Command> = RefCell::new(command([]));
}

/// Writes the result of the query that was read.
pub(crate) fn write(matches: &ArgMatches, out: &mut dyn Write) -> Result<(), QueryError> {
    let (words, parameters) = read(matches);
    let query = queries().into_iter().find(|query| query.words == words);
    let query = query.ok_or_else(|| QueryError::misuse(format!("there is no query `{words}`")))?;
    (query.write)(parameters, out)
}

/// The words of the query that was read, and its parameters.
fn read(matches: &ArgMatches) -> (String, &ArgMatches) {
    let (mut words, mut inner) = (String::new(), matches);
    while let Some((name, below)) =
        inner.subcommand().filter(|_| FAMILIES.iter().any(|family| family[0] == words) || words.is_empty())
    {
        words = format!("{words} {name}").trim_start().to_owned();
        inner = below;
    }
    (words, inner)
}

/// The ensemble of `simulate --each`, which can be followed further and further.
pub(crate) fn ensemble(matches: &ArgMatches) -> Result<(Model, Ensemble), QueryError> {
    let simulate = matches
        .subcommand_matches("simulate")
        .ok_or_else(|| QueryError::misuse("only <libration simulate> with <--each> has an ensemble"))?;
    let refused = |error| QueryError::refused(&error);
    simulate::Simulate::from_arg_matches(simulate).map_err(refused)?.ensemble()
}

/// The fields of the results of all queries.
pub(crate) fn all_fields() -> Vec<Answers> {
    queries().iter().flat_map(|query| (query.fields)()).collect()
}

/// The fields of JSON of a query, for all of its options.
pub(crate) fn fields_of(words: &[String]) -> Vec<Description> {
    let is_asked = |answers: &Answers| answers.command.split(' ').zip(words).all(|(part, word)| part == word);
    all_fields().into_iter().filter(is_asked).flat_map(|field| field.json).collect()
}
