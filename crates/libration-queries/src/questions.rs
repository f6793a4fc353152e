//! Commands with their parameters, for programs that put the words of a command line together themselves.

use crate::command::command;
use crate::command::parameter_type::ParameterType;
use clap::{Arg, ArgAction, Command};
use std::ffi::OsString;

/// A question of the command.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Question {
    /// The words after the name of the program: `decay`, `fit trace`.
    pub words: String,
    /// Purpose of the command, in a line.
    pub about: String,
    /// Remarks; may be empty.
    pub remarks: String,
    /// Parameters in the order of the help.
    pub parameters: Vec<ParameterDescription>,
}

/// A parameter of a query.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ParameterDescription {
    /// Name of an option without its dashes: `damping-order`; name of an argument in small letters: `amplitude`.
    pub name: String,
    /// Kind of the parameter.
    pub kind: ParameterKind,
    /// Type of its value.
    pub value_type: ParameterType,
    /// Placeholder of its value in the help: `NAME=VALUE`, `FILE`; empty for a flag.
    pub value: String,
    /// `true` if the command fails without it.
    pub is_required: bool,
    /// `true` if it may be given several times.
    pub is_repeated: bool,
    /// All allowed values, if they are a list.
    pub choices: Vec<String>,
    /// Meaning of the parameter, with its default.
    pub meaning: String,
}

/// The way in which a parameter is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ParameterKind {
    /// A positional argument.
    Argument,
    /// An option `--name=value`.
    Option,
    /// A flag `--name`.
    Flag,
}

/// All questions in the help with their parameters, in the order of the help.
///
/// # Examples
/// ```
/// let decay = libration_queries::questions().into_iter().find(|it| it.words == "decay").ok_or("no decay")?;
/// let cycles = decay.parameters.iter().find(|it| it.name == "cycles").ok_or("no cycles")?;
/// assert_eq!((cycles.value.as_str(), cycles.value_type), ("CYCLES", libration_queries::ParameterType::Integer));
/// # Ok::<(), &str>(())
/// ```
#[must_use]
pub fn questions() -> Vec<Question> {
    let mut command = command([]);
    command.build();
    leaves(&command, "", |command| !command.is_hide_set())
}

/// The name of the argument whose value has this name in the help, in the query of a command line.
pub(crate) fn argument_name(words: &[OsString], value: &str) -> Option<String> {
    let word = |index: usize| words.get(index).and_then(|word| word.to_str()).unwrap_or_default();
    let (one, two) = (word(0).to_owned(), format!("{} {}", word(0), word(1)));
    let mut command = command([]);
    command.build();
    let asked =
        leaves(&command, "", |_| true).into_iter().filter(|leaf| leaf.words == one || leaf.words == two);
    let question = asked.max_by_key(|leaf| leaf.words.len())?;
    let is_it = |description: &ParameterDescription| {
        description.kind == ParameterKind::Argument && description.value == value
    };
    question.parameters.into_iter().find(is_it).map(|parameter| parameter.name)
}

/// The runnable commands below this one, if they are shown.
fn leaves(command: &Command, words: &str, is_shown: fn(&Command) -> bool) -> Vec<Question> {
    let below = command
        .get_subcommands()
        .filter(|subcommand| subcommand.get_name() != "help" && is_shown(subcommand));
    let each = below.flat_map(|subcommand| {
        let words = format!("{words} {}", subcommand.get_name()).trim_start().to_owned();
        let itself = (!subcommand.is_subcommand_required_set()).then(|| question(subcommand, words.clone()));
        itself.into_iter().chain(leaves(subcommand, &words, is_shown)).collect::<Vec<_>>()
    });
    each.collect()
}

fn question(command: &Command, words: String) -> Question {
    let about = command.get_about().map(ToString::to_string).unwrap_or_default();
    let long = command.get_long_about().map(ToString::to_string).unwrap_or_default();
    let given =
        command.get_arguments().filter(|argument| !["help", "version"].contains(&argument.get_id().as_str()));
    Question {
        words,
        remarks: long.strip_prefix(&about).unwrap_or(&long).trim().to_owned(),
        about,
        parameters: given.map(parameter).collect(),
    }
}

fn parameter(arg: &Arg) -> ParameterDescription {
    let takes_value = arg.get_action().takes_values();
    let kind = match (arg.get_long(), takes_value) {
        (None, _) => ParameterKind::Argument,
        (Some(_), true) => ParameterKind::Option,
        (Some(_), false) => ParameterKind::Flag,
    };
    let value = arg.get_value_names().filter(|_| takes_value).map(|names| names.join(" "));
    let choices = arg.get_possible_values();
    let choices = choices.iter().filter(|_| takes_value).map(|choice| choice.get_name().to_owned());
    ParameterDescription {
        name: arg.get_long().map_or_else(|| arg.get_id().to_string(), str::to_owned),
        kind,
        value_type: ParameterType::of(arg),
        value: value.unwrap_or_default(),
        is_required: arg.is_required_set(),
        is_repeated: takes_value
            && (matches!(arg.get_action(), ArgAction::Append)
                || arg.get_num_args().is_some_and(|argument| argument.max_values() > 1)),
        choices: choices.collect(),
        meaning: meaning(arg),
    }
}

/// The help, followed by the default.
fn meaning(arg: &Arg) -> String {
    let help = arg.get_long_help().or_else(|| arg.get_help()).map(ToString::to_string).unwrap_or_default();
    let defaults: Vec<_> = arg.get_default_values().iter().map(|value| value.to_string_lossy()).collect();
    let shows = arg.get_action().takes_values() && !defaults.is_empty() && !arg.is_hide_default_value_set();
    if shows { format!("{help} [default: {}]", defaults.join(" ")) } else { help }
}
