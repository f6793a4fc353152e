//! Files that hold one value per line; `-` is the standard input.

use super::read_bytes;
use crate::parallel;
use crate::query_error::QueryError;
use std::fmt::Display;
use std::path::Path;

/// Lines that one core parses at a time: a millisecond's work.
const PIECE: usize = 4096;

/// Reads every line that is neither empty nor a comment (`#`) and parses it.
pub(crate) fn read<T: Send, E: Display + Send>(
    path: &Path,
    parse: impl Fn(&str) -> Result<T, E> + Sync,
) -> Result<Vec<T>, QueryError> {
    values(path, &text(path)?, parse)
}

/// The same of the text of a file.
pub(super) fn values<T: Send, E: Display + Send>(
    path: &Path,
    text: &str,
    parse: impl Fn(&str) -> Result<T, E> + Sync,
) -> Result<Vec<T>, QueryError> {
    let lines: Vec<(usize, &str)> = numbered(text).collect();
    let pieces: Vec<&[(usize, &str)]> = lines.chunks(PIECE).collect();
    let parse = |&(number, line): &(usize, &str)| parse(line.trim()).map_err(|reason| (number, reason));
    let parsed: Vec<Result<Vec<T>, (usize, E)>> =
        parallel::map(&pieces, |piece| piece.iter().map(parse).collect());
    let mut values = Vec::with_capacity(lines.len());
    for piece in parsed {
        let location = |number| format!("{}, line {number}", path.display());
        values.extend(piece.map_err(|(number, reason)| QueryError::no_result(&location(number), reason))?);
    }
    if values.is_empty() {
        return Err(QueryError::no_result(
            &path.display().to_string(),
            "the file has no values: write one per line",
        ));
    }
    Ok(values)
}

/// The lines that are neither empty nor a comment, with their numbers.
pub(super) fn numbered(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let is_comment = |line: &str| line.trim().is_empty() || line.trim_start().starts_with('#');
    (1..).zip(text.lines()).filter(move |(_, line)| !is_comment(line))
}

/// The text of a file or, for `-`, of the standard input.
pub(super) fn text(path: &Path) -> Result<String, QueryError> {
    let text = String::from_utf8(read_bytes(path)?).ok().filter(|text| !text.contains('\0'));
    let text = text.ok_or_else(|| {
        QueryError::no_result(&path.display().to_string(), "not a text file: write it in UTF-8")
    })?;
    Ok(text.strip_prefix('\u{feff}').map(str::to_owned).unwrap_or(text))
}
