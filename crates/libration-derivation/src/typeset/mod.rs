//! Layout of formulas, and output as LaTeX and MathML.

pub(super) mod escape;
pub(super) mod layout;
pub(super) mod lines;
mod precedence;
mod latex;
mod mathml;

pub(super) use mathml::mathml;

use super::formula::{Formula, Statement};
use layout::Style;
use lines::Lines;

/// The formula in LaTeX, for mathematics mode.
#[must_use]
pub fn formula_latex(formula: &Formula) -> String {
    latex::latex(&Style::Display.formula(formula)).trim_end().to_owned()
}

/// The statement in LaTeX, for a display; several lines are aligned.
#[must_use]
pub fn statement_latex(statement: &Statement) -> String {
    let Lines { left, right } = lines::statement(statement);
    let lines: Vec<String> = right.iter().map(latex::latex).collect();
    match lines.as_slice() {
        [] | [_] => format!("{}{}", latex::latex(&left), lines.concat()).trim_end().to_owned(),
        _ => {
            let lines = lines.join("\\\\\n&");
            format!("\\begin{{aligned}}\n{}&{}\n\\end{{aligned}}", latex::latex(&left), lines.trim_end())
        }
    }
}

/// A formula within a sentence, in LaTeX.
pub(super) fn inline_latex(formula: &Formula) -> String {
    latex::latex(&Style::Inline.formula(formula)).trim_end().to_owned()
}
