//! Derivations as Markdown with formulas in LaTeX, for GitHub, GitLab, Jupyter and Pandoc.

use super::super::answers::Judgement;
use super::super::check::CheckedEquation;
use super::super::document::{Block, Derivation, DerivationStep, DerivationTable};
use super::super::formula::Statement;
use super::super::prose::Prose;
use super::super::typeset::escape::markdown;
use super::super::typeset::{inline_latex, statement_latex};
use super::{BlockPosition, sentence, write_blocks};

/// The derivation in Markdown: displayed formulas in `math` fences, other formulas between dollar signs.
#[must_use]
pub fn to_markdown(derivation: &Derivation) -> String {
    let mut text = format!("# {}\n", markdown(&derivation.title));
    write_blocks(&mut text, "\n", BlockPosition::INTRODUCTION, &derivation.introduction, block);
    let mut answers = "\n---\n\n## Answers\n";
    for (position, step) in BlockPosition::steps(derivation) {
        let level = if position.is_answer { "###" } else { "##" };
        if position.is_answer {
            text.push_str(std::mem::take(&mut answers));
        }
        text.push_str(&format!("\n{level} {}. {}\n", position.step, markdown(&step.heading)));
        write_blocks(&mut text, "\n", position, &step.blocks, block);
    }
    text
}

/// The judgement of an answer as a line of Markdown.
#[must_use]
pub fn judgement_to_markdown(judgement: &Judgement) -> String {
    format!("{}\n", prose(&judgement.to_prose()))
}

pub(super) fn block(position: BlockPosition<'_>, block: &Block) -> String {
    match block {
        Block::Paragraph(sentences) => prose(sentences),
        Block::Remark(sentences) => format!("> {}", prose(sentences)),
        Block::Equation { number, equation: checked } => equation(position, *number, checked),
        Block::Exercise { number, statement, .. } => formula(position, *number, statement),
        Block::Table(rows) => table(rows),
        Block::Details { summary, blocks } => {
            let mut inside = format!("<details>\n<summary>{}</summary>\n", markdown(summary));
            write_blocks(&mut inside, "\n", position, blocks, self::block);
            format!("{inside}\n</details>")
        }
    }
}

fn equation(position: BlockPosition<'_>, number: usize, equation: &CheckedEquation) -> String {
    let check = equation.check();
    let tick = if check.is_computed() { "✓ " } else { "" };
    format!("{}\n{tick}{}", formula(position, number, equation.statement()), prose(&check.to_prose()))
}

/// A displayed formula with its number.
fn formula(position: BlockPosition<'_>, number: usize, statement: &Statement) -> String {
    format!("```math\n{}\n\\tag{{{}}}\n```", statement_latex(statement), position.number(number))
}

/// The description of the check of a formula.
pub(super) fn check(equation: &CheckedEquation) -> String {
    prose(&equation.check().to_prose())
}

pub(super) fn title(derivation: &Derivation) -> String {
    markdown(&derivation.title)
}

pub(super) fn heading(step: &DerivationStep) -> String {
    markdown(&step.heading)
}

fn prose(prose: &Prose) -> String {
    sentence(prose, markdown, |math| format!("${}$", inline_latex(math)))
}

fn table(table: &DerivationTable) -> String {
    let line = |cells: &[Prose]| format!("| {} |\n", cells.iter().map(prose).collect::<Vec<_>>().join(" | "));
    let rule = format!("|{}\n", "---:|".repeat(table.head.len()));
    let rows: String = table.rows.iter().map(|row| line(row)).collect();
    format!("{}{rule}{rows}\n{}", line(&table.head), prose(&table.note))
}
