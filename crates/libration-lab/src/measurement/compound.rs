//! Numbers of two units, as seconds or inches: `1 min 2.3 s`, `1'02''`, `1:02.3`, `10:05:02.3`; `3 ft 3 3/8 in`, `3' 3 3/8"`; and whole numbers with fractions.

use super::Unit;
use super::heading::Heading;
use super::number::{Cell, DecimalMark, Written};
use super::role::Role;

/// Numbers of two units that a column may contain, by its heading.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum CompoundNumbers {
    /// Minutes and seconds; `1:02` alone may be a time of day.
    #[default]
    Times,
    /// Minutes and seconds, `1:02` too, below a heading such as `t (min:s)`.
    Clock,
    /// Feet and inches.
    Lengths,
}

impl CompoundNumbers {
    /// The numbers below this heading.
    pub(super) fn below(heading: &str) -> Self {
        const CLOCK: [&str; 6] = ["min:s", "mm:ss", "m:ss", "m:s", "mn:s", "min.:s"];
        let plain: String =
            heading.to_lowercase().chars().filter(|character| !character.is_whitespace()).collect();
        match () {
            () if CLOCK.iter().any(|unit| plain.contains(unit)) => Self::Clock,
            () if Role::Lengths.is_said_by(&Heading::read(heading, None, None)) => Self::Lengths,
            () => Self::Times,
        }
    }

    /// The number of a cell in seconds or inches; `None` for cells of other kinds.
    pub(super) fn parse(self, cell: &str, mark: DecimalMark) -> Option<Written<'static>> {
        let cell = cell.trim().to_lowercase().replace("''", "\"").replace(['″', '”'], "\"");
        let cell = cell.replace(['′', '’', '´'], "'");
        self.with_colon(&cell, mark).or_else(|| self.with_units(&cell, mark)).or_else(|| {
            // `3/8` alone may be anything.
            let number = cell.trim_end_matches("inches").trim_end_matches("in").trim_end_matches('"');
            let unit = (number.len() < cell.len()).then_some(Unit::Inch);
            let number = Some(number.trim()).filter(|number| number.contains(' '))?;
            Some(written(mixed(number, mark)?, mark, unit))
        })
    }

    /// `1:02.3`, `0:14`, `00:01:02.3`, and a time of day: `10:05:02.3`, `10:05:02:300`. Hours and minutes of a clock, `10:05`, are not a duration.
    fn with_colon(self, cell: &str, mark: DecimalMark) -> Option<Written<'static>> {
        let (date, cell) = without_date(cell);
        let (hours, rest) = match cell.split_once(':') {
            Some((hours, rest)) if rest.contains(':') => (Some(hours.trim().parse::<u32>().ok()?), rest),
            _ => (None, cell),
        };
        let (minutes, seconds) = rest.split_once(':')?;
        let seconds = &seconds.replacen(':', sign(mark), 1);
        let minutes: u32 = minutes.trim().parse().ok()?;
        let is_known = hours.is_some() || self == Self::Clock || minutes == 0;
        let has_two_digits = seconds.split(['.', ',']).next().is_some_and(|digits| digits.len() == 2);
        let is_of_clock = hours.is_none_or(|hours| hours < 24 && minutes < 60);
        let days = hours.map_or(0, |hours| 24 * date.unwrap_or(0) + hours);
        (has_two_digits && is_of_clock && (is_known || seconds.contains(['.', ','])))
            .then(|| of_minutes(days.checked_mul(60)?.checked_add(minutes)?, seconds, mark))?
    }

    /// A number, a unit, a smaller number and its unit: `1 min 2 s`, `1'02"3`, `3 ft 3 in`.
    fn with_units(self, cell: &str, mark: DecimalMark) -> Option<Written<'static>> {
        let is_of_unit = |letter: char| letter.is_alphabetic() || "'\"".contains(letter);
        let (whole, rest) = cell.split_at(cell.find(is_of_unit)?);
        let (unit, rest) = rest.split_at(rest.find(|letter| !is_of_unit(letter)).unwrap_or(rest.len()));
        let rest = rest.trim_start_matches('.').trim();
        let (smaller, last) = rest.split_at(rest.find(is_of_unit).unwrap_or(rest.len()));
        let (whole, smaller): (u32, &str) = (whole.trim().parse().ok()?, smaller.trim());
        let last = last.trim_end_matches('.');
        let is_of = |unit: &str, of: Unit| unit.is_empty() || unit.parse() == Ok(of);
        // `1'005` is a number with a mark of thousands.
        let is_prime = unit == "'" && (!last.is_empty() || smaller.is_empty());
        let is_foot = is_prime && self == Self::Lengths || unit.parse() == Ok(Unit::Foot);
        if is_foot && is_of(last, Unit::Inch) {
            let inches = if smaller.is_empty() { 0.0 } else { number(smaller, mark)? };
            let length = 12.0 * f64::from(whole) + inches;
            return (0.0..12.0).contains(&inches).then(|| written(length, mark, Some(Unit::Inch)));
        }
        let is_minute = is_prime
            || self != Self::Lengths && ["m", "mn"].contains(&unit)
            || unit.parse() == Ok(Unit::Minute);
        let fraction =
            last.strip_prefix('"').filter(|digits| digits.bytes().all(|byte| byte.is_ascii_digit()));
        match fraction {
            _ if !is_minute || smaller.is_empty() => None,
            Some("") => of_minutes(whole, smaller, mark),
            Some(fraction) => of_minutes(whole, &format!("{smaller}{}{fraction}", sign(mark)), mark),
            None => of_minutes(whole, smaller, mark).filter(|_| is_of(last, Unit::Second)),
        }
    }
}

