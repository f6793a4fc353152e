//! The query of a sweep: the words of a command line in which `{NAME}` stands for the value of an axis.

use super::axis::Axis;
use crate::arguments::SystemOptions;
use crate::command::{command, matches_of_query};
use crate::query_error::{QueryError, argument, option};
use clap::{ArgMatches, Command, FromArgMatches};

/// The words of a question, with `{NAME}` where the values of axes go.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Template(pub Vec<String>);

impl Template {
    /// The words with a position for each axis: `{NAME}` in the words, or the option or argument with this name, or an initial value or a parameter
    /// of the system.
    pub fn new(words: &[String], axes: &[Axis]) -> Result<Self, QueryError> {
        let command = command([]);
        let mut template = Self(words.to_vec());
        let asked = asked(&command, words)?;
        let mut others = vec![];
        for axis in axes {
            if template.has(&axis.name) {
                continue;
            }
            match place_in(asked.command, &axis.name) {
                Some(AxisPosition::Option(name)) => template.add_option(&name, placeholder(&axis.name)),
                Some(AxisPosition::Argument) => template.0.insert(asked.words, placeholder(&axis.name)),
                None => others.push(axis),
            }
        }
        if !others.is_empty() {
            let states = template.state_names(&asked, axes, others[0])?;
            for axis in others {
                match axis.name.contains('[') || states.contains(&axis.name) {
                    true => template.add_initial(&axis.name),
                    false => template.add_option("set", assignment(&axis.name)),
                }
            }
        }
        Ok(template)
    }

    /// The words of the question at a point.
    pub fn at(&self, axes: &[Axis], indices: &[usize]) -> Vec<String> {
        let value = |word: &String| {
            axes.iter().zip(indices).fold(word.clone(), |word, (axis, index)| {
                word.replace(&placeholder(&axis.name), &axis.values[*index])
            })
        };
        self.0.iter().map(value).collect()
    }

    fn has(&self, name: &str) -> bool {
        self.0.iter().any(|word| word.contains(&placeholder(name)))
    }

    /// Adds an option after the other options, before a `--`.
    fn add_option(&mut self, name: &str, value: String) {
        let end = self.0.iter().position(|word| word == "--").unwrap_or(self.0.len());
        self.0.splice(end..end, [format!("--{name}"), value]);
    }

    fn add_initial(&mut self, name: &str) {
        let mut is_given = false;
        for index in 0..self.0.len() {
            let is_value = index > 0 && self.0[index - 1] == "--initial";
            if is_value || self.0[index].starts_with("--initial=") {
                self.0[index] = format!("{},{}", self.0[index], assignment(name));
                is_given = true;
            }
        }
        if !is_given {
            self.add_option("initial", assignment(name));
        }
    }

    /// The names of the components of the state of the system.
    fn state_names(
        &self,
        asked: &SweptCommand<'_>,
        axes: &[Axis],
        unplaced: &Axis,
    ) -> Result<Vec<String>, QueryError> {
        if asked.command.get_arguments().all(|argument| argument.get_id() != "system") {
            let options: Vec<String> = options(asked.command).map(|name| format!("<--{name}>")).collect();
            let reason = format!(
                "`{0}` is not an option of `{1}`, which are {2}; or write {{{0}}} in the command where its values go",
                unplaced.name,
                asked.name,
                options.join(", ")
            );
            return Err(QueryError::usage(option("over"), reason));
        }
        let words = self.at(axes, &vec![0; axes.len()]);
        let matches = matches_of_query(words.into_iter().map(Into::into).collect())?;
        let options = SystemOptions::from_arg_matches(innermost(&matches))
            .map_err(|item| QueryError::refused(&item))?;
        options.state_names()
    }
}

/// The command of a sweep.
struct SweptCommand<'a> {
    command: &'a Command,
    /// Name as typed.
    name: String,
    /// Number of words of the name.
    words: usize,
}

fn asked<'a>(command: &'a Command, words: &[String]) -> Result<SweptCommand<'a>, QueryError> {
    let mut asked = SweptCommand { command, name: String::new(), words: 0 };
    while let Some(inner) = words.get(asked.words).and_then(|word| asked.command.find_subcommand(word)) {
        let name = format!("{} {}", asked.name, inner.get_name()).trim_start().to_owned();
        asked = SweptCommand { command: inner, name, words: asked.words + 1 };
    }
    let has_json = asked.command.get_arguments().any(|argument| argument.get_long() == Some("json"));
    if has_json {
        return Ok(asked);
    }
    let first = words.first().map_or("", String::as_str);
    let is_quoted = first.split_once(' ').is_some_and(|(name, _)| command.find_subcommand(name).is_some());
    let reason = if is_quoted {
        format!("`{first}` came as one word: leave out the quotes around the command")
    } else {
        format!(
            "`{first}` is not a query with numbers in its result: begin with one such as lyapunov or period"
        )
    };
    Err(QueryError::usage(argument("COMMAND"), reason))
}

enum AxisPosition {
    Option(String),
    Argument,
}

/// The position at which the command takes a value with this name.
fn place_in(command: &Command, name: &str) -> Option<AxisPosition> {
    if let Some(option) = options(command).find(|option| *option == name) {
        return Some(AxisPosition::Option(option.to_owned()));
    }
    let mut arguments = command.get_positionals();
    // Several files are FILES, of which each point has one.
    let is_named = |argument: &clap::Arg| {
        let names = argument.get_value_names().map(|names| names.join("|"));
        let names = names.unwrap_or_else(|| argument.get_id().to_string());
        names
            .split('|')
            .any(|word| word.eq_ignore_ascii_case(name) || word.eq_ignore_ascii_case(&format!("{name}s")))
    };
    arguments.next().filter(|argument| is_named(argument)).map(|_| AxisPosition::Argument)
}

/// The options that take a value.
fn options(command: &Command) -> impl Iterator<Item = &str> {
    let takes_value = |argument: &&clap::Arg| argument.get_action().takes_values();
    command.get_arguments().filter(takes_value).filter_map(clap::Arg::get_long)
}

fn innermost(matches: &ArgMatches) -> &ArgMatches {
    matches.subcommand().map_or(matches, |(_, inner)| innermost(inner))
}

fn placeholder(name: &str) -> String {
    format!("{{{name}}}")
}

fn assignment(name: &str) -> String {
    format!("{name}={{{name}}}")
}
