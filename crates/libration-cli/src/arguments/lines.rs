//! Files that hold one value per line; `-` is the standard input.

use crate::failure::Failure;
use std::fmt::Display;
use std::path::Path;
use std::{fs, io};

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
            "the file holds no value: write one per line",
        ));
    }
    Ok(values)
}

/// The bytes of a file or of the standard input.
pub(crate) fn bytes(path: &Path) -> Result<Vec<u8>, Failure> {
    let mut bytes = vec![];
    let read = match path.as_os_str() == "-" {
        true => io::Read::read_to_end(&mut io::stdin().lock(), &mut bytes).map(|_| bytes),
        false => fs::read(path),
    };
    read.map_err(|error| Failure::NoAnswer(format!("cannot read {}: {error}", path.display())))
}

fn text(path: &Path) -> Result<String, Failure> {
    let text = String::from_utf8(bytes(path)?).ok().filter(|text| !text.contains('\0'));
    let text = text.ok_or_else(|| {
        Failure::no_answer(&path.display().to_string(), "not a text file: write one value per line, in UTF-8")
    })?;
    Ok(text.strip_prefix('\u{feff}').map(str::to_owned).unwrap_or(text))
}
