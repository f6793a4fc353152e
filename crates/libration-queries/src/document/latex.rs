//! A document as LaTeX, and a table as a `tabular` to be copied into a report.

use super::{Block, Document, DocumentFigure, DocumentTable};

/// Head of a document; its packages are part of every distribution of LaTeX.
const PREAMBLE: &str = r"\documentclass[a4paper,11pt]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{textcomp,array,graphicx,longtable}
\usepackage[margin=22mm]{geometry}
\setlength{\parindent}{0pt}
\setlength{\parskip}{6pt}
\setlength{\tabcolsep}{4pt}
\sloppy
";

/// Letters of a line of a table; a table with longer rows breaks the text of its wide columns.
const LETTERS: usize = 100;
/// Number of letters above which a column may be broken.
const WIDE: usize = 24;
/// Number of letters above which a column gets no larger share of the line.
const WIDEST: usize = 40;

/// The whole document; `file_of` gives the file of a picture.
pub(super) fn page(document: &Document, file_of: &dyn Fn(&DocumentFigure) -> String) -> String {
    let title = in_latex(&document.title);
    let sections = document.sections.iter().map(|section| {
        let blocks: String =
            section.blocks.iter().map(|each| format!("{}\n", block(each, file_of))).collect();
        format!("\n\\section*{{{}}}\n{blocks}", in_latex(section.title))
    });
    let sections: String = sections.collect();
    format!(
        "{PREAMBLE}\\begin{{document}}\n{{\\Large\\bfseries {title}\\par}}\n{sections}\n\\end{{document}}\n"
    )
}

fn block(block: &Block, file_of: &dyn Fn(&DocumentFigure) -> String) -> String {
    match block {
        Block::Headline(text) => format!("{{\\large\\bfseries {}\\par}}\n", in_latex(text)),
        Block::Paragraph(text) => in_latex(text) + "\n",
        Block::List(items) => list(items),
        Block::Aside(title, items) => format!("\\textbf{{{}}}\n{}", in_latex(title), list(items)),
        Block::Table(table) => long_table(table),
        Block::Figure(figure) => format!(
            "\\begin{{center}}\n\\includegraphics[width=\\linewidth]{{\\detokenize{{{}}}}}\n\n\\small {}\n\\end{{center}}",
            file_of(figure),
            in_latex(&figure.caption)
        ),
    }
}

fn list(items: &[String]) -> String {
    let items: String = items.iter().map(|item| format!("\\item {}\n", in_latex(item))).collect();
    format!("\\begin{{itemize}}\n{items}\\end{{itemize}}")
}

/// A table that may go over several pages, with its caption above and its head on each.
fn long_table(table: &DocumentTable) -> String {
    let sides = sides(table);
    let heads = line(&mut table.columns.iter().map(|column| column.title.as_str()));
    let rows: Vec<String> = table.rows.iter().map(|row| line(&mut row.iter().map(String::as_str))).collect();
    format!(
        "{{\\small {}:\\par}}\n{{\\footnotesize\n\\begin{{longtable}}[l]{{{sides}}}\n\\hline\n{heads}\n\\hline\n\\endhead\n{}\n\\hline\n\\end{{longtable}}}}",
        in_latex(&table.caption),
        rows.join("\n")
    )
}

/// The column specification in LaTeX: columns with long text share the part of the line that the others leave.
fn sides(table: &DocumentTable) -> String {
    let letters = |column: usize| {
        let cells = table.rows.iter().filter_map(|row| row.get(column)).map(|cell| cell.chars().count());
        let title = table.columns[column].title.chars().count();
        cells.chain([title]).max().unwrap_or(0) + 2
    };
    let widths: Vec<usize> = (0..table.columns.len()).map(letters).collect();
    let is_wide = |width: &usize| *width > WIDE;
    let is_too_wide = widths.iter().sum::<usize>() > LETTERS;
    let narrow: usize = widths.iter().filter(|width| !is_wide(width)).sum();
    let wide: usize = widths.iter().filter(|width| is_wide(width)).map(|width| (*width).min(WIDEST)).sum();
    let room = LETTERS.saturating_sub(narrow).max(LETTERS / 3);
    let side = |(column, width): (usize, &usize)| {
        let is_number = table.columns[column].is_of_numbers();
        if !(is_too_wide && is_wide(width)) {
            return if is_number { "r".to_owned() } else { "l".to_owned() };
        }
        // In thousandths of the line, of which the spaces between columns take a twentieth.
        let part = 950 * room * (*width).min(WIDEST) / (wide * LETTERS);
        let ragged = if is_number { "raggedleft" } else { "raggedright" };
        format!(">{{\\{ragged}\\arraybackslash}}p{{0.{part:03}\\linewidth}}")
    };
    widths.iter().enumerate().map(side).collect()
}

