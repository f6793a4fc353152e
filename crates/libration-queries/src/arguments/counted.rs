//! Number of periods in a row of a table: given by an option, else written in the header, else one.

use libration_lab::measurement::{Column, CountedPeriods, Table};

/// Number of periods that each time of the table lasts.
#[derive(Clone, Copy, Debug, Default, clap::Args)]
pub(crate) struct CountedOptions {
    /// The times are half periods, from one side to the other
    #[arg(long, conflicts_with = "swings_per_reading")]
    half_periods: bool,
    /// Number of swings, full periods, in each time [default: from the header, such as 10T or time for 10 swings, else 1]
    #[arg(long, alias = "periods-per-row", value_name = "N", value_parser = super::positive)]
    swings_per_reading: Option<f64>,
    /// Standard uncertainty of a single timing by hand, such as 0.1s; for repeated readings it is part of their scatter
    #[arg(long, value_name = "TIME", value_parser = super::text::time)]
    reaction_time: Option<f64>,
    /// Standard uncertainty of the error common to all timings, such as 0.05s for an observer who stops late
    #[arg(long, value_name = "TIME", value_parser = super::text::time)]
    shared_timing: Option<f64>,
}

impl CountedOptions {
    /// The standard uncertainty of a single timing.
    pub(super) fn reaction_time(self) -> Option<f64> {
        self.reaction_time
    }

    /// The standard uncertainty of the common error of all timings.
    pub(super) fn shared_timing(self) -> Option<f64> {
        self.shared_timing
    }

    /// The number that was given, with its option.
    pub(super) fn said(self) -> Option<(&'static str, f64)> {
        match (self.half_periods, self.swings_per_reading) {
            (true, _) => Some(("--half-periods", 0.5)),
            (false, count) => Some(("--swings-per-reading", count?)),
        }
    }

    /// The number of periods in the times of a column, with a sentence if it is not one; `usual` if nothing states it. `by_lengths` decides from
    /// the lengths what the number in a heading such as `T5` means.
    pub(super) fn count(
        self,
        table: &Table,
        column: &Column,
        usual: f64,
        by_lengths: impl Fn(f64) -> Option<f64>,
    ) -> Result<(f64, Option<String>), String> {
        let name = table.describe(column).map_err(|error| error.to_string())?;
        let written = table.counted_periods(column).map_err(|error| error.to_string())?;
        let sentence =
            |count: f64| (!is_same(count, 1.0)).then(|| format!("{name} holds times of {}", periods(count)));
        Ok(match (self.said(), written) {
            (Some((option, count)), CountedPeriods::Said(other)) if !is_same(count, other) => {
                let taken = periods(count);
                (
                    count,
                    Some(format!(
                        "{name} is read as times of {taken} (<{option}>), not of {} as its header says",
                        periods(other)
                    )),
                )
            }
            (Some((_, count)), _) => (count, sentence(count)),
            (None, CountedPeriods::Said(count)) => (count, sentence(count)),
            (None, CountedPeriods::Nothing) => (usual, sentence(usual)),
            (None, CountedPeriods::Numbered(count)) if is_same(count, usual) => (usual, sentence(usual)),
            (None, CountedPeriods::Numbered(number)) => {
                let squares =
                    if is_same(number, 2.0) { "; squares have the heading `T^2 (s^2)`" } else { "" };
                let swings = by_lengths(number).ok_or_else(|| {
                    format!(
                        "{name} may hold times of {number} swings, or of one swing in the reading of that number: give \
                         <--swings-per-reading={number}> or <--swings-per-reading=1>{squares}"
                    )
                })?;
                let other = if is_same(swings, 1.0) { number } else { 1.0 };
                let sentence = format!(
                    "{name} holds times of {}: with {} the lengths would give g far from 9.8 m/s² (<--swings-per-reading>)",
                    periods(swings),
                    periods(other)
                );
                (swings, Some(sentence))
            }
            (None, CountedPeriods::Unclear(_)) => {
                return Err(format!(
                    "{name} may hold times of several periods or of parts of one: give the number by <--swings-per-reading>, or \
                     <--half-periods>"
                ));
            }
        })
    }
}

fn periods(count: f64) -> String {
    match count {
        0.5 => "half a period".to_owned(),
        1.0 => "one period".to_owned(),
        count => format!("{count} periods"),
    }
}

fn is_same(one: f64, other: f64) -> bool {
    one.total_cmp(&other).is_eq()
}
