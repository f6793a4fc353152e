//! The rows of a table in units of the SI, with repeated readings as means.

use super::column_units::ColumnUnits;
use super::{ChosenColumns, Wanted};
use crate::call::in_words;
use crate::output::number;
use libration_lab::fit::{ReadingSummary, RepeatedReadings};
use libration_lab::measurement::{Readings, Table, UncertaintyKind, is_number_of_swings};

/// The rows of a table on their way to the SI.
pub(super) struct SiRows<'a, const N: usize> {
    pub(super) table: &'a Table,
    pub(super) chosen: &'a ChosenColumns<N>,
    pub(super) wanted: &'a [Wanted; N],
    pub(super) units: &'a ColumnUnits<N>,
    pub(super) read: &'a Readings,
    /// The number of swings of each row, by a column.
    pub(super) swings: Option<Vec<f64>>,
    /// The number of readings of each row, by a column.
    pub(super) numbers_of_readings: Option<Vec<f64>>,
}

impl<const N: usize> SiRows<'_, N> {
    /// The rows, if their numbers of swings are usable.
    pub(super) fn checked(self) -> Result<Self, String> {
        let bad = self.swings.iter().flatten().position(|swings| !is_number_of_swings(*swings));
        let is_whole = |number: &f64| *number >= 1.0 && number.fract() == 0.0 && *number < 1e6;
        let none = self.numbers_of_readings.iter().flatten().position(|number| !is_whole(number));
        let line = |row: usize| self.read.lines[row];
        match (bad, none) {
            (Some(row), _) => Err(format!(
                "line {}: the number of swings is not a positive whole or half number",
                line(row)
            )),
            (None, Some(row)) => {
                Err(format!("line {}: the number of readings is not a positive whole number", line(row)))
            }
            (None, None) => match self.bad_deviation() {
                Some(row) => {
                    Err(format!("line {}: the standard deviation of the readings is negative", line(row)))
                }
                None => Ok(self),
            },
        }
    }

    /// The first row with a negative standard deviation of its readings.
    fn bad_deviation(&self) -> Option<usize> {
        let are_deviations = |index: &usize| self.chosen.kinds[*index] == UncertaintyKind::Deviation;
        let columns =
            (0..N).filter(are_deviations).filter(|index| self.wanted[*index].uncertainties_of.is_some());
        let negative = |of: usize| {
            self.read.quantities[of].iter().position(|readings| readings.iter().any(|&reading| reading < 0.0))
        };
        columns.filter_map(negative).min()
    }

    /// Number of periods in a time; one for other quantities.
    fn swings_of(&self, index: usize, row: usize) -> f64 {
        match &self.swings {
            Some(swings) if self.wanted[index].counted.is_some_and(|counted| counted.said().is_none()) => {
                swings[row]
            }
            _ => self.units.counts[index],
        }
    }

    /// The readings of a row in the SI, not divided by the number of periods.
    fn readings(&self, index: usize, row: usize) -> Vec<f64> {
        let in_si = |number: &f64| {
            let value = self.units.units[index].to_si(*number);
            // A square of times is as often of seconds as the unit of the times is.
            if self.chosen.are_squares[index] { number.sqrt() } else { value }
        };
        self.read.quantities[index][row].iter().map(in_si).collect()
    }

    /// The last digit of the readings, in the SI.
    fn step(&self, index: usize) -> f64 {
        let steps = self.chosen.columns[index].iter().map(|column| self.table.step(column).unwrap_or(0.0));
        let step = self.units.units[index].to_si(steps.fold(0.0, f64::max));
        if self.chosen.are_squares[index] { 0.0 } else { step }
    }

    /// The repeated readings of a column, converted to single periods.
    pub(super) fn repeated(&self, index: usize) -> Option<RepeatedReadings> {
        if self.wanted[index].uncertainties_of.is_some() {
            return None;
        }
        let rows = 0..self.read.lines.len();
        let readings: Vec<Vec<f64>> = rows.map(|row| self.readings(index, row)).collect();
        let mut repeated = match self.summaries(index, &readings) {
            Some(summaries) => RepeatedReadings::of_summaries(&summaries, self.step(index))?,
            None if self.chosen.columns[index].len() > 1 => {
                RepeatedReadings::new(&readings, self.step(index))?
            }
            None => return None,
        };
        for (row, mean) in repeated.rows.iter_mut().enumerate() {
            *mean = mean.times(1.0 / self.swings_of(index, row));
        }
        Some(repeated)
    }

    /// Means, standard deviations and numbers of readings, where columns hold them.
    fn summaries(&self, index: usize, means: &[Vec<f64>]) -> Option<Vec<ReadingSummary>> {
        let numbers = self.numbers_of_readings.as_ref()?;
        let is_deviation = |of: &usize| {
            self.wanted[*of].uncertainties_of == Some(index)
                && self.chosen.kinds[*of] == UncertaintyKind::Deviation
                && !self.chosen.columns[*of].is_empty()
        };
        let column = (0..N).find(is_deviation)?;
        let deviations = self.written(column, index, |written| self.units.units[column].to_si(written));
        let rows = means.iter().zip(deviations).zip(numbers);
        Some(rows.map(|((mean, deviation), number)| summary(mean[0], deviation, *number)).collect())
    }

    /// Standard uncertainties by rounding.
    pub(super) fn rounding(&self, index: usize) -> Vec<f64> {
        let of_reading = UncertaintyKind::Resolution.standard(self.step(index));
        (0..self.read.lines.len()).map(|row| of_reading / self.swings_of(index, row)).collect()
    }

    /// Standard uncertainties of periods by the common error of all timings.
    pub(super) fn shared_timing(&self, index: usize) -> Option<Vec<f64>> {
        let of_reading = self.wanted[index].counted.filter(|_| self.wanted[index].uncertainties_of.is_none());
        let of_reading = of_reading?.shared_timing()?;
        Some((0..self.read.lines.len()).map(|row| of_reading / self.swings_of(index, row)).collect())
    }

    /// Standard uncertainties of single timings by reaction time and rounding.
    fn by_reaction(&self, index: usize) -> Option<Vec<f64>> {
        let reaction = self.wanted[index].counted?.reaction_time()?;
        let one = |(row, rounding): (usize, f64)| {
            let reaction = reaction / self.swings_of(index, row);
            (reaction * reaction + rounding * rounding).sqrt()
        };
        Some(self.rounding(index).into_iter().enumerate().map(one).collect())
    }

    pub(super) fn column(&self, index: usize, repeated: &[Option<RepeatedReadings>; N]) -> Option<Vec<f64>> {
        match self.wanted[index].uncertainties_of {
            None => self.values(index, repeated[index].as_ref()),
            Some(of) => self.uncertainties(index, of, repeated[of].as_ref()),
        }
    }

    fn values(&self, index: usize, repeated: Option<&RepeatedReadings>) -> Option<Vec<f64>> {
        if self.chosen.columns[index].is_empty() {
            return None;
        }
        if let Some(repeated) = repeated {
            return Some(repeated.rows.iter().map(|row| row.mean).collect());
        }
        let rows = 0..self.read.lines.len();
        let value = |row: usize| {
            let readings = self.readings(index, row);
            let sum: f64 = readings.iter().sum();
            // One reading is exactly itself.
            let mean = if readings.len() == 1 { readings[0] } else { sum / count(readings.len()) };
            mean / self.swings_of(index, row)
        };
        Some(rows.map(value).collect())
    }

    /// Standard uncertainties: from a column, else from repeated readings, else from the cells.
    fn uncertainties(
        &self,
        index: usize,
        of: usize,
        repeated: Option<&RepeatedReadings>,
    ) -> Option<Vec<f64>> {
        let (kind, unit) = (self.chosen.kinds[index], self.units.units[index]);
        let of_cells = self.read.uncertainties[of].as_ref().filter(|_| !self.chosen.columns[of].is_empty());
        let written: Vec<f64> = match (self.chosen.columns[index].is_empty(), repeated, of_cells) {
            (false, None, _) => self.written(index, of, |written| kind.standard(unit.to_si(written))),
            (false, Some(_), _) if kind != UncertaintyKind::Deviation => {
                self.written(index, of, |written| kind.standard(unit.to_si(written)))
            }
            (_, Some(repeated), _) => {
                return Some(repeated.rows.iter().map(|row| row.uncertainty).collect());
            }
            (true, None, Some(cells)) => cells.iter().map(|cell| self.units.units[of].to_si(*cell)).collect(),
            (true, None, None) => match self.stated(of) {
                Some(stated) => stated,
                None => return self.by_reaction(of),
            },
        };
        // u(T) = u(T²)/2T.
        let of_root = |row: usize| match self.chosen.are_squares[of] {
            true => 0.5 / self.readings(of, row)[0],
            false => 1.0,
        };
        let of_one = |(row, spread): (usize, f64)| spread * of_root(row) / self.swings_of(of, row);
        Some(written.into_iter().enumerate().map(of_one).collect())
    }

    /// Uncertainties of a column: relative to the readings, or in the unit of the column.
    fn written(&self, index: usize, of: usize, standard: impl Fn(f64) -> f64) -> Vec<f64> {
        let numbers = self.read.quantities[index].iter().map(|reading| reading[0]).enumerate();
        let one = |(row, number): (usize, f64)| match self.units.fractions[index] {
            Some(fraction) => self.chosen.kinds[index].standard(fraction * number) * self.quantity(of, row),
            None => standard(number),
        };
        numbers.map(one).collect()
    }

    /// Magnitude of a single reading, or its square if the column contains squares.
    fn quantity(&self, index: usize, row: usize) -> f64 {
        let reading = self.readings(index, row)[0].abs();
        if self.chosen.are_squares[index] { reading * reading } else { reading }
    }

    /// Uncertainties that the heading states for all readings.
    fn stated(&self, index: usize) -> Option<Vec<f64>> {
        let stated = self.table.stated_uncertainty(self.chosen.columns[index].first()?).ok()??;
        let unit = stated.unit.unwrap_or(self.units.units[index]);
        let one = |row: usize| match stated.is_relative {
            true => stated.value * self.quantity(index, row),
            false => unit.to_si(stated.value),
        };
        Some((0..self.read.lines.len()).map(one).collect())
    }

    /// Sentences about uncertainties in headings.
    pub(super) fn described_uncertainty(&self, index: usize, repeated: bool) -> Option<String> {
        let of = self.wanted[index].uncertainties_of?;
        let column = self.chosen.columns[of].first()?;
        let name = self.table.describe(column).ok()?;
        self.table.stated_uncertainty(column).ok()??;
        let others = !self.chosen.columns[index].is_empty() || self.read.uncertainties[of].is_some();
        Some(match (repeated, others) {
            (true, _) => {
                format!("{name}: its uncertainty is not used, since the readings have that of their scatter")
            }
            (_, true) => format!("{name}: its uncertainty is not used, since the rows have their own"),
            (false, false) => format!("{name}: its uncertainty is the standard uncertainty of all rows"),
        })
    }

    /// Sentences about repeated readings.
    pub(super) fn described(&self, index: usize, repeated: Option<&RepeatedReadings>) -> Vec<String> {
        let (Some(repeated), Some(quantity)) = (repeated, self.wanted[index].quantity()) else {
            return vec![];
        };
        let unit = self.wanted[index].usual();
        let scatter = number::rounded(repeated.deviation, 2);
        let unlike = repeated.rows.iter().zip(&self.read.lines).filter(|(row, _)| row.is_unlike);
        let unlike: Vec<String> = unlike.map(|(_, line)| line.to_string()).collect();
        let of_unlike = match () {
            () if repeated.differ => {
                "; the rows may scatter differently: they count alike, and the uncertainty is that of the scatter of each row".to_owned()
            }
            () if unlike.is_empty() => String::new(),
            () => format!("; those of line {} scatter more, and count by their own scatter", unlike.join(", ")),
        };
        let with_reaction =
            self.wanted[index].counted.is_some_and(|counted| counted.reaction_time().is_some());
        let reaction = with_reaction.then(|| {
            in_words("the reaction time (<--reaction-time>) is part of the scatter of repeated readings, and is not added")
        });
        let mut said = vec![format!(
            "the readings of the {} scatter by {scatter} {unit} ({} degrees of freedom){of_unlike}",
            quantity.name, repeated.degrees_of_freedom
        )];
        said.extend(reaction);
        if let Some(rounding) = repeated.rounding {
            said.push(format!(
                "the readings of the {} scatter less than their last digit, whose {} {unit} are added",
                quantity.name,
                number::rounded(rounding, 2)
            ));
        }
        for &(row, reading) in &repeated.outliers {
            let value = number::rounded(self.readings(index, row)[reading], 6);
            said.push(format!(
                "line {}: {value} {unit} is far from the other readings of the {}; it is not removed",
                self.read.lines[row], quantity.name
            ));
        }
        said
    }
}

/// A row of `number` readings (a whole number below a million) that are known by their mean and standard deviation.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "checked to be a whole number in range"
)]
fn summary(mean: f64, deviation: f64, number: f64) -> ReadingSummary {
    ReadingSummary { mean, deviation, count: number as usize }
}

#[expect(clippy::cast_precision_loss, reason = "a number of columns")]
fn count(things: usize) -> f64 {
    things as f64
}
