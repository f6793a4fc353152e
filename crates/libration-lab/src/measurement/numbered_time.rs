//! Headings of a time with a number after its symbol: `T5 (s)`, `t_{10} / s`, `Time 3`, `T (20) in s`.
//!
//! The number is that of a reading if columns of the same symbol have successive numbers; in a single column it is as often the number of swings.

use super::QuantityKind;
use super::heading::named;
use super::table::Table;
use super::words::{UNITS_OF_TIME, is, number as in_digits, words};

/// Names of periods.
const PERIODS: [&str; 6] = ["period", "periode", "période", "periodo", "período", "schwingungsdauer"];

/// The whole number after the symbol of a time.
pub(super) fn number(heading: &str) -> Option<f64> {
    let words = words(heading);
    let (symbol, rest) = words.split_first()?;
    if named(symbol) != QuantityKind::Time && !is(&PERIODS, symbol) {
        return None;
    }
    let (first, rest) = rest.split_first()?;
    // `T5_2` is the second reading of five swings.
    let rest =
        rest.split_first().filter(|(again, _)| in_digits(again).is_some()).map_or(rest, |(_, others)| others);
    let is_unit = |word: &String| matches!(word.as_str(), "/" | "in" | "seconds") || is(&UNITS_OF_TIME, word);
    let whole = in_digits(first).filter(|digit| digit.fract() == 0.0 && !symbol.is_empty())?;
    rest.iter().all(is_unit).then_some(whole)
}

/// The heading up to its first digit.
pub(super) fn symbol(heading: &str) -> &str {
    heading.split(|letter: char| letter.is_ascii_digit()).next().unwrap_or_default()
}

/// Returns `true` if the number in the heading of this column is that of a reading: another column of the same symbol has the next one, or the one
/// before.
pub(super) fn is_of_reading(table: &Table, column: usize) -> bool {
    let channels = &table.sheet().channels;
    let of = |index: usize| {
        let heading = &channels[index].heading;
        let symbol = words(&heading.text).first().cloned();
        let is_value = !heading.is_uncertainty && channels[index].count() > 0;
        number(&heading.text).filter(|_| is_value).zip(symbol)
    };
    let Some((number, symbol)) = of(column) else { return false };
    let is_next = |(other, name): (f64, String)| name == symbol && ((other - number).abs() - 1.0).abs() < 0.5;
    (0..channels.len()).filter_map(of).any(is_next)
}
