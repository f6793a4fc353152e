//! Comma-separated values, quoted where needed (RFC 4180, with bare line feeds).

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

pub(crate) fn quoted(field: &str) -> std::borrow::Cow<'_, str> {
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