/// A row of a table.
fn line(cells: &mut dyn Iterator<Item = &str>) -> String {
    cells.map(in_latex).collect::<Vec<_>>().join(" & ") + r" \\"
}

/// The environment with a line of heads and one line for each row; needs no package.
pub fn tabular(table: &DocumentTable) -> String {
    let sides: String =
        table.columns.iter().map(|column| if column.is_of_numbers() { 'r' } else { 'l' }).collect();
    let heads = line(&mut table.columns.iter().map(|column| column.title.as_str()));
    let rows: Vec<String> = table.rows.iter().map(|row| line(&mut row.iter().map(String::as_str))).collect();
    format!(
        "% {}\n\\begin{{tabular}}{{{sides}}}\n\\hline\n{heads}\n\\hline\n{}\n\\hline\n\\end{{tabular}}\n",
        table.caption.replace('\n', " "),
        rows.join("\n")
    )
}

/// The text with the special characters of LaTeX, and letters missing in its fonts, escaped.
fn in_latex(text: &str) -> String {
    text.chars().map(letter).collect()
}

fn letter(letter: char) -> String {
    let of_mathematics = MATHEMATICS.iter().find(|(special, _)| *special == letter);
    match letter {
        '\\' => r"\textbackslash{}".to_owned(),
        '~' => r"\textasciitilde{}".to_owned(),
        '^' => r"\textasciicircum{}".to_owned(),
        '&' | '%' | '$' | '#' | '_' | '{' | '}' => format!("\\{letter}"),
        '<' | '>' | '|' => format!("${letter}$"),
        '–' => "--".to_owned(),
        '…' => r"\dots{}".to_owned(),
        letter => match of_mathematics {
            Some((_, spelling)) => format!("${spelling}$"),
            // Of these a font with Latin letters has all.
            None if letter <= 'ž' || "‘’“”".contains(letter) => letter.to_string(),
            None => format!("[U+{:04X}]", u32::from(letter)),
        },
    }
}

const MATHEMATICS: [(char, &str); 47] = [
    ('±', r"\pm"),
    ('−', "-"),
    ('√', r"\sqrt{}"),
    ('∂', r"\partial "),
    ('∞', r"\infty"),
    ('·', r"\cdot"),
    ('≤', r"\le"),
    ('≥', r"\ge"),
    ('°', r"^\circ"),
    ('′', "'"),
    ('″', "''"),
    ('⁻', "^-"),
    ('¹', "^1"),
    ('²', "^2"),
    ('³', "^3"),
    ('⁴', "^4"),
    ('₀', "_0"),
    ('⁵', "^5"),
    ('ⁿ', "^n"),
    ('×', r"\times"),
    ('→', r"\to"),
    ('≈', r"\approx"),
    ('∝', r"\propto"),
    ('φ', r"\varphi"),
    ('τ', r"\tau"),
    ('₃', "_3"),
    ('ₙ', "_n"),
    ('₁', "_1"),
    ('₂', "_2"),
    ('µ', r"\mu"),
    ('α', r"\alpha"),
    ('β', r"\beta"),
    ('γ', r"\gamma"),
    ('δ', r"\delta"),
    ('ε', r"\varepsilon"),
    ('θ', r"\theta"),
    ('κ', r"\kappa"),
    ('λ', r"\lambda"),
    ('μ', r"\mu"),
    ('ν', r"\nu"),
    ('π', r"\pi"),
    ('ρ', r"\rho"),
    ('σ', r"\sigma"),
    ('χ', r"\chi"),
    ('ω', r"\omega"),
    ('Δ', r"\Delta"),
    ('Ω', r"\Omega"),
];
