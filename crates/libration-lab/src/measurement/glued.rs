//! A header without a line end, so that the first row follows on the same line: `L (m),T (s)0.25,1.00`.

use super::dialect::{Dialect, TextRow};
use super::number::{Cell, DecimalMark};

/// The text with a line end after its header, and the line that is divided; none where the header has its own line.
///
/// A header is divided where its line has the cells of two rows, or one less because the last name and the first number have nothing between
/// them; the name then ends in a bracket or in a word, as the digit of `T1` may belong to the name.
pub(super) fn divided(text: &str, dialect: Dialect) -> Option<(String, u64)> {
    let plain = Dialect { units: false, ..dialect };
    let mut rows = plain.rows(text);
    let (first, second) = (rows.next()?, rows.next()?);
    let width = second.cells.len();
    let is_of_numbers = |cell: &str| Cell::parse(cell, plain.mark).is_number();
    let are_names = |cells: &[&str]| cells.iter().all(|cell| !cell.is_empty() && !is_of_numbers(cell));
    let cells: Vec<&str> = first.cells.iter().collect();
    if width < 2
        || !second.is_of_numbers(plain.mark)
        || cells.len() + 1 < 2 * width
        || cells.len() > 2 * width
    {
        return None;
    }
    let (names, numbers) = cells.split_at(width);
    if !are_names(names) || !numbers.iter().all(|cell| is_of_numbers(cell)) {
        return None;
    }
    let name = match numbers.len() < width {
        true => name_before_number(names[width - 1], plain.mark)?,
        false => names[width - 1],
    };
    let at = end_of(text, &first, &names[..width - 1], name)?;
    let (head, rest) = text.split_at(at);
    let rest = rest.trim_start_matches([',', ';', '\t', ' ']);
    Some((format!("{head}\n{rest}"), first.line))
}

/// The name in `T (s)0.25` and `period0.25`.
fn name_before_number(cell: &str, mark: DecimalMark) -> Option<&str> {
    let is_of_number = |letter: char| letter.is_ascii_digit() || ".,-+".contains(letter);
    let name = cell.trim_end_matches(is_of_number);
    let ends_with_word = name.chars().rev().take(2).filter(|letter| letter.is_alphabetic()).count() == 2;
    let is_end = name.ends_with([')', ']', ' ']) || ends_with_word;
    (is_end && Cell::parse(&cell[name.len()..], mark).is_number()).then_some(name)
}

/// The byte after the last of these names in the line of a row.
fn end_of(text: &str, row: &TextRow, before: &[&str], last: &str) -> Option<usize> {
    let lines = usize::try_from(row.line).ok()?.checked_sub(1)?;
    let start: usize = text.split_inclusive('\n').take(lines).map(str::len).sum();
    let mut at = start;
    for name in before.iter().copied().chain([last]) {
        at += text.get(at..)?.find(name)? + name.len();
    }
    Some(at)
}
