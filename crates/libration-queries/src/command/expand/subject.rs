//! Subject of an expansion, in words: the oscillator of every result.

use crate::output::field::{Field, Fields};
use crate::output::json;
use crate::output::table::write_text;
use libration::expression::Equation;
use std::io::{self, Write};

/// An oscillator in words.
pub(super) struct Subject {
    pub(super) key: Option<&'static str>,
    pub(super) title: String,
    pub(super) equation: String,
    pub(super) equation_latex: String,
    /// The name of the displacement.
    pub(super) variable: String,
    /// The parameters with their values.
    values: Vec<(String, String)>,
    /// The equation as it was read, if its text differs from the plain spelling.
    read_as: Option<String>,
}

/// A result about an oscillator.
pub(super) trait About {
    fn subject(&self) -> &Subject;
}

impl Subject {
    pub(super) fn new(
        equation: &Equation,
        (key, title): (Option<&'static str>, String),
        values: Vec<(String, String)>,
        read_as: Option<String>,
    ) -> Self {
        Self {
            key,
            title,
            equation: equation.to_string(),
            equation_latex: equation.to_latex().join(r",\quad "),
            variable: equation.variables().first().cloned().unwrap_or_default(),
            values,
            read_as,
        }
    }

    /// The symbol of a quantity of the result, numbered where the displacement or one of these symbols has its name.
    pub(super) fn free(&self, name: &str, symbols: &[String]) -> String {
        let is_taken = |name: &String| *name == self.variable || symbols.contains(name);
        let numbered = (1..).map(|number| format!("{name}_{number}"));
        let mut names = std::iter::once(name.to_owned()).chain(numbered).filter(|name| !is_taken(name));
        names.next().unwrap_or_default()
    }

    /// `a = 1, b = 2`; `None` without parameters.
    pub(super) fn values(&self) -> Option<String> {
        let values: Vec<String> =
            self.values.iter().map(|(name, value)| format!("{name} = {value}")).collect();
        (!values.is_empty()).then(|| values.join(", "))
    }

    pub(super) fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        write_text(out, "", &self.title)?;
        write_text(out, if self.read_as.is_some() { "read as " } else { "" }, &self.equation)?;
        self.values().map_or(Ok(()), |values| write_text(out, "with ", &values))
    }
}

pub(super) fn of_subject<A: About>() -> Fields<A> {
    Fields::from([
        Field::value(
            "oscillator",
            "",
            "key of the oscillator, null where its equation was typed",
            |answer: &A| answer.subject().key.into(),
        ),
        Field::value("equation", "", "equation of motion", |answer: &A| {
            answer.subject().equation.as_str().into()
        }),
        Field::value(
            "read_as",
            "",
            "reading of the equation, null where it was a key or plain: names, brackets, primes and operators",
            |answer: &A| answer.subject().read_as.clone().into(),
        ),
        Field::value(
            "parameters.NAME",
            "",
            "value of the parameter with this name, as text",
            |answer: &A| json::object(answer.subject().values.iter().cloned()),
        ),
    ])
}
