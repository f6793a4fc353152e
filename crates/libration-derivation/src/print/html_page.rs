//! Derivations as one HTML page: formulas in MathML, embedded style, no external resources.

use super::super::answers::Judgement;
use super::super::check::CheckedEquation;
use super::super::document::{Block, Cells, Derivation, DerivationTable};
use super::super::formula::Statement;
use super::super::prose::Prose;
use super::super::typeset::escape::html;
use super::super::typeset::layout::{Layout, Style};
use super::super::typeset::lines::{self, Lines};
use super::super::typeset::mathml;
use super::{BlockPosition, sentence, write_blocks};

const STYLE: &str = "
:root { color-scheme: light dark; --ink: #1c1c1c; --paper: #fdfcf9; --soft: #6b6b6b; --line: #d9d5cb; --tick: #2c7a3f }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e4e2dc; --paper: #181a1b; --soft: #a09c92; --line: #3b3d3e; --tick: #7cc48d }
}
body { max-width: 44rem; margin: 3rem auto; padding: 0 1.2rem; color: var(--ink); background: var(--paper);
  font: 1.05rem/1.6 Charter, 'Bitstream Charter', 'Iowan Old Style', Georgia, 'Times New Roman', serif }
h1 { font-size: 1.7rem; line-height: 1.25 }
h2 { font-size: 1.2rem; margin-top: 2.4rem; border-top: 1px solid var(--line); padding-top: 1rem }
math { font-size: 1.06em }
.formula { display: flex; align-items: center; padding: .3rem 0 }
.formula math { flex: 1; overflow-x: auto; overflow-y: hidden }
.number, h2 a { color: var(--soft); text-decoration: none }
.number { font-size: .82rem; padding-left: .6rem }
.number:hover, h2 a:hover, .formula:target .number { color: var(--tick) }
.formula mtd { padding: .25em .1em }
.formula mtd:first-child { text-align: right }
.formula mtd + mtd { text-align: left }
.check { color: var(--soft); font-size: .82rem; line-height: 1.4; text-align: center; margin: 0 1rem 1rem }
.computed::before { content: '✓ '; color: var(--tick); font-weight: bold }
.remark { border-left: 3px solid var(--line); margin-left: 0; padding-left: 1rem; color: var(--soft) }
.wide { overflow-x: auto }
table { border-collapse: collapse; margin: 1rem auto .4rem; font-size: .92rem; font-variant-numeric: tabular-nums }
th, td { padding: .2rem .7rem; text-align: right; white-space: nowrap }
thead th { border-bottom: 1px solid var(--ink); font-weight: normal }
tbody tr + tr td { border-top: 1px solid var(--line) }
.formulas td + td, .formulas th { text-align: left; white-space: normal }
details { border-left: 3px solid var(--line); padding-left: 1rem; margin: .5rem 0 }
summary { color: var(--soft); font-size: .92rem; cursor: pointer }
.answers { break-before: page; margin-top: 5rem }
@media print {
  details::details-content { content-visibility: visible; block-size: auto }
  .formula, .formula + .check, tr, table:not(.formulas) { break-inside: avoid }
  h2, summary, .formula:has(+ .check), p:has(+ .formula), p:has(+ .wide) { break-after: avoid }
}
";

/// The derivation as a standalone page.
#[must_use]
pub fn to_html(derivation: &Derivation) -> String {
    let title = html(&derivation.title);
    let mut page = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{title}</title>\n<style>{STYLE}</style>\n</head>\n<body>\n<h1>{title}</h1>\n"
    );
    write_blocks(&mut page, "", BlockPosition::INTRODUCTION, &derivation.introduction, block);
    let mut answers = "<h1 class=\"answers\" id=\"answers\">Answers</h1>\n";
    for (position, step) in BlockPosition::steps(derivation) {
        let BlockPosition { id, step: number, is_answer } = position;
        if is_answer {
            page.push_str(std::mem::take(&mut answers));
        }
        let own_id = if is_answer { format!("answers-{id}") } else { id.to_owned() };
        let heading = html(&step.heading);
        page.push_str(&format!(
            "<section id=\"{own_id}\">\n<h2><a href=\"#{id}\">{number}.</a> {heading}</h2>\n"
        ));
        write_blocks(&mut page, "", position, &step.blocks, block);
        page.push_str("</section>\n");
    }
    page.push_str("</body>\n</html>\n");
    page
}

