//! A cell → a number, missing, or neither.

/// What a cell holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Cell {
    Number(f64),
    Missing,
    Text,
}

/// The mark between whole and fraction besides the point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum DecimalComma {
    Allowed,
    Refused,
}

impl Cell {
    /// A finite decimal number, nothing or a mark for nothing, or any other text.
    pub(super) fn parse(cell: &str, comma: DecimalComma) -> Self {
        let cell = cell.trim();
        if ["", "-", "nan", "na", "n/a", "null"].iter().any(|missing| cell.eq_ignore_ascii_case(missing)) {
            return Self::Missing;
        }
        let plain = cell.replace('−', "-");
        let plain = match comma {
            DecimalComma::Allowed if !plain.contains('.') => plain.replacen(',', ".", 1),
            _ => plain,
        };
        // Rust reads `inf` and `infinity` too, which no instrument means.
        let numeric = |c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '.' | 'e' | 'E');
        match plain.parse::<f64>() {
            Ok(number) if number.is_finite() && plain.chars().all(numeric) => Self::Number(number),
            _ => Self::Text,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_decimal_comma_is_read_where_it_cannot_stand_between_cells() {
        assert_eq!(Cell::parse("-7,85399E-4", DecimalComma::Allowed), Cell::Number(-7.85399e-4));
        assert_eq!(Cell::parse("1,5", DecimalComma::Refused), Cell::Text);
        assert_eq!(Cell::parse("1.234,5", DecimalComma::Allowed), Cell::Text);
        assert_eq!(Cell::parse("1,234,5", DecimalComma::Allowed), Cell::Text);
    }

    #[test]
    fn only_finite_decimals_are_numbers() {
        assert_eq!(Cell::parse(" −1.5e3 ", DecimalComma::Refused), Cell::Number(-1500.0));
        assert_eq!(Cell::parse("NaN", DecimalComma::Refused), Cell::Missing);
        for text in ["inf", "1e999", "0x10", "1_000", "1 2", "٣", "e", "1m"] {
            assert_eq!(Cell::parse(text, DecimalComma::Refused), Cell::Text, "{text}");
        }
    }
}
