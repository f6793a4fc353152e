//! A cell → a number, missing, or neither.

use libration_lab::internals::measurement::number::Cell;
use libration_lab::measurement::DecimalMark;

#[test]
fn a_decimal_comma_stands_once_between_digits() {
    assert_eq!(Cell::parse("-7,85399E-4", DecimalMark::Comma), Cell::Number(-7.85399e-4));
    assert_eq!(Cell::parse("12", DecimalMark::Comma), Cell::Number(12.0));
    for text in ["1.234", "0.123,5", "1.23,5", "1,234,5", "1,234.5", "1.5", "1,", ",5", "1,e3"] {
        assert_eq!(Cell::parse(text, DecimalMark::Comma), Cell::Text, "{text}");
    }
    assert_eq!(Cell::parse("1,5", DecimalMark::Point), Cell::Text);
}

#[test]
fn only_finite_decimals_are_numbers() {
    assert_eq!(Cell::parse(" −1.5e3 ", DecimalMark::Point), Cell::Number(-1500.0));
    assert_eq!(Cell::parse("–1.5e−3", DecimalMark::Point), Cell::Number(-0.0015));
    assert_eq!(Cell::parse("NaN", DecimalMark::Point), Cell::Missing);
    for text in ["inf", "1e999", "0x10", "1_000", "1 2", "٣", "e", "1m", "1,234", "1 23", "0 123", "1'00"] {
        assert_eq!(Cell::parse(text, DecimalMark::Point), Cell::Text, "{text}");
    }
}

/// Groups of three digits, where the decimal mark, or a sign that is never one, says what is between them.
#[test]
fn marks_between_groups_of_digits_are_read() {
    for text in ["1.234,5", "1 234,5", "1\u{a0}234,5", "1\u{202f}234,5", "1'234,5"] {
        assert_eq!(Cell::parse(text, DecimalMark::Comma), Cell::Number(1234.5), "{text}");
    }
    for (text, number) in [("1,234.5", 1234.5), ("1'000", 1000.0), ("-12’345’678", -12_345_678.0)] {
        assert_eq!(Cell::parse(text, DecimalMark::Point), Cell::Number(number), "{text}");
    }
}

#[test]
fn errors_of_spreadsheets_and_dashes_are_missing() {
    for text in ["#DIV/0!", "#N/A", "#NV", "#BEZUG!", "#NAME?", "#¡VALOR!", "–"] {
        assert_eq!(Cell::parse(text, DecimalMark::Comma), Cell::Missing, "{text}");
    }
    assert_eq!(Cell::parse("#3", DecimalMark::Comma), Cell::Text);
}
