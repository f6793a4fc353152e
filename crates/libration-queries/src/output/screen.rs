//! Width of a text output, and the part of that width that a text takes.

use crate::call;
use libration::quantity::is_bidirectional;

/// Narrower than this no table can be read.
const NARROWEST: usize = 40;

/// The columns a result may take.
pub(crate) fn width() -> usize {
    call::current().host().columns().max(NARROWEST)
}

/// Removes the characters that move the cursor of a terminal or turn the direction of its text, which names from files may hold; lines stay.
pub(crate) fn clean(text: &mut String) {
    let turns = |letter: char| (letter.is_control() && letter != '\n') || is_bidirectional(letter);
    if text.contains(turns) {
        text.retain(|letter| !turns(letter));
    }
}

/// The columns that a text takes: two for a wide letter, none for combining characters and for the marks of [`MarkedWords`](crate::MarkedWords).
pub fn columns_of(text: &str) -> usize {
    text.chars().map(columns_of_letter).sum()
}

/// The blocks of Unicode 16 that hold wide letters and combining marks, as far as headers of measurements need them.
fn columns_of_letter(letter: char) -> usize {
    match u32::from(letter) {
        0x0300..=0x036F | 0x200B..=0x200F | 0xE000..=0xE002 | 0xFE00..=0xFE0F => 0,
        0x1100..=0x115F
        | 0x2E80..=0xA4CF
        | 0xAC00..=0xD7A3
        | 0xF900..=0xFAFF
        | 0xFE30..=0xFE6F
        | 0xFF00..=0xFF60
        | 0xFFE0..=0xFFE6
        | 0x1F300..=0x1FAFF
        | 0x2_0000..=0x3_FFFD => 2,
        _ => 1,
    }
}

/// The text with trailing blanks, up to this many columns.
pub fn padded(text: &str, columns: usize) -> String {
    format!("{text}{:1$}", "", columns.saturating_sub(columns_of(text)))
}

/// The text in lines of at most `columns` columns, broken at blanks; a longer word has a line of its own.
pub fn folded(text: &str, columns: usize) -> Vec<String> {
    if columns_of(text) <= columns {
        return vec![text.to_owned()];
    }
    let mut lines: Vec<String> = vec![];
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if columns_of(line) + 1 + columns_of(word) <= columns => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}
