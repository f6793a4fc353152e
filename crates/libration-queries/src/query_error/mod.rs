//! The reason why a query has no result, as data: its kind, its parameters, the message, and a remedy.
//!
//! A message names other parameters and queries by [`Parameter`] and marks (see [`text`]), so that the command, Python and the page each
//! write them in their own words.

pub(crate) mod echo;
pub(crate) mod parameter;
pub(crate) mod text;

pub(crate) use echo::excerpt;
pub(crate) use parameter::{Parameter, argument, option};

use clap::error::ErrorKind::{InvalidValue, MissingRequiredArgument};
use clap::error::{ContextKind, ContextValue};
use libration::oscillator::Remedy;
use libration::quantity::{Angle, alternatives};
use serde_json::{Value, json};
use std::fmt::Display;
use std::io::{Error, ErrorKind};
use text::{Text, Words};

/// The kind of an error.
#[derive(Debug)]
pub enum Kind {
    /// The query cannot be understood: exit status 2.
    Usage,
    /// The query is understood and has no result: exit status 1.
    NoResult,
    /// A file does not exist: exit status 1.
    MissingFile,
    /// Cancelled, with the finished part written: exit status 130.
    Cancelled,
    /// The result cannot be written: exit status 1, or 0 if the reader has closed the pipe.
    Output(Error),
}

/// The reason why a query has no result.
///
/// Its text is the message in the words of the command, in which very long quotations are shortened.
#[derive(Debug)]
pub struct QueryError(Box<ErrorContent>);

#[derive(Debug)]
struct ErrorContent {
    kind: Kind,
    about: ErrorSubject,
    message: Text,
    hint: Option<Text>,
    suggestion: Option<String>,
    item: Option<String>,
}

/// The subject of a message, which precedes it.
#[derive(Debug)]
pub(crate) enum ErrorSubject {
    Nothing,
    Parameters(Vec<Parameter>),
    Other(String),
}

impl From<&str> for ErrorSubject {
    fn from(subject: &str) -> Self {
        Self::Other(subject.to_owned())
    }
}

impl From<&String> for ErrorSubject {
    fn from(subject: &String) -> Self {
        Self::Other(subject.clone())
    }
}

impl From<&Parameter> for ErrorSubject {
    fn from(parameter: &Parameter) -> Self {
        Self::Parameters(vec![parameter.clone()])
    }
}

impl From<Parameter> for ErrorSubject {
    fn from(parameter: Parameter) -> Self {
        Self::Parameters(vec![parameter])
    }
}

impl<const N: usize> From<[Parameter; N]> for ErrorSubject {
    fn from(parameters: [Parameter; N]) -> Self {
        Self::Parameters(parameters.into())
    }
}

impl QueryError {
    /// The exit status of a command that was interrupted, as shells have it.
    pub const INTERRUPTED: u8 = 130;

    fn new(kind: Kind, about: ErrorSubject, message: &str) -> Self {
        Self(Box::new(ErrorContent {
            kind,
            about,
            message: Text::marked(message),
            hint: None,
            suggestion: None,
            item: None,
        }))
    }

    /// An error in a value of the query.
    pub(crate) fn usage(about: impl Into<ErrorSubject>, reason: impl Display) -> Self {
        Self::new(Kind::Usage, about.into(), &reason.to_string())
    }

    /// An error in the query as a whole.
    pub fn misuse(reason: impl Display) -> Self {
        Self::new(Kind::Usage, ErrorSubject::Nothing, &reason.to_string())
    }

    /// The absence of a result, and its subject.
    pub(crate) fn no_result(about: impl Into<ErrorSubject>, reason: impl Display) -> Self {
        Self::new(Kind::NoResult, about.into(), &reason.to_string())
    }

    /// The absence of a result, in a sentence without a subject.
    pub(crate) fn failed(reason: impl Display) -> Self {
        Self::new(Kind::NoResult, ErrorSubject::Nothing, &reason.to_string())
    }

