//! Negative values on the command line: `-30deg` is an angle and not an option.

use std::ffi::OsString;

/// Puts a blank before each argument that begins like a negative quantity, which the parsers of quantities
/// skip and which keeps it from being taken for an option.
pub fn protect_negative_values(arguments: impl Iterator<Item = OsString>) -> Vec<OsString> {
    arguments
        .map(|argument| if is_negative(&argument) { blank_before(&argument) } else { argument })
        .collect()
}

fn is_negative(argument: &OsString) -> bool {
    let after_sign = argument.to_str().and_then(|text| text.strip_prefix(['-', '−']));
    after_sign.is_some_and(|rest| {
        rest.starts_with(|c: char| c.is_ascii_digit() || c == '.')
            || ["pi", "π", "inf", "nan"].iter().any(|word| rest.to_lowercase().starts_with(word))
    })
}

fn blank_before(argument: &OsString) -> OsString {
    let mut protected = OsString::from(" ");
    protected.push(argument);
    protected
}
