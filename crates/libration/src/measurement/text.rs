//! Bytes → text: UTF-8 with or without a byte order mark, and a name for whatever else it is.

use std::borrow::Cow;

use super::MeasurementError;

/// The text, without its byte order mark and with line ends of the old Macintosh replaced.
pub(super) fn decode(bytes: &[u8]) -> Result<Cow<'_, str>, MeasurementError> {
    if let Some(kind) = binary_kind(bytes) {
        return Err(MeasurementError::NotText(kind));
    }
    let text =
        str::from_utf8(bytes).map_err(|_| MeasurementError::NotText("in another encoding (or binary)"))?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    Ok(if text.contains('\n') { text.into() } else { text.replace('\r', "\n").into() })
}

fn binary_kind(bytes: &[u8]) -> Option<&'static str> {
    match bytes {
        [0xff, 0xfe, ..] | [0xfe, 0xff, ..] => Some("UTF-16"),
        [b'P', b'K', 3, 4, ..] => Some("a ZIP archive (perhaps a spreadsheet)"),
        [0xd0, 0xcf, 0x11, 0xe0, ..] => Some("an Excel workbook"),
        _ if bytes.contains(&0) => Some("binary (it has NUL bytes)"),
        _ => None,
    }
}

/// Whether a line holds nothing to read.
pub(super) fn is_blank_or_comment(line: &str) -> bool {
    let line = line.trim_start();
    line.is_empty() || line.starts_with('#')
}
