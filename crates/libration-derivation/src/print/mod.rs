//! Derivations as Markdown, as a LaTeX document, and as an HTML page that needs no network.

mod html_page;
mod latex_document;
mod markdown_text;

pub use html_page::to_html;
pub use latex_document::to_latex;
pub use markdown_text::to_markdown;

use super::document::Block;
use super::formula::Formula;
use super::prose::{Prose, Span};

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
