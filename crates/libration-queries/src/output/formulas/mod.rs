//! Formulas of a result in LaTeX, in MathML, and as functions of programming languages.

mod code;
mod mathml;
pub(crate) mod program;

use super::language::Format;
use crate::query_error::QueryError;
use libration::expression::Expression;
use std::io::Write;

/// A formula with its names.
pub(crate) struct NamedFormula {
    /// The name of its function.
    pub(crate) name: String,
    /// The quantity in words.
    pub(crate) meaning: String,
    /// The left side of its equation in LaTeX.
    pub(crate) left: String,
    /// The formula in plain text.
    pub(crate) text: String,
}

impl NamedFormula {
    /// Formulas for functions and MathML, each with its name, its quantity and its text; in LaTeX their result is written otherwise.
    pub(crate) fn without_latex<const N: usize>(formulas: [(&str, &str, String); N]) -> Vec<Self> {
        let formula = |(name, meaning, text): (&str, &str, String)| Self {
            name: name.to_owned(),
            meaning: meaning.to_owned(),
            left: String::new(),
            text,
        };
        formulas.map(formula).into()
    }
}

/// The subject of formulas.
pub(crate) struct Heading<'a> {
    /// The name of a module of such functions, such as `slow_flow`.
    pub(crate) module: &'static str,
    /// The equations as text.
    pub(crate) equations: &'a str,
    /// Each equation in LaTeX.
    pub(crate) latex: &'a [String],
}

/// Writes formulas in a format.
pub(crate) fn write(
    out: &mut dyn Write,
    format: Format,
    heading: &Heading<'_>,
    formulas: &[NamedFormula],
) -> Result<(), QueryError> {
    if let Some(language) = format.language() {
        return code::write(out, language, heading, formulas);
    }
    if format == Format::Mathml {
        return Ok(mathml::write(out, heading.equations, formulas)?);
    }
    for equation in heading.latex {
        writeln!(out, "\\[ {equation} \\]")?;
    }
    for NamedFormula { left, text, .. } in formulas {
        writeln!(out, "\\[ {left} = {} \\]", latex(text))?;
    }
    Ok(())
}

/// The sum of terms in plain text, those with a minus subtracted.
pub(crate) fn sum(terms: &[String]) -> String {
    let mut text = terms.first().cloned().unwrap_or_else(|| "0".to_owned());
    for term in terms.iter().skip(1) {
        text += &match term.strip_prefix('-') {
            Some(size) => format!(" - {size}"),
            None => format!(" + {term}"),
        };
    }
    text
}

/// A formula in LaTeX.
pub(crate) fn latex(text: &str) -> String {
    let latex = text.parse().map_or_else(|_| text.to_owned(), |expression: Expression| expression.to_latex());
    latex.replace(r"\phi", r"\varphi")
}
