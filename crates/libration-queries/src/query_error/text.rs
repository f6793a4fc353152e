//! Messages that name parameters and queries, in the wording of each front end.
//!
//! In a text `<--over>` marks an option, `<--order=3>` an option with a value, `<--decimal=.|,>` one with values of which each would do, and
//! `<libration expand>` a query.

use super::parameter::Parameter;
use libration::quantity::alternatives;
use serde_json::{Value, json};

/// A message in parts.
#[derive(Debug, Default)]
pub(crate) struct Text(Vec<MessagePart>);

#[derive(Debug)]
enum MessagePart {
    Plain(String),
    Option(Parameter),
    Setting(Parameter, Vec<String>),
    Query(String),
}

/// The names of parameters and queries in a front end.
pub trait Words {
    /// The name of a parameter.
    fn parameter(&self, parameter: &Parameter) -> String;
    /// The name of a query with these words: `fit trace`.
    fn query(&self, words: &str) -> String;
    /// A value, in quotes where a shell needs them.
    fn value(&self, value: &str) -> String {
        let is_plain =
            value.chars().all(|character| character.is_ascii_alphanumeric() || "=.,-_/".contains(character));
        if is_plain { value.to_owned() } else { format!("\"{value}\"") }
    }
    /// A parameter with a value, or with several alternative values.
    fn setting(&self, parameter: &Parameter, values: &[String]) -> String {
        let values: Vec<_> = values.iter().map(|value| self.value(value)).collect();
        format!("{} {}", self.parameter(parameter), alternatives(&values))
    }
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

/// The words of the command line between characters of the private use area, for front ends that replace them by other names.
///
/// U+E000 and U+E001 enclose a parameter with its values, or a query; U+E002 encloses each value. These characters have no width.
#[derive(Clone, Copy, Debug)]
pub struct MarkedWords;

impl Words for MarkedWords {
    fn parameter(&self, parameter: &Parameter) -> String {
        format!("\u{e000}{}\u{e001}", parameter.in_help())
    }

    fn query(&self, words: &str) -> String {
        format!("\u{e000}{}\u{e001}", CommandWords.query(words))
    }

    fn setting(&self, parameter: &Parameter, values: &[String]) -> String {
        let marked =
            |value: &String| self.value(value).replacen(value, &format!("\u{e002}{value}\u{e002}"), 1);
        let values: Vec<_> = values.iter().map(marked).collect();
        format!("\u{e000}{} {}\u{e001}", parameter.in_help(), alternatives(&values))
    }
}

impl Text {
    /// The parts of a text with marks.
    pub(crate) fn marked(text: &str) -> Self {
        let mut parts = vec![];
        let mut rest = text;
        let mut plain = String::new();
        while let Some(begin) = rest.find('<') {
            let (before, from) = rest.split_at(begin);
            plain.push_str(before);
            match mark(from) {
                Some((part, length)) => {
                    parts.push(MessagePart::Plain(std::mem::take(&mut plain)));
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
        parts.push(MessagePart::Plain(plain));
        Self(parts)
    }

    pub(super) fn to_json(&self) -> Vec<Value> {
        let parts = self.0.iter().map(|part| match part {
            MessagePart::Plain(text) => Value::from(super::clean(text)),
            MessagePart::Option(parameter) => json!({ "parameter": parameter.in_help() }),
            MessagePart::Setting(parameter, values) => {
                let values: Vec<_> = values.iter().map(|value| super::clean(value)).collect();
                json!({ "parameter": parameter.in_help(), "values": values })
            }
            MessagePart::Query(query) => json!({ "query": query }),
        });
        parts.collect()
    }

    pub(crate) fn in_words(&self, words: &dyn Words) -> String {
        let parts = self.0.iter().map(|part| match part {
            MessagePart::Plain(text) => text.clone(),
            MessagePart::Option(parameter) => words.parameter(parameter),
            MessagePart::Setting(parameter, values) => words.setting(parameter, values),
            MessagePart::Query(query) => words.query(query),
        });
        parts.collect()
    }
}

/// The mark at the beginning of a text, and its length.
fn mark(text: &str) -> Option<(MessagePart, usize)> {
    let end = text.find('>')?;
    let inner = &text[1..end];
    let is_name = |name: &str, more: char| {
        name.starts_with(|letter: char| letter.is_ascii_lowercase())
            && name.chars().all(|character| {
                character.is_ascii_lowercase() || character.is_ascii_digit() || character == more
            })
    };
    let (option, value) =
        inner.split_once('=').map_or((inner, None), |(option, value)| (option, Some(value)));
    if option.strip_prefix("--").is_some_and(|name| is_name(name, '-')) {
        let parameter = Parameter::of_usage(option)?;
        let part = match value {
            Some(values) => MessagePart::Setting(parameter, values.split('|').map(str::to_owned).collect()),
            None => MessagePart::Option(parameter),
        };
        return Some((part, end + 1));
    }
    let query = inner.strip_prefix("libration ").filter(|query| is_name(query, ' '))?;
    Some((MessagePart::Query(query.to_owned()), end + 1))
}