    /// The absence of an input file.
    pub(crate) fn missing_file(reason: impl Display) -> Self {
        Self::new(Kind::MissingFile, ErrorSubject::Nothing, &reason.to_string())
    }

    /// An early end that was requested.
    pub(crate) fn cancelled(reason: impl Display) -> Self {
        Self::new(Kind::Cancelled, ErrorSubject::Nothing, &reason.to_string())
    }

    /// The same error with queries that have a result instead.
    pub(crate) fn with_remedies(self, remedies: &[Remedy]) -> Self {
        match sentences(remedies) {
            Some(hint) => self.with_hint(&hint),
            None => self,
        }
    }

    /// The same error with a hint, in which parameters and queries are marked.
    pub(crate) fn with_hint(self, hint: &str) -> Self {
        Self(Box::new(ErrorContent { hint: Some(Text::marked(hint)), ..*self.0 }))
    }

    /// The same error with a value of its parameter that would do.
    pub(crate) fn with_suggestion(self, value: Option<String>) -> Self {
        Self(Box::new(ErrorContent { suggestion: value, ..*self.0 }))
    }

    /// The same error with the item of a parameter `NAME=VALUE` to which it refers.
    pub(crate) fn with_item(self, name: Option<&str>) -> Self {
        Self(Box::new(ErrorContent { item: name.map(str::to_owned), ..*self.0 }))
    }

    /// The same error with the names that a query has for its arguments, by those of their values in the help.
    pub(crate) fn named(self, name_of: &dyn Fn(&str) -> Option<String>) -> Self {
        let ErrorSubject::Parameters(parameters) = &self.0.about else { return self };
        let about = ErrorSubject::Parameters(
            parameters.iter().cloned().map(|parameter| parameter.named(name_of)).collect(),
        );
        Self(Box::new(ErrorContent { about, ..*self.0 }))
    }

    /// The error in arguments, without the advice of a terminal to ask for help.
    #[must_use]
    pub fn refused(error: &clap::Error) -> Self {
        let parameters = refused_parameters(error);
        let reason = match std::error::Error::source(error) {
            Some(reason) => reason.to_string(),
            None if error.kind() == MissingRequiredArgument && parameters.len() > 1 => {
                "one of them is required".to_owned()
            }
            None if error.kind() == MissingRequiredArgument => "required, and not given".to_owned(),
            None if error.kind() == InvalidValue => {
                unknown_value(error).unwrap_or_else(|| first_paragraphs(error))
            }
            None => first_paragraphs(error),
        };
        let about =
            if parameters.is_empty() { ErrorSubject::Nothing } else { ErrorSubject::Parameters(parameters) };
        let hint = command_for(error).map(|hint| Text::marked(&hint));
        Self(Box::new(ErrorContent { hint, ..*Self::new(Kind::Usage, about, &reason).0 }))
    }

    /// The kind of the error.
    #[must_use]
    pub fn kind(&self) -> &Kind {
        &self.0.kind
    }

    /// The parameters to which the error refers; may be empty.
    #[must_use]
    pub fn parameters(&self) -> &[Parameter] {
        match &self.0.about {
            ErrorSubject::Parameters(parameters) => parameters,
            ErrorSubject::Nothing | ErrorSubject::Other(_) => &[],
        }
    }

    /// A value of the parameter that would do.
    #[must_use]
    pub fn suggestion(&self) -> Option<&str> {
        self.0.suggestion.as_deref()
    }

    /// The name of the item of a parameter `NAME=VALUE` that the error is about.
    #[must_use]
    pub fn item(&self) -> Option<&str> {
        self.0.item.as_deref()
    }

    /// The message without its parameters, in the words of a front end.
    #[must_use]
    pub fn message(&self, words: &dyn Words) -> String {
        let message = clean(&self.0.message.in_words(words));
        match &self.0.about {
            ErrorSubject::Other(subject) => format!("{}: {message}", clean(subject)),
            ErrorSubject::Nothing | ErrorSubject::Parameters(_) => message,
        }
    }

