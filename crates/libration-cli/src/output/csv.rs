//! Comma-separated values, quoted where needed (RFC 4180, with bare line feeds).

use super::field::Fields;
use std::io::{self, Write};

/// Writes one line.
pub(crate) fn line<S: AsRef<str>>(out: &mut dyn Write, fields: &[S]) -> io::Result<()> {
    for (index, field) in fields.iter().enumerate() {
        if index > 0 {
            out.write_all(b",")?;
        }
        out.write_all(quoted(field.as_ref()).as_bytes())?;
    }
    out.write_all(b"\n")
}

/// Writes the names of the fields, and a line for each answer.
pub(crate) fn table<'a, A: 'a>(
    out: &mut dyn Write,
    fields: &Fields<A>,
    answers: impl IntoIterator<Item = &'a A>,
) -> io::Result<()> {
    line(out, &fields.csv_names())?;
    answers.into_iter().try_for_each(|answer| line(out, &fields.csv_cells(answer)))
}

fn quoted(field: &str) -> std::borrow::Cow<'_, str> {
    if field.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", field.replace('"', "\"\"")).into()
    } else {
        field.into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commas_and_quotes_are_quoted() {
        let mut text = vec![];
        line(&mut text, &["a,b", "say \"a\"", "plain"]).unwrap();
        assert_eq!(String::from_utf8(text).unwrap(), "\"a,b\",\"say \"\"a\"\"\",plain\n");
    }
}
