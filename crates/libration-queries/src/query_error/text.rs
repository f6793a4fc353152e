//! Messages that name parameters and queries, for front ends with words of their own.
//!
//! In the text of a message `<--over>` marks an option, `<--order=3>` an option with a value, and `<libration expand>` a query.

use super::parameter::Parameter;
use serde_json::{Value, json};

/// A message in parts.
#[derive(Debug, Default)]
pub(super) struct Text(Vec<Part>);

#[derive(Debug)]
enum Part {
    Plain(String),
    Option(Parameter),
    Setting(Parameter, String),
    Query(String),
}

/// The names of parameters and queries in a front end.
pub trait Words {
    /// The name of a parameter.
    fn parameter(&self, parameter: &Parameter) -> String;
    /// The name of a query, of which these are the words: `fit trace`.
    fn query(&self, words: &str) -> String;
    /// A parameter with its value, which is in quotes where a shell needs them.
    fn setting(&self, parameter: &Parameter, value: &str) -> String {
        format!("{} {}", self.parameter(parameter), quoted(value))
    }
}

/// The value of a setting as a shell takes it.
fn quoted(value: &str) -> String {
    let is_plain = value.chars().all(|it| it.is_ascii_alphanumeric() || "=.-_".contains(it));
    if is_plain { value.to_owned() } else { format!("\"{value}\"") }
}

/// The words of the command line.
#[derive(Clone, Copy, Debug)]
pub struct CommandWords;

impl Words for CommandWords {
    fn parameter(&self, parameter: &Parameter) -> String {
        parameter.in_help()
    }

    fn query(&self, words: &str) -> String {
        format!("libration {words}")
    }
}

impl Text {
    /// The parts of a text with marks.
    pub(super) fn marked(text: &str) -> Self {
        let mut parts = vec![];
        let mut rest = text;
        let mut plain = String::new();
        while let Some(begin) = rest.find('<') {
            let (before, from) = rest.split_at(begin);
            plain.push_str(before);
            match mark(from) {
                Some((part, length)) => {
                    parts.push(Part::Plain(std::mem::take(&mut plain)));
                    parts.push(part);
                    rest = &from[length..];
                }
                None => {
                    plain.push('<');
                    rest = &from[1..];
                }
            }
        }
        plain.push_str(rest);
        parts.push(Part::Plain(plain));
        Self(parts)
    }

    pub(super) fn to_json(&self) -> Vec<Value> {
        let named = |parameter: &Parameter| json!({ "parameter": parameter.in_help() });
        let parts = self.0.iter().flat_map(|part| match part {
            Part::Plain(text) => vec![Value::from(super::clean(text))],
            Part::Option(parameter) => vec![named(parameter)],
            Part::Setting(parameter, value) => {
                vec![named(parameter), Value::from(super::clean(&format!(" {}", quoted(value))))]
            }
            Part::Query(query) => vec![json!({ "query": query })],
        });
        parts.collect()
    }

    pub(super) fn in_words(&self, words: &dyn Words) -> String {
        let parts = self.0.iter().map(|part| match part {
            Part::Plain(text) => text.clone(),
            Part::Option(parameter) => words.parameter(parameter),
            Part::Setting(parameter, value) => words.setting(parameter, value),
            Part::Query(query) => words.query(query),
        });
        parts.collect()
    }
}

/// Replaces the marks of a text by the words of the command line.
pub(crate) fn in_command_words(marked: &str) -> String {
    Text::marked(marked).in_words(&CommandWords)
}

/// The mark at the beginning of a text, and its length.
fn mark(text: &str) -> Option<(Part, usize)> {
    let end = text.find('>')?;
    let inner = &text[1..end];
    let is_name = |name: &str, more: char| {
        name.starts_with(|it: char| it.is_ascii_lowercase())
            && name.chars().all(|it| it.is_ascii_lowercase() || it.is_ascii_digit() || it == more)
    };
    let (option, value) =
        inner.split_once('=').map_or((inner, None), |(option, value)| (option, Some(value)));
    if option.strip_prefix("--").is_some_and(|name| is_name(name, '-')) {
        let parameter = Parameter::of_usage(option)?;
        let part = match value {
            Some(value) => Part::Setting(parameter, value.to_owned()),
            None => Part::Option(parameter),
        };
        return Some((part, end + 1));
    }
    let query = inner.strip_prefix("libration ").filter(|query| is_name(query, ' '))?;
    Some((Part::Query(query.to_owned()), end + 1))
}
