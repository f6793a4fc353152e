//! A table as a LaTeX `tabular`, to be copied into a report.

use super::DocumentTable;

/// The environment with a line of heads and one line for each row; needs no package.
pub fn tabular(table: &DocumentTable) -> String {
    let sides: String =
        table.columns.iter().map(|column| if column.is_of_numbers() { 'r' } else { 'l' }).collect();
    let line =
        |cells: &mut dyn Iterator<Item = &str>| cells.map(in_latex).collect::<Vec<_>>().join(" & ") + r" \\";
    let heads = line(&mut table.columns.iter().map(|column| column.title.as_str()));
    let rows: Vec<String> = table.rows.iter().map(|row| line(&mut row.iter().map(String::as_str))).collect();
    format!(
        "% {}\n\\begin{{tabular}}{{{sides}}}\n\\hline\n{heads}\n\\hline\n{}\n\\hline\n\\end{{tabular}}\n",
        table.caption.replace('\n', " "),
        rows.join("\n")
    )
}

/// The text with what LaTeX would take for its own, and letters its fonts do not have, in its own spelling.
fn in_latex(text: &str) -> String {
    text.chars().map(letter).collect()
}

fn letter(letter: char) -> String {
    let of_mathematics = MATHEMATICS.iter().find(|(found, _)| *found == letter);
    match letter {
        '\\' => r"\textbackslash{}".to_owned(),
        '~' => r"\textasciitilde{}".to_owned(),
        '^' => r"\textasciicircum{}".to_owned(),
        '&' | '%' | '$' | '#' | '_' | '{' | '}' => format!("\\{letter}"),
        '<' | '>' | '|' => format!("${letter}$"),
        '–' => "--".to_owned(),
        '…' => r"\dots{}".to_owned(),
        letter => of_mathematics.map_or_else(|| letter.to_string(), |(_, spelling)| format!("${spelling}$")),
    }
}

const MATHEMATICS: [(char, &str); 36] = [
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
];
