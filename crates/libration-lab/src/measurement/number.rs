//! A cell → a number, missing, or neither.

use super::Unit;

/// Content of a cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cell {
    /// A number.
    Number(f64),
    /// Nothing, or a word for it.
    Missing,
    /// Something else.
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
    pub fn parse(cell: &str, mark: DecimalMark) -> Self {
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

/// A number and the unit behind it, as in `10cm` and `0.68 s`; none where either is missing or the unit is not one of measured quantities.
pub(super) fn without_unit(cell: &str, mark: DecimalMark) -> Option<(&str, Unit)> {
    let cell = cell.trim();
    let is_of_number =
        |c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '−' | '.' | ',' | 'e' | 'E' | ' ');
    let (number, unit) = cell.split_at(cell.find(|c| !is_of_number(c))?);
    let unit = unit.parse().ok().filter(|unit| !matches!(unit, Unit::Count | Unit::Pixel))?;
    Cell::parse(number, mark).is_number().then_some((number.trim_end(), unit))
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