/// The judgement of an answer as a paragraph, whose class is `right`, `long` or `wrong`.
#[must_use]
pub fn judgement_to_html(judgement: &Judgement) -> String {
    let class = match judgement {
        Judgement::Right => "right",
        Judgement::NotSimplified => "long",
        Judgement::Wrong(_) => "wrong",
    };
    format!("<p class=\"{class}\">{}</p>\n", prose(&judgement.to_prose()))
}

fn block(position: BlockPosition<'_>, block: &Block) -> String {
    match block {
        Block::Paragraph(sentences) => format!("<p>{}</p>", prose(sentences)),
        Block::Remark(sentences) => format!("<p class=\"remark\">{}</p>", prose(sentences)),
        Block::Equation { number, equation: checked } => equation(position, *number, checked),
        Block::Exercise { number, statement: asked, is_comparable } => {
            formula(position, *number, asked, *is_comparable)
        }
        Block::Table(rows) => table(rows),
        Block::Details { summary, blocks } => {
            let mut inside = String::new();
            write_blocks(&mut inside, "", position, blocks, self::block);
            format!("<details>\n<summary>{}</summary>\n{inside}</details>", html(summary))
        }
    }
}

fn prose(prose: &Prose) -> String {
    sentence(prose, html, |math| format!("<math>{}</math>", mathml(&Style::Inline.formula(math))))
}

fn equation(position: BlockPosition<'_>, number: usize, equation: &CheckedEquation) -> String {
    let class = if equation.check().is_computed() { "check computed" } else { "check" };
    let check = prose(&equation.check().to_prose());
    format!("{}\n<p class=\"{class}\">{check}</p>", formula(position, number, equation.statement(), false))
}

/// A displayed formula with its number, which is a link to the formula; its class says whether answers to it can be compared.
fn formula(position: BlockPosition<'_>, number: usize, statement: &Statement, is_comparable: bool) -> String {
    let Lines { left, right } = lines::statement(statement);
    let inside = match right.as_slice() {
        [] => mathml(&left),
        [line] => format!("<mrow>{}{}</mrow>", mathml(&left), mathml(line)),
        lines => aligned(&left, lines),
    };
    let (id, numeral) = (format!("{}.{number}", position.id), position.number(number));
    let attribute = if position.is_answer { String::new() } else { format!(" id=\"{id}\"") };
    let class = if is_comparable { "formula to-answer" } else { "formula" };
    format!(
        "<div class=\"{class}\"{attribute}><math display=\"block\">{inside}</math><a class=\"number\" href=\"#{id}\">({numeral})</a></div>"
    )
}

fn aligned(left: &Layout, lines: &[Layout]) -> String {
    let mut left = mathml(left);
    let row = |line: &Layout| {
        let left = std::mem::take(&mut left);
        format!("<mtr><mtd>{left}</mtd><mtd>{}</mtd></mtr>", mathml(line))
    };
    format!("<mtable displaystyle=\"true\">{}</mtable>", lines.iter().map(row).collect::<String>())
}

fn table(table: &DerivationTable) -> String {
    let cells = |tag: &str, cells: &[Prose]| -> String {
        cells.iter().map(|cell| format!("<{tag}>{}</{tag}>", prose(cell))).collect()
    };
    let rows: String = table.rows.iter().map(|row| format!("<tr>{}</tr>\n", cells("td", row))).collect();
    format!(
        "<div class=\"wide\"><table{}>\n<thead><tr>{}</tr></thead>\n<tbody>\n{rows}</tbody>\n</table></div>\n<p class=\"check\">{}</p>",
        if table.cells == Cells::Formulas { " class=\"formulas\"" } else { "" },
        cells("th", &table.head),
        prose(&table.note)
    )
}
