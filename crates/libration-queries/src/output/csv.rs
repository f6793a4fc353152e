//! Comma-separated values, quoted where needed (RFC 4180, with bare line feeds).

use super::number;
use std::io::{self, Write};

/// Writes one line.
pub fn line<S: AsRef<str>>(out: &mut dyn Write, fields: &[S]) -> io::Result<()> {
    for (index, field) in fields.iter().enumerate() {
        if index > 0 {
            out.write_all(b",")?;
        }
        out.write_all(quoted(field.as_ref()).as_bytes())?;
    }
    out.write_all(b"\n")
}

/// The name of the error of a column.
pub(crate) fn error_of(name: &str) -> String {
    format!("{name}_error")
}

/// The cell of a number, which is empty where that is not finite.
pub(crate) fn number(value: f64) -> String {
    if value.is_finite() { number::exact(value) } else { String::new() }
}

/// The fields of a line without its end, as [`line`] writes it.
pub fn cells(line: &str) -> Vec<String> {
    let mut cells = vec![String::new()];
    let mut is_quoted = false;
    let mut letters = line.chars().peekable();
    while let Some(letter) = letters.next() {
        let cell = cells.last_mut().expect("there is always a cell");
        match letter {
            '"' if is_quoted && letters.peek() == Some(&'"') => cell.extend(letters.next()),
            '"' => is_quoted = !is_quoted,
            ',' if !is_quoted => cells.push(String::new()),
            other => cell.push(other),
        }
    }
    cells
}

pub(crate) fn quoted(field: &str) -> std::borrow::Cow<'_, str> {
    // By bytes: a search for characters took a third of the time of a table.
    if field.bytes().any(|byte| matches!(byte, b',' | b'"' | b'\n' | b'\r')) {
        format!("\"{}\"", field.replace('"', "\"\"")).into()
    } else {
        field.into()
    }
}
