//! Possible contents of each column, by its own heading and cells.

use crate::measurement::counted_periods::{SwingNumbers, is_mean, is_number_of_swings, swing_numbers};
use crate::measurement::heading::Heading;
use crate::measurement::sheet::Channel;
use crate::measurement::table::Table;
use crate::measurement::{QuantityKind, Role, Unit};

/// Possible contents of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// Values of a quantity.
    Values,
    /// Squares of a quantity.
    Squares,
    /// Means of other columns.
    Means,
    /// Uncertainties.
    Uncertainties,
    /// Steps of a display.
    Resolutions,
    /// Half-widths of intervals.
    HalfWidths,
    /// Numbers of swings.
    Swings,
    /// Numbers of readings.
    NumbersOfReadings,
    /// Names of groups, at least one of which occurs in several rows.
    Group,
    /// Words, numbers of rows, functions of other columns.
    Other,
}

/// Kinds of all columns; that of times of day is given.
pub(super) fn of(table: &Table, clock: Kind) -> Vec<Kind> {
    let channels = &table.sheet().channels;
    let are_times =
        |channel: &Channel| channel.heading.unit.is_some() && Role::Times.is_said_by(&channel.heading);
    let has_times = channels.iter().any(are_times);
    let kind = |channel| if is_clock(channel) { clock } else { kind(channel, has_times) };
    channels.iter().map(kind).collect()
}

/// Returns `true` for times in seconds that increase from an hour or more on: times of day, and no periods.
fn is_clock(channel: &Channel) -> bool {
    const HOUR: f64 = 3600.0;
    let is_late = |number: Option<f64>| number.is_none_or(|number| number >= HOUR);
    channel.heading.unit == Some(Unit::Second) && channel.increases() && channel.numbers().all(is_late)
}

const RESOLUTION: [&str; 5] = ["resolution", "least count", "smallest division", "auflösung", "résolution"];
const HALF_WIDTH: [&str; 6] =
    ["half width", "half-width", "tolerance", "max error", "max. error", "maximum error"];
const GROUP: [&str; 16] = [
    "group", "groups", "team", "student", "students", "name", "names", "class", "pair", "person", "gruppe",
    "schüler", "groupe", "gruppo", "grupo", "table",
];
const NUMBER: [&str; 9] = ["no", "no.", "#", "nr", "nr.", "index", "row", "i", "n"];
/// Beginnings of functions of a quantity.
const FUNCTIONS: [&str; 8] = ["sqrt", "√", "1/", "log", "ln", "sin", "lg", "g_"];

/// The kind of a column in a table with or without times that have a unit.
fn kind(channel: &Channel, has_times: bool) -> Kind {
    let heading = &channel.heading;
    let name = heading.name.to_lowercase();
    let name = name.trim_start_matches("number of ").trim();
    let is = |words: &[&str]| words.iter().any(|word| heading.text.to_lowercase().contains(word));
    let is_group = GROUP.contains(&name) && has_repeated_labels(channel);
    match () {
        () if is_group => Kind::Group,
        () if channel.count() == 0 => Kind::Other,
        () if is(&RESOLUTION) => Kind::Resolutions,
        () if is(&HALF_WIDTH) => Kind::HalfWidths,
        () if heading.is_uncertainty => Kind::Uncertainties,
        () if is_squared(heading) => Kind::Squares,
        () if heading.unit.is_none() && is_number_of_row(heading, channel, name) => Kind::Other,
        () if heading.unit.is_none() && is_number_of_readings(channel, name) => Kind::NumbersOfReadings,
        () if heading.unit.is_none() && is_of_swings(channel, has_times) => Kind::Swings,
        () if GROUP.contains(&name) || FUNCTIONS.iter().any(|word| name.starts_with(word)) => Kind::Other,
        () if is_other_power(heading) => Kind::Other,
        () if is_mean(&heading.text) => Kind::Means,
        () => Kind::Values,
    }
}

