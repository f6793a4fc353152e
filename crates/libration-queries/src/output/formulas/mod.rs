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

/// Writes the formulas of equations in a format: the equations as text, and each in LaTeX.
pub(crate) fn write(
    out: &mut dyn Write,
    format: Format,
    (equations, equations_latex): (&str, &[String]),
    formulas: &[NamedFormula],
) -> Result<(), QueryError> {
    if let Some(language) = format.language() {
        return code::write(out, language, equations, formulas);
    }
    if format == Format::Mathml {
        return Ok(mathml::write(out, equations, formulas)?);
    }
    for equation in equations_latex {
        writeln!(out, "\\[ {equation} \\]")?;
    }
    for NamedFormula { left, text, .. } in formulas {
        writeln!(out, "\\[ {left} = {} \\]", latex(text))?;
    }
    Ok(())
}

/// A formula in LaTeX.
pub(crate) fn latex(text: &str) -> String {
    let latex = text.parse().map_or_else(|_| text.to_owned(), |expression: Expression| expression.to_latex());
    latex.replace(r"\phi", r"\varphi")
}
