//! Derivations as Markdown, as a LaTeX document, and as an HTML page that needs no network.

mod escape;
mod layout;
mod place;

mod latex;
mod mathml;

mod html_page;
mod latex_document;
mod markdown_text;

pub use html_page::to_html;
pub use latex_document::to_latex;
pub use markdown_text::to_markdown;

use super::formula::{Formula, Statement};
use layout::Style;

/// The formula in LaTeX, for mathematics mode.
#[must_use]
pub fn formula_latex(formula: &Formula) -> String {
    latex::latex(&Style::Display.formula(formula)).trim_end().to_owned()
}

/// The statement in LaTeX, for a display; chains of more than two formulas stand below each other.
#[must_use]
pub fn statement_latex(statement: &Statement) -> String {
    let (first, rest) = layout::statement(statement);
    let align = if rest.len() > 1 { "&" } else { "" };
    let links: Vec<String> = rest
        .iter()
        .map(|(relation, formula)| format!("{align}{}{}", latex::latex(relation), latex::latex(formula)))
        .collect();
    let chain = format!("{}{}", latex::latex(&first), links.join("\\\\\n"));
    if rest.len() > 1 {
        format!("\\begin{{aligned}}\n{}\n\\end{{aligned}}", chain.trim_end())
    } else {
        chain.trim_end().to_owned()
    }
}

/// A formula within a sentence, in LaTeX.
fn inline_latex(formula: &Formula) -> String {
    latex::latex(&Style::Inline.formula(formula)).trim_end().to_owned()
}
