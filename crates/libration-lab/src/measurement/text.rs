//! Bytes → text: UTF-8, UTF-16 and Windows-1252, with or without a byte order mark.

use std::borrow::Cow;
use std::fmt;

use super::MeasurementError;

/// Character encoding of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Encoding {
    /// UTF-8, plain ASCII included.
    Utf8,
    /// UTF-16, the low byte first.
    Utf16LittleEndian,
    /// UTF-16, the high byte first.
    Utf16BigEndian,
    /// The Western European encoding of Windows, taken where a file is not UTF-8.
    Windows1252,
}

impl fmt::Display for Encoding {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(match self {
            Self::Utf8 => "UTF-8",
            Self::Utf16LittleEndian => "UTF-16LE",
            Self::Utf16BigEndian => "UTF-16BE",
            Self::Windows1252 => "Windows-1252",
        })
    }
}

/// The text, without its byte order mark and with bare carriage returns as line ends.
pub(super) fn decode(bytes: &[u8]) -> Result<(Cow<'_, str>, Encoding), MeasurementError> {
    let (text, encoding) = match bytes {
        [0xff, 0xfe, rest @ ..] => (utf16(u16::from_le_bytes, rest)?, Encoding::Utf16LittleEndian),
        [0xfe, 0xff, rest @ ..] => (utf16(u16::from_be_bytes, rest)?, Encoding::Utf16BigEndian),
        _ if has_zeros_at::<1>(bytes) => (utf16(u16::from_le_bytes, bytes)?, Encoding::Utf16LittleEndian),
        _ if has_zeros_at::<0>(bytes) => (utf16(u16::from_be_bytes, bytes)?, Encoding::Utf16BigEndian),
        _ => utf8_or_windows(bytes)?,
    };
    if let Some(letter) =
        text.chars().find(|&letter| letter.is_control() && !"\t\n\r\u{c}\u{1a}".contains(letter))
    {
        let what =
            if letter == '\0' { "binary (it has NUL bytes)" } else { "binary (it has control characters)" };
        return Err(MeasurementError::NotText(what));
    }
    Ok((with_line_feeds(text), encoding))
}

/// Returns `true` if most of the first pairs of bytes have a zero at this place and none at the other, as letters below U+0100 have in UTF-16.
fn has_zeros_at<const PLACE: usize>(bytes: &[u8]) -> bool {
    let pairs = bytes.as_chunks::<2>().0.iter().take(1000);
    let (all, zeros) = pairs.fold((0, 0), |(all, zeros), pair| {
        (all + 1, zeros + usize::from(pair[PLACE] == 0 && pair[1 - PLACE] != 0))
    });
    2 * zeros > all
}

fn utf16(unit: fn([u8; 2]) -> u16, bytes: &[u8]) -> Result<Cow<'static, str>, MeasurementError> {
    let (pairs, odd) = bytes.as_chunks();
    let text: Result<String, _> = char::decode_utf16(pairs.iter().copied().map(unit)).collect();
    text.ok().filter(|_| odd.is_empty()).map(Cow::Owned).ok_or(MeasurementError::NotText("broken UTF-16"))
}

/// The text of a file in UTF-8 or Windows-1252; one with both letters of UTF-8 and invalid bytes is broken, not of another encoding.
fn utf8_or_windows(bytes: &[u8]) -> Result<(Cow<'_, str>, Encoding), MeasurementError> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    if let Ok(text) = str::from_utf8(bytes) {
        return Ok((text.into(), Encoding::Utf8));
    }
    let has_letters = bytes.utf8_chunks().any(|chunk| !chunk.valid().is_ascii());
    let text: Option<String> = bytes.iter().map(|&byte| windows_1252(byte)).collect();
    match text.filter(|_| !has_letters) {
        Some(text) => Ok((text.into(), Encoding::Windows1252)),
        None => Err(MeasurementError::NotText("broken UTF-8, or in an unknown encoding")),
    }
}

/// The letter of a byte in Windows-1252, in which five bytes are undefined. Table: Unicode Consortium, `CP1252.TXT`, version 2.01.
fn windows_1252(byte: u8) -> Option<char> {
    const FROM_0X80: [char; 32] = [
        '€', '\0', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\0', 'Ž', '\0', '\0', '‘', '’',
        '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\0', 'ž', 'Ÿ',
    ];
    match byte {
        0x80..=0x9f => Some(FROM_0X80[usize::from(byte - 0x80)]).filter(|&letter| letter != '\0'),
        _ => Some(char::from(byte)),
    }
}

/// The text with each line end as a line feed, or a carriage return and a line feed.
fn with_line_feeds(text: Cow<'_, str>) -> Cow<'_, str> {
    let bytes = text.as_bytes();
    let is_bare = |at: usize| bytes[at] == b'\r' && bytes.get(at + 1) != Some(&b'\n');
    if !(0..bytes.len()).any(is_bare) {
        return text;
    }
    text.replace("\r\n", "\n").replace('\r', "\n").into()
}

/// Returns `true` if a line is blank or a comment.
pub(super) fn is_blank_or_comment(line: &str) -> bool {
    let line = line.trim_start();
    line.is_empty() || line.starts_with(COMMENT)
}

/// Characters with which a comment begins.
pub(super) const COMMENT: [char; 2] = ['#', '%'];
