//! Line ends within the quoted cells of a header, as spreadsheets write them: `"Length\n(cm)","Time\n(s)"`.

use std::borrow::Cow;

/// Most lines of a header.
const MOST_LINES: usize = 6;
/// Lines among which a header is.
const LINES: usize = 30;

/// The text with blanks for line ends within quoted cells of the first lines. Empty lines follow, so that lines keep their numbers. A quote that is not
/// closed after a few lines is left as it is.
pub(super) fn within_cells_removed(text: &str) -> Cow<'_, str> {
    if !text.lines().take(LINES).any(is_open) {
        return text.into();
    }
    let (lines, mut out, mut at): (Vec<&str>, _, _) = (text.lines().collect(), String::new(), 0);
    while at < lines.len() {
        let closes = |more: &usize| !is_open(&lines[at..=at + more].join(" "));
        let most = MOST_LINES.min(lines.len() - at);
        let more = if at < LINES { (0..most).find(closes).unwrap_or(0) } else { 0 };
        out += &lines[at..=at + more].join(" ");
        out += &"\n".repeat(more + 1);
        at += more + 1;
    }
    out.into()
}

/// Returns `true` if a quote that begins a cell is not closed in this line.
fn is_open(line: &str) -> bool {
    let mut begins = true;
    let mut is_quoted = false;
    for letter in line.chars() {
        match letter {
            '"' if is_quoted || begins => is_quoted = !is_quoted,
            _ => {}
        }
        begins = !is_quoted && [',', ';', '\t'].contains(&letter);
    }
    is_quoted
}
