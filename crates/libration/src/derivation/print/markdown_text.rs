//! Derivations as Markdown with formulas in LaTeX, as GitHub, GitLab, Jupyter and Pandoc read them.

use super::super::check::Equation;
use super::super::document::{Block, Derivation, Prose, Span, Table};
use super::escape::markdown;
use super::{inline_latex, statement_latex};

/// The derivation in Markdown: displayed formulas in `math` fences, others between dollars.
#[must_use]
pub fn to_markdown(derivation: &Derivation) -> String {
    let mut text = format!("# {}\n", markdown(&derivation.title));
    write_blocks(&mut text, &derivation.introduction);
    for (n, step) in derivation.steps.iter().enumerate() {
        text.push_str(&format!("\n## {}. {}\n", n + 1, markdown(&step.heading)));
        write_blocks(&mut text, &step.blocks);
    }
    text
}

fn write_blocks(text: &mut String, blocks: &[Block]) {
    for block in blocks {
        text.push('\n');
        text.push_str(&match block {
            Block::Paragraph(it) => prose(it),
            Block::Remark(it) => format!("> {}", prose(it)),
            Block::Equation(it) => equation(it),
            Block::Table(it) => table(it),
        });
        text.push('\n');
    }
}

fn equation(equation: &Equation) -> String {
    let check = equation.check();
    let tick = if check.is_computed() { "✓ " } else { "" };
    let statement = statement_latex(equation.statement());
    format!("```math\n{statement}\n```\n{tick}{}", prose(&check.to_prose()))
}

fn prose(prose: &Prose) -> String {
    let span = |span: &Span| match span {
        Span::Text(text) => markdown(text),
        Span::Formula(formula) => format!("${}$", inline_latex(formula)),
    };
    prose.0.iter().map(span).collect()
}

fn table(table: &Table) -> String {
    let line = |cells: &[Prose]| format!("| {} |\n", cells.iter().map(prose).collect::<Vec<_>>().join(" | "));
    let rule = format!("|{}\n", "---:|".repeat(table.head.len()));
    let rows: String = table.rows.iter().map(|row| line(row)).collect();
    format!("{}{rule}{rows}\n{}", line(&table.head), prose(&table.note))
}