/// The days from 1 March 2000 to a date before a time of day, and the time: `2025-03-30 10:05:02.3`, `2025-03-30T10:05:02.3Z`.
fn without_date(cell: &str) -> (Option<u32>, &str) {
    let parts = |date: &str| {
        let mut numbers = date.split('-').map(|part| part.parse::<u32>().ok());
        let date = [numbers.next()??, numbers.next()??, numbers.next()??];
        numbers.next().is_none().then_some(date)
    };
    let parts = cell.get(..10).zip(cell.get(10..)).and_then(|(date, rest)| {
        let time = rest.strip_prefix([' ', 't'])?.trim_end_matches('z');
        Some((days(parts(date)?)?, time))
    });
    parts.map_or((None, cell), |(days, time)| (Some(days), time))
}

/// Days from 1 March 2000, of the Gregorian calendar with years that begin in March.
fn days([year, month, day]: [u32; 3]) -> Option<u32> {
    if !(1..=12).contains(&month) || !(1..=31).contains(&day) || !(2001..=9999).contains(&year) {
        return None;
    }
    let (year, month) = if month > 2 { (year - 2000, month - 3) } else { (year - 2001, month + 9) };
    Some(365 * year + year / 4 - year / 100 + year / 400 + (153 * month + 2) / 5 + day - 1)
}

/// Minutes and seconds as seconds, with the decimals of the seconds.
fn of_minutes(minutes: u32, seconds: &str, mark: DecimalMark) -> Option<Written<'static>> {
    let Cell::Number(number) = Cell::parse(seconds, mark) else { return None };
    let (whole, fraction) = seconds.split_at(seconds.find(['.', ',']).unwrap_or(seconds.len()));
    let minutes = Some(minutes).filter(|_| (0.0..60.0).contains(&number))?;
    let whole = minutes.checked_mul(60)?.checked_add(whole.parse().ok()?)?;
    Some(Written { number: format!("{whole}{fraction}").into(), uncertainty: None, unit: Some(Unit::Second) })
}

/// A number with or without a fraction.
fn number(text: &str, mark: DecimalMark) -> Option<f64> {
    match Cell::parse(text, mark) {
        Cell::Number(number) => Some(number),
        _ => mixed(text, mark),
    }
}

/// `3 3/8`, `3/8`: proper fractions of halves, quarters and so on to sixty-fourths.
fn mixed(text: &str, mark: DecimalMark) -> Option<f64> {
    let (rest, denominator) = text.trim().split_once('/')?;
    let (whole, numerator) = rest.trim().rsplit_once(' ').unwrap_or(("0", rest));
    let Cell::Number(whole) = Cell::parse(whole, mark) else { return None };
    let [numerator, denominator] = [numerator, denominator].map(|digits| digits.trim().parse::<u8>().ok());
    let (numerator, denominator) =
        (numerator?, denominator.filter(|denominator| denominator.is_power_of_two() && *denominator <= 64)?);
    let is_proper = numerator < denominator && whole >= 0.0 && whole.fract() == 0.0;
    is_proper.then(|| whole + f64::from(numerator) / f64::from(denominator))
}

fn written(number: f64, mark: DecimalMark, unit: Option<Unit>) -> Written<'static> {
    let number = number.to_string().replace('.', sign(mark));
    Written { number: number.into(), uncertainty: None, unit }
}

fn sign(mark: DecimalMark) -> &'static str {
    match mark {
        DecimalMark::Point => ".",
        DecimalMark::Comma => ",",
    }
}
