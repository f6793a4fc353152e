//! Provenance of a document: program, version, command line and date.

use super::{Block, DocumentTable};
use crate::call;
use crate::output::table::Column;

/// A table of these for a document that is made now, by the command that was given.
pub(crate) fn provenance() -> Block {
    let call = call::current();
    let words = call.arguments().iter().map(|word| quoted(&word.to_string_lossy()));
    let command: Vec<String> = std::iter::once("libration".to_owned()).chain(words).collect();
    let row = |name: &str, value: String| vec![name.to_owned(), value];
    Block::Table(DocumentTable {
        caption: "Settings for making the report again".to_owned(),
        columns: vec![Column::words("what"), Column::words("which")],
        rows: vec![
            row("program", format!("libration {}", env!("CARGO_PKG_VERSION"))),
            row("command", command.join(" ")),
            row("date", date(now())),
        ],
    })
}

/// Seconds since 1970; those of `SOURCE_DATE_EPOCH` if it is set, so that a report is reproducible.
fn now() -> u64 {
    let given = std::env::var("SOURCE_DATE_EPOCH").ok().and_then(|seconds| seconds.trim().parse().ok());
    given.unwrap_or_else(|| call::current().host().now().as_secs())
}

/// `2026-11-22 03:10 UTC`, in the Gregorian calendar.
pub fn date(seconds: u64) -> String {
    const DAYS_IN_400_YEARS: u64 = 146_097;
    // Days since the 1st of March 1600: a leap day is then the last of its year.
    let days = seconds / 86_400 + DAYS_IN_400_YEARS - 11_017;
    let in_cycle = days % DAYS_IN_400_YEARS;
    let year_of_cycle = (in_cycle - in_cycle / 1460 + in_cycle / 36_524 - in_cycle / 146_096) / 365;
    let day_of_year = in_cycle - (365 * year_of_cycle + year_of_cycle / 4 - year_of_cycle / 100);
    // The months from March on have 31, 30, 31, 30, 31 days again and again: 153 in five.
    let month_from_march = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * month_from_march + 2) / 5 + 1;
    let month = if month_from_march < 10 { month_from_march + 3 } else { month_from_march - 9 };
    let year = 1600 + 400 * (days / DAYS_IN_400_YEARS) + year_of_cycle + u64::from(month <= 2);
    let (hours, minutes) = (seconds / 3600 % 24, seconds / 60 % 60);
    format!("{year:04}-{month:02}-{day:02} {hours:02}:{minutes:02} UTC")
}

/// The word quoted for a shell.
pub fn quoted(word: &str) -> String {
    let plain = |letter: char| letter.is_alphanumeric() || "_-./=+:,@%±^".contains(letter);
    match !word.is_empty() && word.chars().all(plain) {
        true => word.to_owned(),
        false => format!("'{}'", word.replace('\'', r"'\''")),
    }
}
