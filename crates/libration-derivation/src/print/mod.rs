//! Derivations as Markdown, as a LaTeX document, and as an HTML page that needs no network.

mod html_page;
mod latex_document;
mod markdown_text;
mod notebook;

pub use html_page::{judgement_to_html, to_html};
pub use latex_document::to_latex;
pub use markdown_text::{judgement_to_markdown, to_markdown};
pub use notebook::to_notebook;

use super::document::{Block, Derivation, DerivationStep};
use super::formula::Formula;
use super::prose::{Prose, Span};

/// The position of a block.
#[derive(Clone, Copy)]
struct BlockPosition<'a> {
    /// The id of the step, or of the exercise that the block answers.
    id: &'a str,
    /// The number of the step; zero in the introduction.
    step: usize,
    /// `true` for an answer, whose formulas belong to an exercise elsewhere.
    is_answer: bool,
}

impl<'a> BlockPosition<'a> {
    const INTRODUCTION: Self = Self { id: "introduction", step: 0, is_answer: false };

    /// The positions of the steps.
    fn steps(derivation: &'a Derivation) -> impl Iterator<Item = (Self, &'a DerivationStep)> {
        let position = |is_answer| {
            move |(n, step): (usize, &'a DerivationStep)| {
                (Self { id: &step.id, step: n + 1, is_answer }, step)
            }
        };
        let (steps, answers) = (derivation.steps.iter(), derivation.answers.iter());
        let answers = answers.enumerate().map(position(true)).filter(|(_, step)| !step.blocks.is_empty());
        steps.enumerate().map(position(false)).chain(answers)
    }

    /// The number of a formula.
    fn number(&self, formula: usize) -> String {
        format!("{}.{formula}", self.step)
    }
}

/// A sentence, with separate functions for its texts and its formulas.
fn sentence(prose: &Prose, text: fn(&str) -> String, formula: fn(&Formula) -> String) -> String {
    let span = |span: &Span| match span {
        Span::Text(words) => text(words),
        Span::Formula(math) => formula(math),
    };
    prose.0.iter().map(span).collect()
}

/// Writes each block on separate lines, after this separator.
fn write_blocks(
    page: &mut String,
    separator: &str,
    position: BlockPosition<'_>,
    blocks: &[Block],
    written: fn(BlockPosition<'_>, &Block) -> String,
) {
    for block in blocks {
        page.push_str(separator);
        page.push_str(&written(position, block));
        page.push('\n');
    }
}
