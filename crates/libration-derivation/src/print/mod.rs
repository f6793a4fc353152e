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

use super::document::{Block, Prose, Span};
use super::formula::{Formula, Statement};
use layout::{Lines, Style};

/// The formula in LaTeX, for mathematics mode.
#[must_use]
pub fn formula_latex(formula: &Formula) -> String {
    latex::latex(&Style::Display.formula(formula)).trim_end().to_owned()
}

/// The statement in LaTeX, for a display; what needs several lines is aligned.
#[must_use]
pub fn statement_latex(statement: &Statement) -> String {
    let Lines { left, right } = layout::statement(statement);
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
fn inline_latex(formula: &Formula) -> String {
    latex::latex(&Style::Inline.formula(formula)).trim_end().to_owned()
}

/// A sentence, its texts and its formulas written each in their way.
fn sentence(prose: &Prose, text: fn(&str) -> String, formula: fn(&Formula) -> String) -> String {
    let span = |span: &Span| match span {
        Span::Text(it) => text(it),
        Span::Formula(it) => formula(it),
    };
    prose.0.iter().map(span).collect()
}

/// Each block on lines of its own, behind this separator.
fn write_blocks(page: &mut String, separator: &str, blocks: &[Block], written: fn(&Block) -> String) {
    for block in blocks {
        page.push_str(separator);
        page.push_str(&written(block));
        page.push('\n');
    }
}
