//! Tables in the notation of Markdown, LaTeX or HTML, or with lines drawn around their cells → lines of cells with tabs between them.

use super::text::is_blank_or_comment;
use std::borrow::Cow;

/// The text with tabs between its cells if it is a table in such a notation, else as it is. Lines keep their numbers.
pub(super) fn plain(text: &str) -> Cow<'_, str> {
    let lower = || text.to_lowercase();
    if text.contains('<') && ["<tr", "<td"].iter().all(|tag| lower().contains(tag)) {
        return of_html(text).into();
    }
    let with = |is_row: &dyn Fn(&str) -> bool| text.lines().filter(|line| is_row(line)).count() > 1;
    if with(&is_row_of_latex) {
        return of_lines(text, is_row_of_latex, latex_cells).into();
    }
    let is_framed =
        with(&|line| line.contains(BARS)) && (text.lines().any(is_rule) || has_bars_everywhere(text));
    if is_framed { of_lines(text, |line| line.contains(BARS), framed_cells).into() } else { text.into() }
}

const BARS: [char; 2] = ['|', '│'];

/// Returns `true` if all lines have as many bars, and there are three or more.
fn has_bars_everywhere(text: &str) -> bool {
    let lines = || text.lines().filter(|line| !is_blank_or_comment(line));
    let bars = |line: &str| line.matches(BARS).count();
    let first = lines().next().map_or(0, bars);
    first > 0 && lines().count() > 2 && lines().all(|line| bars(line) == first)
}

/// A line between rows, as `|---|--:|` and `+----+----+`.
fn is_rule(line: &str) -> bool {
    let letters = || line.trim().chars();
    letters().filter(|letter| "-=─═".contains(*letter)).count() > 2
        && letters().any(|letter| "|+│┼┬┴├┌└".contains(letter))
        && letters().all(|letter| "|+-=: │─═┼┬┴├┤┌┐└┘".contains(letter))
}

/// The cells of the rows; other lines are empty, those before the first row as they are.
fn of_lines(text: &str, is_row: fn(&str) -> bool, cells: fn(&str) -> String) -> String {
    let mut has_begun = false;
    let line = |line: &str| {
        let is_row = is_row(line) && !is_rule(line);
        has_begun |= is_row;
        match is_row {
            true => cells(line),
            false if has_begun || is_rule(line) || line.trim_start().starts_with('\\') => String::new(),
            false => line.to_owned(),
        }
    };
    text.lines().map(line).collect::<Vec<_>>().join("\n")
}

fn framed_cells(line: &str) -> String {
    let cells = line.trim().trim_start_matches(BARS).trim_end_matches(BARS).replace("**", "");
    cells.split(BARS).map(str::trim).collect::<Vec<_>>().join("\t")
}

fn is_row_of_latex(line: &str) -> bool {
    line.contains('&') && line.contains(r"\\")
}

/// Commands of LaTeX with the letters that they stand for; other commands are left out.
const LETTERS: [(&str, &str); 18] = [
    (r"\pm", "±"),
    (r"^{\circ}", "°"),
    (r"^\circ", "°"),
    (r"\circ", "°"),
    (r"\degree", "°"),
    (r"\theta", "θ"),
    (r"\vartheta", "ϑ"),
    (r"\varphi", "φ"),
    (r"\Delta", "Δ"),
    (r"\ell", "ℓ"),
    (r"\omega", "ω"),
    (r"\centi", "c"),
    (r"\milli", "m"),
    (r"\metre", "m"),
    (r"\meter", "m"),
    (r"\second", "s"),
    (r"\%", "%"),
    ("~", " "),
];

fn latex_cells(line: &str) -> String {
    let row = line.split(r"\\").next().unwrap_or_default();
    let row = LETTERS.iter().fold(row.to_owned(), |row, (command, letter)| row.replace(command, letter));
    let mut parts = row.split('\\');
    let first = parts.next().unwrap_or_default().to_owned();
    // After a command of letters its argument follows; other commands, as `\,`, are blanks.
    let plain = parts.fold(first, |row, part| {
        let rest = part.trim_start_matches(|letter: char| letter.is_ascii_alphabetic());
        let rest = if rest.len() < part.len() { rest } else { part.get(1..).unwrap_or_default() };
        row + " " + rest
    });
    let plain = plain.replace(['$', '{', '}'], "");
    let cell = |cell: &str| cell.split_whitespace().collect::<Vec<_>>().join(" ");
    plain.split('&').map(cell).collect::<Vec<_>>().join("\t")
}

/// Names of letters in HTML.
const ENTITIES: [(&str, &str); 7] = [
    ("&nbsp;", " "),
    ("&plusmn;", "±"),
    ("&deg;", "°"),
    ("&sup2;", "²"),
    ("&lt;", "<"),
    ("&gt;", ">"),
    ("&amp;", "&"),
];

/// The rows of a table in HTML, each in the line in which it begins, or in the next one that is free.
fn of_html(text: &str) -> String {
    let (mut out, mut row, mut line, mut written) = (String::new(), None::<String>, 0_usize, 0_usize);
    let mut begun = 0;
    for part in text.split_inclusive(['>', '\n']).flat_map(|part| split_before(part, '<')) {
        line += part.matches('\n').count();
        let tag = part.strip_prefix('<').map(|tag| tag.trim_end_matches('>').to_lowercase());
        let name = tag.as_deref().and_then(|tag| tag.split([' ', '\n']).next());
        match (name, row.as_mut()) {
            (Some("tr"), _) => (row, begun) = (Some(String::new()), line),
            (Some("/tr"), Some(cells)) => {
                out += &"\n".repeat(begun.saturating_sub(written));
                written = begun.max(written) + 1;
                let cells =
                    ENTITIES.iter().fold(cells.clone(), |cells, (name, letter)| cells.replace(name, letter));
                out += &(cells.split('\t').skip(1).map(str::trim).collect::<Vec<_>>().join("\t") + "\n");
                row = None;
            }
            (Some("td" | "th"), Some(cells)) => cells.push('\t'),
            (None, Some(cells)) => cells.push_str(&part.replace(['\n', '\t'], " ")),
            _ => {}
        }
    }
    out
}

/// The text before a letter, and the text from it on.
fn split_before(text: &str, letter: char) -> impl Iterator<Item = &str> {
    let (before, after) = text.split_at(text.find(letter).unwrap_or(text.len()));
    [before, after].into_iter().filter(|part| !part.is_empty())
}