    /// The advice in the words of a front end.
    #[must_use]
    pub fn hint(&self, words: &dyn Words) -> Option<String> {
        self.0.hint.as_ref().map(|hint| clean(&hint.in_words(words)))
    }

    /// The whole error in the words of a front end: parameters, message, hint.
    #[must_use]
    pub fn in_words(&self, words: &dyn Words) -> String {
        if let Kind::Output(error) = &self.0.kind {
            return format!("cannot write the output: {error}");
        }
        let names: Vec<_> = self.parameters().iter().map(|parameter| words.parameter(parameter)).collect();
        let names = match names.as_slice() {
            [] => String::new(),
            [name] => format!("{name}: "),
            [first @ .., last] => format!("{} and {last}: ", first.join(", ")),
        };
        let hint = self.hint(words).map_or_else(String::new, |hint| format!("\nhint: {hint}"));
        format!("{names}{}{hint}", self.message(words))
    }

    /// The error for a page: `text` as the command writes it, `parameters` as its help has them, `item`, `message` and `hint` as lists of
    /// texts and of objects with the one member `parameter` or `query`, and `suggestion`; what does not exist is empty.
    #[must_use]
    pub fn to_json(&self) -> String {
        let parameters: Vec<_> = self.parameters().iter().map(Parameter::in_help).collect();
        let mut message = vec![];
        match &self.0.kind {
            Kind::Output(_) => message.push(Value::from(self.to_string())),
            _ => message.extend(self.0.message.to_json()),
        }
        let subject = match (&self.0.kind, &self.0.about) {
            (Kind::Output(_), _) | (_, ErrorSubject::Nothing | ErrorSubject::Parameters(_)) => String::new(),
            (_, ErrorSubject::Other(subject)) => clean(subject),
        };
        let hint = self.0.hint.as_ref().map_or_else(Vec::new, Text::to_json);
        let suggestion = self.suggestion().unwrap_or_default();
        let item = self.item().unwrap_or_default();
        let error = json!({
            "text": self.to_string(), "parameters": parameters, "item": item, "subject": subject, "message": message,
            "hint": hint, "suggestion": suggestion,
        });
        error.to_string()
    }

    /// The exit status of the command.
    #[must_use]
    pub fn status(&self) -> u8 {
        match self.0.kind {
            _ if self.is_closed_pipe() => 0,
            Kind::Usage => 2,
            Kind::Cancelled => Self::INTERRUPTED,
            Kind::NoResult | Kind::MissingFile | Kind::Output(_) => 1,
        }
    }

    /// `true` if the work was ended early.
    #[must_use]
    pub fn is_cancelled(&self) -> bool {
        matches!(self.0.kind, Kind::Cancelled)
    }

    /// `true` if the reader of the output has closed the pipe.
    #[must_use]
    pub fn is_closed_pipe(&self) -> bool {
        matches!(&self.0.kind, Kind::Output(error) if error.kind() == ErrorKind::BrokenPipe)
    }
}

impl Display for QueryError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.in_words(&text::CommandWords))
    }
}

impl std::error::Error for QueryError {}

impl From<Error> for QueryError {
    fn from(error: Error) -> Self {
        Self(Box::new(ErrorContent {
            kind: Kind::Output(error),
            about: ErrorSubject::Nothing,
            message: Text::default(),
            hint: None,
            suggestion: None,
            item: None,
        }))
    }
}

/// The hint to what has a result, in the words of a front end; `None` without remedies.
///
/// # Examples
/// ```
/// use libration::oscillator::Remedy;
/// use libration_queries::{MarkedWords, hint_to};
///
/// let hint = hint_to(&[Remedy::Simulation], &MarkedWords);
/// assert!(hint.is_some_and(|hint| hint.ends_with("follows the motion")));
/// assert_eq!(hint_to(&[], &MarkedWords), None);
/// ```
#[must_use]
pub fn hint_to(remedies: &[Remedy], words: &dyn Words) -> Option<String> {
    Some(Text::marked(&sentences(remedies)?).in_words(words))
}

