//! A cell → a number, missing, or neither.

use libration_lab::internals::measurement::number::Cell;
use libration_lab::measurement::DecimalMark;

#[test]
fn a_decimal_comma_stands_once_between_digits() {
    assert_eq!(Cell::parse("-7,85399E-4", DecimalMark::Comma), Cell::Number(-7.85399e-4));
    assert_eq!(Cell::parse("12", DecimalMark::Comma), Cell::Number(12.0));
    for text in ["1.234,5", "1,234,5", "1,234.5", "1.5", "1,", ",5", "1,e3"] {
        assert_eq!(Cell::parse(text, DecimalMark::Comma), Cell::Text, "{text}");
    }
    assert_eq!(Cell::parse("1,5", DecimalMark::Point), Cell::Text);
}

#[test]
fn only_finite_decimals_are_numbers() {
    assert_eq!(Cell::parse(" −1.5e3 ", DecimalMark::Point), Cell::Number(-1500.0));
    assert_eq!(Cell::parse("NaN", DecimalMark::Point), Cell::Missing);
    for text in ["inf", "1e999", "0x10", "1_000", "1 2", "٣", "e", "1m", "1'000"] {
        assert_eq!(Cell::parse(text, DecimalMark::Point), Cell::Text, "{text}");
    }
}
