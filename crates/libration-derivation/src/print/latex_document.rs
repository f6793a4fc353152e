//! Derivations as a LaTeX document that needs only the packages amsmath and array.

use super::super::document::{Block, Cells, Derivation, DerivationTable};
use super::super::formula::Statement;
use super::super::prose::Prose;
use super::super::typeset::escape::latex_text;
use super::super::typeset::{inline_latex, statement_latex};
use super::{BlockPosition, sentence, write_blocks};

const HEAD: &str = "\\documentclass[11pt,a4paper]{article}
\\usepackage{amsmath}
\\usepackage{array}
\\setlength{\\parindent}{0pt}
\\setlength{\\parskip}{0.6em}
\\setlength{\\textwidth}{15cm}
\\setlength{\\oddsidemargin}{0.5cm}
\\setlength{\\textheight}{23cm}
\\setlength{\\topmargin}{-1cm}
\\postdisplaypenalty=10000
\\newcommand{\\checked}[1]{\\par\\nobreak\\vspace{-0.8em}{\\centering\\footnotesize\\itshape #1\\par}\\vspace{0.4em}}
\\newenvironment{remark}{\\begin{quote}\\small}{\\end{quote}}
";

/// The derivation as a complete document for `pdflatex`.
#[must_use]
pub fn to_latex(derivation: &Derivation) -> String {
    let mut text = HEAD.to_owned();
    text.push_str(&format!("\\title{{{}}}\n\\author{{}}\n\\date{{}}\n", latex_text(&derivation.title)));
    text.push_str("\\begin{document}\n\\maketitle\n");
    write_blocks(&mut text, "\n", BlockPosition::INTRODUCTION, &derivation.introduction, block);
    let mut answers = "\n\\clearpage\n\\part*{Answers}\n";
    for (position, step) in BlockPosition::steps(derivation) {
        if position.is_answer {
            text.push_str(std::mem::take(&mut answers));
            text.push_str(&format!(
                "\n\\section*{{{}\\quad {}}}\n",
                position.step,
                latex_text(&step.heading)
            ));
        } else {
            text.push_str(&format!("\n\\section{{{}}}\n", latex_text(&step.heading)));
        }
        write_blocks(&mut text, "\n", position, &step.blocks, block);
    }
    text.push_str("\n\\end{document}\n");
    text
}

fn block(position: BlockPosition<'_>, block: &Block) -> String {
    match block {
        Block::Paragraph(sentences) => prose(sentences),
        Block::Remark(sentences) => format!("\\begin{{remark}}\n{}\n\\end{{remark}}", prose(sentences)),
        Block::Equation { number, equation } => format!(
            "{}\n\\checked{{{}}}",
            formula(position, *number, equation.statement()),
            prose(&equation.check().to_prose())
        ),
        Block::Exercise { number, statement, .. } => formula(position, *number, statement),
        Block::Table(rows) => table(rows),
        Block::Details { summary, blocks } => {
            let mut inside = format!("\\emph{{{}.}}\n", latex_text(summary));
            write_blocks(&mut inside, "\n", position, blocks, self::block);
            inside
        }
    }
}

/// A displayed formula with its number.
fn formula(position: BlockPosition<'_>, number: usize, statement: &Statement) -> String {
    format!("\\[\n{}\n\\tag{{{}}}\n\\]", statement_latex(statement), position.number(number))
}

fn prose(prose: &Prose) -> String {
    sentence(prose, latex_text, |math| format!("${}$", inline_latex(math)))
}

/// A column for the subjects of the rows, and further columns of equal width with line breaks.
fn formula_columns(columns: usize) -> String {
    let others = columns.saturating_sub(1).max(1);
    // LaTeX leaves about two hundredths of the text width between two columns.
    let percent = 72 / others - if others > 1 { 2 } else { 0 };
    format!("r{}", format!(">{{\\raggedright\\arraybackslash}}p{{0.{percent:02}\\textwidth}}").repeat(others))
}

fn table(table: &DerivationTable) -> String {
    let line = |cells: &[Prose]| cells.iter().map(prose).collect::<Vec<_>>().join(" & ") + " \\\\\n";
    let rows: String = table.rows.iter().map(|row| line(row)).collect();
    format!(
        "\\begin{{center}}\n\\small\n\\begin{{tabular}}{{{}}}\n{}\\hline\n{rows}\\end{{tabular}}\n\\end{{center}}\n\\checked{{{}}}",
        match table.cells {
            Cells::Numbers => "r".repeat(table.head.len()),
            Cells::Formulas => formula_columns(table.head.len()),
        },
        line(&table.head),
        prose(&table.note),
    )
}
