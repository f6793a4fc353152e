//! A cell → a number, missing, or neither.

/// What a cell holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Cell {
    Number(f64),
    Missing,
    Text,
}

/// The mark between whole and fraction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DecimalMark {
    /// `1.5`
    Point,
    /// `1,5`
    Comma,
}

impl Cell {
    /// A finite decimal number with this mark, nothing or a mark for nothing, or any other text.
    pub(super) fn parse(cell: &str, mark: DecimalMark) -> Self {
        let cell = cell.trim();
        if ["", "-", "nan", "na", "n/a", "#n/a", "null"]
            .iter()
            .any(|missing| cell.eq_ignore_ascii_case(missing))
        {
            return Self::Missing;
        }
        let number = match mark {
            DecimalMark::Point if cell.contains('−') => plain_number(&cell.replace('−', "-")),
            DecimalMark::Point => plain_number(cell),
            DecimalMark::Comma => with_comma(cell),
        };
        number.map_or(Self::Text, Self::Number)
    }

    pub(super) fn is_number(self) -> bool {
        matches!(self, Self::Number(_))
    }
}

/// A decimal comma stands between digits, once, and there is no point: all else may be a mark of thousands.
fn with_comma(cell: &str) -> Option<f64> {
    let cell = cell.replace('−', "-");
    let Some((whole, fraction)) = cell.split_once(',') else {
        return (!cell.contains('.')).then(|| plain_number(&cell)).flatten();
    };
    let between_digits = whole.ends_with(|letter: char| letter.is_ascii_digit())
        && fraction.starts_with(|letter: char| letter.is_ascii_digit());
    if between_digits && !cell.contains('.') { plain_number(&format!("{whole}.{fraction}")) } else { None }
}

fn plain_number(text: &str) -> Option<f64> {
    // Rust reads `inf` and `infinity` too, which no instrument means.
    let numeric = |c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '.' | 'e' | 'E');
    let number = text.parse::<f64>().ok().filter(|number| number.is_finite());
    number.filter(|_| text.chars().all(numeric))
}

#[cfg(test)]
mod tests {
    use super::*;

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
}
