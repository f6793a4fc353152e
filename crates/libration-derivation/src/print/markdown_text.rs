//! Derivations as Markdown with formulas in LaTeX, as GitHub, GitLab, Jupyter and Pandoc read them.

use super::super::check::CheckedEquation;
use super::super::document::{Block, Derivation, DerivationTable};
use super::super::prose::Prose;
use super::super::typeset::escape::markdown;
use super::super::typeset::{inline_latex, statement_latex};
use super::{sentence, write_blocks};

/// The derivation in Markdown: displayed formulas in `math` fences, others between dollars.
#[must_use]
pub fn to_markdown(derivation: &Derivation) -> String {
    let mut text = format!("# {}\n", markdown(&derivation.title));
    write_blocks(&mut text, "\n", &derivation.introduction, block);
    for (n, step) in derivation.steps.iter().enumerate() {
        text.push_str(&format!("\n## {}. {}\n", n + 1, markdown(&step.heading)));
        write_blocks(&mut text, "\n", &step.blocks, block);
    }
    text
}

fn block(block: &Block) -> String {
    match block {
        Block::Paragraph(it) => prose(it),
        Block::Remark(it) => format!("> {}", prose(it)),
        Block::Equation(it) => equation(it),
        Block::Table(it) => table(it),
    }
}

fn equation(equation: &CheckedEquation) -> String {
    let check = equation.check();
    let tick = if check.is_computed() { "✓ " } else { "" };
    let statement = statement_latex(equation.statement());
    format!("```math\n{statement}\n```\n{tick}{}", prose(&check.to_prose()))
}

fn prose(prose: &Prose) -> String {
    sentence(prose, markdown, |it| format!("${}$", inline_latex(it)))
}

fn table(table: &DerivationTable) -> String {
    let line = |cells: &[Prose]| format!("| {} |\n", cells.iter().map(prose).collect::<Vec<_>>().join(" | "));
    let rule = format!("|{}\n", "---:|".repeat(table.head.len()));
    let rows: String = table.rows.iter().map(|row| line(row)).collect();
    format!("{}{rule}{rows}\n{}", line(&table.head), prose(&table.note))
}
