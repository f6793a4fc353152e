//! A cell → a number, missing, or neither.

use super::Unit;
use std::borrow::Cow;

/// Content of a cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cell {
    /// A number.
    Number(f64),
    /// Empty, or a word for a missing value.
    Missing,
    /// Any other text.
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

impl DecimalMark {
    /// Returns `true` for a number with the other mark, which is none with this one.
    pub(super) fn is_missed_in(self, cell: &str) -> bool {
        Cell::parse(cell, self) == Cell::Text && Cell::parse(cell, self.other()).is_number()
    }

    /// The other mark.
    pub(super) fn other(self) -> Self {
        match self {
            Self::Point => Self::Comma,
            Self::Comma => Self::Point,
        }
    }
}

impl Cell {
    /// A finite decimal number with this mark, a missing value, or any other text.
    pub fn parse(cell: &str, mark: DecimalMark) -> Self {
        let cell = cell.trim();
        if MISSING.iter().any(|missing| cell.eq_ignore_ascii_case(missing)) || is_error(cell) {
            return Self::Missing;
        }
        let number = match mark {
            DecimalMark::Point if cell.contains(MINUS) => plain_number(&cell.replace(MINUS, "-")),
            DecimalMark::Point => plain_number(cell),
            DecimalMark::Comma => with_comma(cell),
        };
        let number = number.or_else(|| plain_number(&without_groups(cell, mark)?));
        number.map_or(Self::Text, Self::Number)
    }

    pub(super) fn is_number(self) -> bool {
        matches!(self, Self::Number(_))
    }
}

/// Signs before a negative number other than a hyphen.
const MINUS: [char; 2] = ['−', '–'];
/// Notations for a value that was not measured.
const MISSING: [&str; 11] = ["", "-", "–", "—", "nan", "na", "n/a", "null", "#n/a", "#nv", "#n/d"];

/// Errors of formulas in a spreadsheet: `#DIV/0!`, `#BEZUG!`, `#NAME?`.
fn is_error(cell: &str) -> bool {
    cell.starts_with('#') && cell.ends_with(['!', '?'])
}

/// A number with marks between groups of three digits as one with a decimal point: `1 234,5`, `1'234.5`, and `1.234,5`, where a decimal comma says
/// what the point is.
fn without_groups(cell: &str, mark: DecimalMark) -> Option<String> {
    let (decimal, other) = match mark {
        DecimalMark::Point => ('.', ','),
        DecimalMark::Comma => (',', '.'),
    };
    let (sign, digits) = cell.split_at(usize::from(cell.starts_with(['-', '+'])));
    let (whole, fraction) = digits.split_once(decimal).unwrap_or((digits, ""));
    let between = whole.chars().find(|letter| !letter.is_ascii_digit())?;
    let is_mark = between == other && !fraction.is_empty()
        || [' ', '\u{a0}', '\u{202f}', '\u{2009}', '\'', '’'].contains(&between);
    let mut groups = whole.split(between);
    let first = groups.next()?;
    let are_digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    let are_groups = (1..=3).contains(&first.len())
        && !first.starts_with('0')
        && are_digits(first)
        && groups.all(|group| group.len() == 3 && are_digits(group));
    (is_mark && are_groups && are_digits(fraction))
        .then(|| format!("{sign}{}.{fraction}", whole.replace(between, "")))
}

/// Parts of a cell that is more than a plain number, as `10cm`, `1,5 ± 0,1` and `1.234(5) s` are.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Written<'a> {
    /// The number.
    pub(super) number: Cow<'a, str>,
    /// The uncertainty, in the unit of the number.
    pub(super) uncertainty: Option<f64>,
    /// The unit.
    pub(super) unit: Option<Unit>,
}

impl<'a> Written<'a> {
    /// The parts of a cell; `None` for a plain number and for other texts.
    pub(super) fn parse(cell: &'a str, mark: DecimalMark) -> Option<Self> {
        let cell = cell.trim();
        match SIGNS.iter().find_map(|sign| cell.split_once(sign)) {
            Some((number, uncertainty)) => with_sign(number, uncertainty, mark),
            None => with_brackets(cell, mark).or_else(|| {
                let (number, unit) = with_unit(cell, mark)?;
                Some(Self { number: number.into(), uncertainty: None, unit: Some(unit?) })
            }),
        }
    }
}