fn sentences(remedies: &[Remedy]) -> Option<String> {
    let sentences: Vec<_> = remedies.iter().map(|remedy| sentence(*remedy)).collect();
    (!sentences.is_empty()).then(|| sentences.join("; "))
}

/// The query of a remedy, marked.
fn sentence(remedy: Remedy) -> &'static str {
    match remedy {
        Remedy::Simulation => "<libration simulate> follows the motion",
        Remedy::SlowFlow => "<libration expand> with <--damping-order=2> gives the rate of the amplitude",
        Remedy::Backbone => "<libration backbone> finds the frequency at any amplitude",
        Remedy::NormalModes => "<libration modes> computes normal modes",
        Remedy::Expansion => "<libration expand> has the series without its derivation, if there is one",
        Remedy::Period => "<libration period> has a result at all amplitudes",
        _ => "another query may have a result",
    }
}

/// The message of clap, for a terminal, with long quotations shortened and a hint where the first word looks like an amplitude or a file.
#[must_use]
pub fn refusal(error: &clap::Error) -> String {
    let message = echo::shortened(&echo::unprotected(&error.render().to_string()));
    match command_for(error) {
        Some(hint) => message.replacen(
            "\n\n",
            &format!("\nhint: {}\n\n", Text::marked(&hint).in_words(&text::CommandWords)),
            1,
        ),
        None => message,
    }
}

/// The command probably intended if the first word is not one: that for an amplitude, or for the name of a file.
fn command_for(error: &clap::Error) -> Option<String> {
    let Some(ContextValue::String(word)) = error.get(ContextKind::InvalidSubcommand) else { return None };
    let is_amplitude = |text: &str| text.trim().parse::<Angle>().is_ok();
    let query = match word {
        word if word.split([':', ',']).all(is_amplitude) => "period",
        word if is_recording(word) => "inspect",
        _ => return None,
    };
    Some(format!("<libration {query}> {word}"))
}

/// `true` if a name ends as files of measurements do.
fn is_recording(word: &str) -> bool {
    let end = word.rsplit_once('.').map(|parts| parts.1.to_ascii_lowercase());
    end.is_some_and(|end| {
        ["csv", "tsv", "txt", "dat", "xlsx", "xls", "ods", "zip", "json"].contains(&end.as_str())
    })
}

/// The parameters that clap refuses.
fn refused_parameters(error: &clap::Error) -> Vec<Parameter> {
    match error.get(ContextKind::InvalidArg) {
        Some(ContextValue::String(usage)) => Parameter::of_usage(usage).into_iter().collect(),
        Some(ContextValue::Strings(usages)) => {
            usages.iter().flat_map(|usage| Parameter::all_of_usage(usage)).collect()
        }
        _ => vec![],
    }
}

/// The reason for a value that is not among the choices of a parameter.
fn unknown_value(error: &clap::Error) -> Option<String> {
    let Some(ContextValue::String(given)) = error.get(ContextKind::InvalidValue) else { return None };
    let Some(ContextValue::Strings(valid)) = error.get(ContextKind::ValidValue) else { return None };
    Some(format!("unknown value `{given}`: give {}", alternatives(valid)))
}

/// The message of clap without usage and advice.
fn first_paragraphs(error: &clap::Error) -> String {
    let message = echo::shortened(&echo::unprotected(&error.render().to_string()));
    let reason = message.strip_prefix("error: ").unwrap_or(&message);
    let end =
        ["\n\nUsage:", "\n\nFor more information"].iter().filter_map(|advice| reason.find(advice)).min();
    reason[..end.unwrap_or(reason.len())].trim_end().to_owned()
}

/// The text with long quotations shortened, and without characters that move the cursor of a terminal or turn the direction of its text; lines stay.
fn clean(text: &str) -> String {
    let shortened = echo::shortened(text);
    shortened.split('\n').map(libration::quantity::printable).collect::<Vec<_>>().join("\n")
}