/// `T^2`, `T² (s²)`, `T2 (s2)`.
fn is_squared(heading: &Heading) -> bool {
    let unit = heading.unit_text.as_deref().unwrap_or_default().to_lowercase();
    let of_unit = ["s^2", "s²", "s2", "sec^2", "sec²", "s**2"].contains(&unit.as_str());
    let of_name = ["^2", "²", "**2", "squared", "au carré", "al cuadrado", "al quadrato", "quadrat"]
        .iter()
        .any(|power| heading.name.to_lowercase().contains(power));
    of_unit || of_name && heading.unit.is_none() && unit.is_empty()
}

/// Returns `true` for a unit with a power or a quotient that is not a known one.
fn is_other_power(heading: &Heading) -> bool {
    let unit = heading.unit_text.as_deref().unwrap_or_default();
    heading.unit.is_none() && unit.contains(['^', '²', '³'])
}

/// Returns `true` for numbers below words for numbers of swings, if most are whole or half: others among them are refused later, with their line.
/// Below words that may mean another number all must be whole.
fn is_of_swings(channel: &Channel, has_times: bool) -> bool {
    match swing_numbers(&channel.heading.text) {
        SwingNumbers::Said => most_are_numbers(channel),
        SwingNumbers::Possible => {
            let is_bare_n = channel.heading.name.trim().eq_ignore_ascii_case("n");
            if is_bare_n { most_are_whole(channel) } else { has_times && is_of_counts(channel) }
        }
        SwingNumbers::Other => false,
    }
}

fn most_are_numbers(channel: &Channel) -> bool {
    let are_numbers: Vec<bool> = channel.numbers().flatten().map(is_number_of_swings).collect();
    2 * are_numbers.iter().filter(|number| **number).count() >= are_numbers.len()
}

fn most_are_whole(channel: &Channel) -> bool {
    let are_whole: Vec<bool> =
        channel.numbers().flatten().map(|number| number >= 1.0 && number.fract() == 0.0).collect();
    2 * are_whole.iter().filter(|is_whole| **is_whole).count() > are_whole.len()
}

/// `N readings`, `No. of trials`, `Anzahl Messungen`.
fn is_number_of_readings(channel: &Channel, name: &str) -> bool {
    const READINGS: [&str; 6] = ["readings", "trials", "measurements", "repetitions", "messungen", "mesures"];
    const NUMBER: [&str; 9] = ["n", "no", "nr", "number", "of", "anzahl", "der", "nombre", "de"];
    let mut words = name.split(|letter: char| " ._#".contains(letter)).filter(|word| !word.is_empty());
    let is_of_readings = words.next_back().is_some_and(|last| READINGS.contains(&last));
    is_of_readings && words.all(|word| NUMBER.contains(&word)) && is_of_counts(channel)
}

pub(super) fn is_of_counts(channel: &Channel) -> bool {
    channel.numbers().flatten().all(|number| number >= 1.0 && number.fract() == 0.0)
}

/// Whole numbers from one on, one more in each row, perhaps again and again; or the number of the trial.
fn is_number_of_row(heading: &Heading, channel: &Channel, name: &str) -> bool {
    let numbers: Vec<f64> = channel.numbers().flatten().collect();
    let is_next = |pair: &[f64]| (pair[1] - pair[0] - 1.0).abs() < 1e-9;
    // Measurements of a row may be numbered from one again.
    let begins_again = |pair: &[f64]| {
        [pair[1], numbers[0]].iter().all(|number| (number - 1.0).abs() < 1e-9) && pair[0] > 1.0
    };
    let counts_rows = numbers.len() > 1
        && numbers.windows(2).all(|pair| is_next(pair) || begins_again(pair))
        && numbers[0].abs() <= 1.0;
    let is_run = heading.quantity == QuantityKind::Run && heading.index.is_none();
    is_run && is_of_counts(channel) || NUMBER.contains(&name) && counts_rows
}

/// Returns `true` for two labels or more, one of which occurs in several rows.
fn has_repeated_labels(channel: &Channel) -> bool {
    let mut labels: Vec<String> = (0..channel.cells.len()).filter_map(|row| channel.label(row)).collect();
    let all = labels.len();
    labels.sort();
    labels.dedup();
    (2..all).contains(&labels.len())
}
