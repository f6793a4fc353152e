//! Numbers in the XML of a workbook that its reader would trust: how many strings there are, and where cells are.

use super::super::MeasurementError;

/// Addresses of more letters or digits do not fit 32 bits; the last cell of the largest worksheet is `XFD1048576`.
const MOST_LETTERS: usize = 6;
const MOST_DIGITS: usize = 9;
/// No workbook has 10⁷ strings.
const MOST_DIGITS_OF_COUNTS: usize = 7;

/// Refuses a part of a workbook with an address or a count that no workbook can have.
pub(super) fn refuse_beyond_reason(name: &str, xml: &[u8]) -> Result<(), MeasurementError> {
    let mut attributes = (0..xml.len()).filter(|&at| xml[at] == b'=').filter_map(|at| attribute(xml, at));
    let is_beyond = |(attribute, value): &(&[u8], &[u8])| match *attribute {
        b"r" | b"ref" => !is_range(value),
        b"uniqueCount" => value.len() > MOST_DIGITS_OF_COUNTS,
        _ => false,
    };
    match attributes.find(is_beyond) {
        Some((_, value)) => {
            let value = libration::quantity::excerpt(&String::from_utf8_lossy(value));
            Err(MeasurementError::DamagedWorkbook(format!(
                "`{value}` in {name} is beyond what a workbook can hold"
            )))
        }
        None => Ok(()),
    }
}

/// The name and the value around the sign of equality at this place, if there are a name and a quoted value.
fn attribute(xml: &[u8], equals: usize) -> Option<(&[u8], &[u8])> {
    let before = xml[..equals].trim_ascii_end();
    let start = before.iter().rposition(u8::is_ascii_whitespace).map_or(0, |at| at + 1);
    let after = xml[equals + 1..].trim_ascii_start();
    let quote = *after.first().filter(|byte| b"\"'".contains(byte))?;
    let value = after[1..].split(|&byte| byte == quote).next()?;
    Some((&before[start..], value))
}

/// An address, or two of which the second is not before the first; what is none at all is for the reader to refuse.
fn is_range(text: &[u8]) -> bool {
    if !text.iter().all(|byte| byte.is_ascii_alphanumeric() || *byte == b':') {
        return true;
    }
    let mut ends = text.split(|&byte| byte == b':').map(place);
    match (ends.next().flatten(), ends.next()) {
        (Some(_), None) => true,
        (Some((column, row)), Some(Some((last_column, last_row)))) => {
            column <= last_column && row <= last_row
        }
        _ => false,
    }
}

/// Column and row of an address such as `XFD1048576`, if they are not too large.
fn place(address: &[u8]) -> Option<(u32, u32)> {
    let letters = address.iter().take_while(|byte| byte.is_ascii_alphabetic()).count();
    let (letters, digits) = address.split_at(letters);
    if letters.len() > MOST_LETTERS || digits.len() > MOST_DIGITS {
        return None;
    }
    let column =
        letters.iter().fold(0, |sum, letter| 26 * sum + u32::from(letter.to_ascii_uppercase() - b'A') + 1);
    let row = digits
        .iter()
        .try_fold(0, |sum, digit| char::from(*digit).to_digit(10).map(|digit| 10 * sum + digit))?;
    Some((column, row))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_and_counts_are_held_to_what_a_workbook_can_hold() {
        for fine in
            ["<c r=\"XFD1048576\" xmlns:r=\"http://x\">", "<dimension ref='A1:B40'/>", "<v>r=12345678901</v>"]
        {
            assert!(refuse_beyond_reason("sheet", fine.as_bytes()).is_ok(), "{fine}");
        }
        for bad in [
            "<c r=\"A1234567890\">",
            "<row r = '4294967298'>",
            "<c ref=\"A1:ABCDEFG1\">",
            "<dimension ref=\"B2:A1\">",
            "<sst uniqueCount=\"99999999\">",
        ] {
            assert!(refuse_beyond_reason("sheet", bad.as_bytes()).is_err(), "{bad}");
        }
    }
}
