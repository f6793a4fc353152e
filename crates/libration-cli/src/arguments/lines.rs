//! Files that hold one value per line; `-` is the standard input.

use super::read_bytes;
use crate::failure::Failure;
use std::fmt::Display;
use std::path::Path;

/// Reads every line that is neither empty nor a comment (`#`) and parses it.
pub(crate) fn read<T, E: Display>(
    path: &Path,
    parse: impl Fn(&str) -> Result<T, E>,
) -> Result<Vec<T>, Failure> {
    let text = text(path)?;
    let mut values = vec![];
    for (number, line) in text.lines().enumerate() {
        let line = line.trim();
        if line.is_empty() || line.starts_with('#') {
            continue;
        }
        let place = || format!("{}, line {}", path.display(), number + 1);
        values.push(parse(line).map_err(|reason| Failure::no_answer(&place(), reason))?);
    }
    if values.is_empty() {
        return Err(Failure::no_answer(
            &path.display().to_string(),
            "the file has no values: write one per line",
        ));
    }
    Ok(values)
}

fn text(path: &Path) -> Result<String, Failure> {
    let text = String::from_utf8(read_bytes(path)?).ok().filter(|text| !text.contains('\0'));
    let text = text.ok_or_else(|| {
        Failure::no_answer(&path.display().to_string(), "not a text file: write one value per line, in UTF-8")
    })?;
    Ok(text.strip_prefix('\u{feff}').map(str::to_owned).unwrap_or(text))
}