/// Signs between a number and its uncertainty.
pub(super) const SIGNS: [&str; 3] = ["±", "+/-", "+-"];

/// `1.5 ± 0.1 s`, `1.5 s ± 0.1 s`, `(1.5 ± 0.1) s`.
fn with_sign<'a>(number: &'a str, uncertainty: &'a str, mark: DecimalMark) -> Option<Written<'a>> {
    let (number, uncertainty, outside) = match number.strip_prefix('(') {
        Some(number) => {
            let (uncertainty, unit) = uncertainty.split_once(')')?;
            (number, uncertainty, if unit.trim().is_empty() { None } else { Some(unit_of_value(unit)?) })
        }
        None => (number, uncertainty, None),
    };
    let [(number, of_number), (uncertainty, of_uncertainty)] =
        [with_unit(number, mark)?, with_unit(uncertainty, mark)?];
    let is_of_one = of_number.is_none() || of_uncertainty.is_none() || of_number == of_uncertainty;
    let Cell::Number(uncertainty) = Cell::parse(uncertainty, mark) else { return None };
    let unit = outside.or(of_number).or(of_uncertainty);
    is_of_one.then_some(Written { number: number.into(), uncertainty: Some(uncertainty), unit })
}

/// `1.234(5)`, `1.234(5) s`: the digits in brackets are the uncertainty of the last digits.
fn with_brackets(cell: &str, mark: DecimalMark) -> Option<Written<'_>> {
    let (number, rest) = cell.split_once('(')?;
    let (digits, unit) = rest.split_once(')')?;
    let is_whole = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
    if !Cell::parse(number, mark).is_number() || !is_whole || number.contains(['e', 'E']) {
        return None;
    }
    let decimals = number.trim().split_once(['.', ',']).map_or(0, |(_, fraction)| fraction.len());
    let uncertainty = format!("{digits}e-{decimals}").parse().ok()?;
    let unit = if unit.trim().is_empty() { None } else { Some(unit_of_value(unit)?) };
    Some(Written { number: number.trim_end().into(), uncertainty: Some(uncertainty), unit })
}

/// A number, and the unit after it if there is one.
fn with_unit(text: &str, mark: DecimalMark) -> Option<(&str, Option<Unit>)> {
    let text = text.trim();
    let is_of_number =
        |c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '−' | '.' | ',' | 'e' | 'E' | ' ');
    let (number, unit) = text.split_at(text.find(|c| !is_of_number(c)).unwrap_or(text.len()));
    let unit = if unit.is_empty() { None } else { Some(unit_of_value(unit)?) };
    Cell::parse(number, mark).is_number().then_some((number.trim_end(), unit))
}

fn unit_of_value(unit: &str) -> Option<Unit> {
    unit.parse().ok().filter(|unit| !matches!(unit, Unit::Count | Unit::Pixel))
}

/// A number with a decimal comma, which stands once between digits, without a point: other commas may be marks of thousands.
fn with_comma(cell: &str) -> Option<f64> {
    let cell = cell.replace(MINUS, "-");
    let Some((whole, fraction)) = cell.split_once(',') else {
        // `1.` numbers a row.
        let whole = cell.strip_suffix('.').unwrap_or(&cell);
        return (!whole.contains('.')).then(|| plain_number(whole)).flatten();
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

/// Number of decimals of a number as written.
pub(super) fn decimals(number: &str) -> u16 {
    let (digits, power) = number.split_once(['e', 'E']).unwrap_or((number, "0"));
    let after = digits.rsplit_once(['.', ',']).map_or(0, |(_, fraction)| fraction.trim_end().len());
    let decimals = i64::try_from(after).unwrap_or(0) - power.parse::<i64>().unwrap_or(0);
    u16::try_from(decimals.clamp(0, 300)).unwrap_or(0)
}
