//! The columns of a table in units of the SI, with repeated readings as means.

use super::wanted::refusal;
use super::{ChosenColumns, ColumnsOption, CountedOptions, Inferences, TableFit, Wanted};
use crate::call::in_words;
use crate::output::number;
use crate::query_error::QueryError;
use libration_lab::fit::{ReadingSummary, RepeatedReadings, swings_of_numbered_time};
use libration_lab::measurement::{
    Column, Readings, RepeatedRows, Role, Table, UncertaintyKind, Unit, is_number_of_swings,
};

/// The units of the columns, and what was inferred from the header.
#[derive(Clone, Debug)]
struct ColumnUnits<const N: usize> {
    units: [Unit; N],
    /// Number of periods that each time lasts; one for columns that do not hold times.
    counts: [f64; N],
    /// `true` where a header states the unit.
    are_stated: [bool; N],
    /// The fraction of the values that one stands for in columns of relative uncertainties.
    fractions: [Option<f64>; N],
    inferences: Vec<String>,
}

/// The numbers of chosen columns in units of the SI, in the rows that have them all.
#[derive(Clone, Debug)]
pub(crate) struct ColumnsInSi<const N: usize> {
    /// Values, or means of repeated readings, and standard uncertainties.
    pub(crate) columns: [Option<Vec<f64>>; N],
    /// Repeated readings of the values.
    pub(crate) repeated: [Option<RepeatedReadings>; N],
    /// Standard uncertainties of single values by the rounding to their last digit, row by row.
    pub(crate) rounding: [Vec<f64>; N],
    /// The line each row came from, counted from one.
    pub(crate) lines: Vec<u64>,
    /// Number of incomplete rows.
    pub(crate) dropped: usize,
    /// Standard uncertainties of periods by what all timings share, row by row.
    pub(crate) shared_timing: Option<Vec<f64>>,
    /// Number of periods that the times of each column lasted, where no column numbers them.
    pub(crate) counts: [f64; N],
    /// Names of the groups of the rows.
    pub(crate) groups: Option<Vec<String>>,
    /// Settings inferred from the file.
    pub(crate) inferences: Inferences,
    /// Units in which the columns were read.
    pub(crate) units: [Unit; N],
    /// `true` where the header or an option states the unit.
    pub(crate) are_stated: [bool; N],
}

impl ColumnsOption {
    /// The chosen columns in units of the SI. A refusal names the fit that the headings are for, where that is another than `command`.
    pub(crate) fn read<const N: usize>(
        &self,
        file: &str,
        table: &Table,
        wanted: &[Wanted; N],
        group: Option<&Column>,
        command: &str,
    ) -> Result<ColumnsInSi<N>, QueryError> {
        let read = self.choose(file, table, wanted, group).and_then(|chosen| {
            ColumnsInSi::from_table(table, &chosen, wanted)
                .map_err(|error| QueryError::no_result(file, error))
        });
        read.map_err(|error| match TableFit::of(table).filter(|fit| fit.command != command) {
            Some(fit) => error.with_hint(&format!("the columns are those of <libration {}>", fit.command)),
            None => error,
        })
    }
}

impl<const N: usize> ColumnsInSi<N> {
    /// The chosen columns of a table, or why they are not what is wanted.
    pub(crate) fn from_table(
        table: &Table,
        chosen: &ChosenColumns<N>,
        wanted: &[Wanted; N],
    ) -> Result<Self, String> {
        let asked: Vec<Vec<Column>> = chosen
            .columns
            .iter()
            .cloned()
            .chain(
                [&chosen.column_of_swings, &chosen.column_of_readings].map(|it| it.iter().cloned().collect()),
            )
            .collect();
        let read = table.readings(&asked).map_err(|error| error.to_string())?;
        let labels = |read: &Readings| {
            let labels = chosen.column_of_groups.as_ref().map(|column| table.labels(column, &read.rows));
            labels.transpose().map_err(|error| error.to_string())
        };
        let names = labels(&read)?;
        let (read, repeated_rows) = read.once(names.as_deref());
        let units = ColumnUnits::from_headings(table, chosen, wanted, &read)?;
        let numbers = |place: usize, column: &Option<Column>| -> Option<Vec<f64>> {
            column.as_ref().map(|_| read.quantities[place].iter().map(|it| it[0]).collect())
        };
        let swings = numbers(N, &chosen.column_of_swings);
        let numbers_of_readings = numbers(N + 1, &chosen.column_of_readings);
        let rows = SiRows { table, chosen, wanted, units: &units, read: &read, swings, numbers_of_readings };
        let rows = rows.checked()?;
        let repeated: [Option<RepeatedReadings>; N] = std::array::from_fn(|place| rows.repeated(place));
        let groups = labels(&read)?;
        let sheet = table.chosen_sheet().map(|name| format!("sheet `{name}` is read"));
        let of_readings = (0..N).flat_map(|place| rows.described(place, repeated[place].as_ref()));
        let is_repeated =
            |place: usize| wanted[place].uncertainties_of.is_some_and(|of| repeated[of].is_some());
        let of_headings = (0..N).filter_map(|place| rows.described_uncertainty(place, is_repeated(place)));
        let sentences = sheet
            .into_iter()
            .chain(table.notes())
            .chain(repeated_rows.iter().map(repeats))
            .chain(chosen.notes.iter().cloned())
            .chain(units.inferences.iter().cloned())
            .chain(of_headings)
            .chain(of_readings)
            .collect();
        let stated = std::array::from_fn(|place| (units.units[place], units.are_stated[place]));
        let counts = chosen.column_of_swings.is_none().then_some(units.counts);
        let read_columns = chosen.roles.iter().map(|it| it.with_units(wanted, stated, counts)).collect();
        Ok(Self {
            columns: std::array::from_fn(|place| rows.column(place, &repeated)),
            rounding: std::array::from_fn(|place| rows.rounding(place)),
            shared_timing: (0..N).find_map(|place| rows.shared_timing(place)),
            groups,
            lines: read.lines.clone(),
            dropped: read.dropped,
            counts: units.counts,
            units: units.units,
            are_stated: std::array::from_fn(|place| units.are_stated[place] || wanted[place].states_unit()),
            repeated,
            inferences: Inferences { sentences, columns: read_columns },
        })
    }
}

/// The rows of a table on their way to the SI.
struct SiRows<'a, const N: usize> {
    table: &'a Table,
    chosen: &'a ChosenColumns<N>,
    wanted: &'a [Wanted; N],
    units: &'a ColumnUnits<N>,
    read: &'a Readings,
    /// The number of swings of each row, by a column.
    swings: Option<Vec<f64>>,
    /// The number of readings of each row, by a column.
    numbers_of_readings: Option<Vec<f64>>,
}

impl<const N: usize> SiRows<'_, N> {
    /// The same rows, whose numbers of swings are usable.
    fn checked(self) -> Result<Self, String> {
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
        let are_deviations = |place: &usize| self.chosen.kinds[*place] == UncertaintyKind::Deviation;
        let columns =
            (0..N).filter(are_deviations).filter(|place| self.wanted[*place].uncertainties_of.is_some());
        let negative =
            |of: usize| self.read.quantities[of].iter().position(|it| it.iter().any(|&it| it < 0.0));
        columns.filter_map(negative).min()
    }

    /// Number of periods that a time lasts; one for what is not a time.
    fn swings_of(&self, place: usize, row: usize) -> f64 {
        match &self.swings {
            Some(swings) if self.wanted[place].counted.is_some_and(|it| it.said().is_none()) => swings[row],
            _ => self.units.counts[place],
        }
    }

    /// The readings of a row in the SI, not divided by the number of periods.
    fn readings(&self, place: usize, row: usize) -> Vec<f64> {
        let in_si = |number: &f64| {
            let value = self.units.units[place].to_si(*number);
            // A square of times is as often of seconds as the unit of the times is.
            if self.chosen.are_squares[place] { number.sqrt() } else { value }
        };
        self.read.quantities[place][row].iter().map(in_si).collect()
    }

    /// The last digit of the readings, in the SI.
    fn step(&self, place: usize) -> f64 {
        let steps = self.chosen.columns[place].iter().map(|column| self.table.step(column).unwrap_or(0.0));
        let step = self.units.units[place].to_si(steps.fold(0.0, f64::max));
        if self.chosen.are_squares[place] { 0.0 } else { step }
    }

    /// Repeated readings of values, as those of one period.
    fn repeated(&self, place: usize) -> Option<RepeatedReadings> {
        if self.wanted[place].uncertainties_of.is_some() {
            return None;
        }
        let rows = 0..self.read.lines.len();
        let readings: Vec<Vec<f64>> = rows.map(|row| self.readings(place, row)).collect();
        let mut found = match self.summaries(place, &readings) {
            Some(summaries) => RepeatedReadings::of_summaries(&summaries, self.step(place))?,
            None if self.chosen.columns[place].len() > 1 => {
                RepeatedReadings::new(&readings, self.step(place))?
            }
            None => return None,
        };
        for (row, mean) in found.rows.iter_mut().enumerate() {
            *mean = mean.times(1.0 / self.swings_of(place, row));
        }
        Some(found)
    }

    /// Means, standard deviations and numbers of readings, where columns hold them.
    fn summaries(&self, place: usize, means: &[Vec<f64>]) -> Option<Vec<ReadingSummary>> {
        let numbers = self.numbers_of_readings.as_ref()?;
        let is_deviation = |of: &usize| {
            self.wanted[*of].uncertainties_of == Some(place)
                && self.chosen.kinds[*of] == UncertaintyKind::Deviation
                && !self.chosen.columns[*of].is_empty()
        };
        let column = (0..N).find(is_deviation)?;
        let deviations = self.written(column, place, |written| self.units.units[column].to_si(written));
        let rows = means.iter().zip(deviations).zip(numbers);
        Some(rows.map(|((mean, deviation), number)| summary(mean[0], deviation, *number)).collect())
    }

    /// Standard uncertainties by rounding.
    fn rounding(&self, place: usize) -> Vec<f64> {
        let of_reading = UncertaintyKind::Resolution.standard(self.step(place));
        (0..self.read.lines.len()).map(|row| of_reading / self.swings_of(place, row)).collect()
    }

    /// Standard uncertainties of periods by what all timings share.
    fn shared_timing(&self, place: usize) -> Option<Vec<f64>> {
        let of_reading = self.wanted[place].counted.filter(|_| self.wanted[place].uncertainties_of.is_none());
        let of_reading = of_reading?.shared_timing()?;
        Some((0..self.read.lines.len()).map(|row| of_reading / self.swings_of(place, row)).collect())
    }

    /// Standard uncertainties of single timings by reaction time and rounding.
    fn by_reaction(&self, place: usize) -> Option<Vec<f64>> {
        let reaction = self.wanted[place].counted?.reaction_time()?;
        let one = |(row, rounding): (usize, f64)| {
            let reaction = reaction / self.swings_of(place, row);
            (reaction * reaction + rounding * rounding).sqrt()
        };
        Some(self.rounding(place).into_iter().enumerate().map(one).collect())
    }

    fn column(&self, place: usize, repeated: &[Option<RepeatedReadings>; N]) -> Option<Vec<f64>> {
        match self.wanted[place].uncertainties_of {
            None => self.values(place, repeated[place].as_ref()),
            Some(of) => self.uncertainties(place, of, repeated[of].as_ref()),
        }
    }

    fn values(&self, place: usize, repeated: Option<&RepeatedReadings>) -> Option<Vec<f64>> {
        if self.chosen.columns[place].is_empty() {
            return None;
        }
        if let Some(repeated) = repeated {
            return Some(repeated.rows.iter().map(|row| row.mean).collect());
        }
        let rows = 0..self.read.lines.len();
        let value = |row: usize| {
            let readings = self.readings(place, row);
            let sum: f64 = readings.iter().sum();
            // One reading is exactly itself.
            let mean = if readings.len() == 1 { readings[0] } else { sum / count(readings.len()) };
            mean / self.swings_of(place, row)
        };
        Some(rows.map(value).collect())
    }

    /// Standard uncertainties: of a column, else of repeated readings, else those of the cells.
    fn uncertainties(
        &self,
        place: usize,
        of: usize,
        repeated: Option<&RepeatedReadings>,
    ) -> Option<Vec<f64>> {
        let (kind, unit) = (self.chosen.kinds[place], self.units.units[place]);
        let own = self.read.uncertainties[of].as_ref().filter(|_| !self.chosen.columns[of].is_empty());
        let written: Vec<f64> = match (self.chosen.columns[place].is_empty(), repeated, own) {
            (false, None, _) => self.written(place, of, |written| kind.standard(unit.to_si(written))),
            (false, Some(_), _) if kind != UncertaintyKind::Deviation => {
                self.written(place, of, |written| kind.standard(unit.to_si(written)))
            }
            (_, Some(repeated), _) => {
                return Some(repeated.rows.iter().map(|row| row.uncertainty).collect());
            }
            (true, None, Some(own)) => own.iter().map(|it| self.units.units[of].to_si(*it)).collect(),
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
    fn written(&self, place: usize, of: usize, standard: impl Fn(f64) -> f64) -> Vec<f64> {
        let numbers = self.read.quantities[place].iter().map(|it| it[0]).enumerate();
        let one = |(row, number): (usize, f64)| match self.units.fractions[place] {
            Some(fraction) => self.chosen.kinds[place].standard(fraction * number) * self.quantity(of, row),
            None => standard(number),
        };
        numbers.map(one).collect()
    }

    /// Size of a single reading, or its square where that is what the column holds.
    fn quantity(&self, place: usize, row: usize) -> f64 {
        let reading = self.readings(place, row)[0].abs();
        if self.chosen.are_squares[place] { reading * reading } else { reading }
    }

    /// Uncertainties that the heading states for all readings.
    fn stated(&self, place: usize) -> Option<Vec<f64>> {
        let stated = self.table.stated_uncertainty(self.chosen.columns[place].first()?).ok()??;
        let unit = stated.unit.unwrap_or(self.units.units[place]);
        let one = |row: usize| match stated.is_relative {
            true => stated.value * self.quantity(place, row),
            false => unit.to_si(stated.value),
        };
        Some((0..self.read.lines.len()).map(one).collect())
    }

    /// Sentences about uncertainties in headings.
    fn described_uncertainty(&self, place: usize, repeated: bool) -> Option<String> {
        let of = self.wanted[place].uncertainties_of?;
        let column = self.chosen.columns[of].first()?;
        let name = self.table.describe(column).ok()?;
        self.table.stated_uncertainty(column).ok()??;
        let others = !self.chosen.columns[place].is_empty() || self.read.uncertainties[of].is_some();
        Some(match (repeated, others) {
            (true, _) => {
                format!("{name}: its uncertainty is not used, since the readings have that of their scatter")
            }
            (_, true) => format!("{name}: its uncertainty is not used, since the rows have their own"),
            (false, false) => format!("{name}: its uncertainty is the standard uncertainty of all rows"),
        })
    }

    /// Sentences about repeated readings.
    fn described(&self, place: usize, repeated: Option<&RepeatedReadings>) -> Vec<String> {
        let (Some(repeated), Some(quantity)) = (repeated, self.wanted[place].quantity()) else {
            return vec![];
        };
        let unit = self.wanted[place].usual();
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
        let with_reaction = self.wanted[place].counted.is_some_and(|it| it.reaction_time().is_some());
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
            let value = number::rounded(self.readings(place, row)[reading], 6);
            said.push(format!(
                "line {}: {value} {unit} is far from the other readings of the {}; it is not removed",
                self.read.lines[row], quantity.name
            ));
        }
        said
    }
}

/// A row of readings of which `number`, a whole number below a million, are known by their mean and standard deviation.
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

impl<const N: usize> ColumnUnits<N> {
    /// The units of the columns that are chosen; uncertainties without a unit have that of their values.
    fn from_headings(
        table: &Table,
        chosen: &ChosenColumns<N>,
        wanted: &[Wanted; N],
        read: &Readings,
    ) -> Result<Self, String> {
        let (mut units, mut counts, mut inferences) = (wanted.map(Wanted::usual), [1.0; N], Vec::new());
        let (mut are_stated, mut fractions, all) = ([false; N], [None; N], wanted);
        for (place, (columns, wanted)) in chosen.columns.iter().zip(wanted).enumerate() {
            let usual = wanted.uncertainties_of.map_or(units[place], |of| units[of]);
            for (number, column) in columns.iter().enumerate() {
                if chosen.are_squares[place] {
                    continue;
                }
                fractions[place] = wanted.fraction(table, column)?;
                let (unit, of_unit) = match fractions[place] {
                    Some(fraction) => (usual, Some(parts(table, column, fraction)?)),
                    None => wanted.unit(table, column, usual, chosen.is_said)?,
                };
                let by_quotient = chosen.swings[place].unwrap_or(1.0);
                let usual = wanted.uncertainties_of.map_or(by_quotient, |of| counts[of]);
                // Numbers of swings in a column win over the header.
                let is_open =
                    |counted: &CountedOptions| chosen.column_of_swings.is_none() || counted.said().is_some();
                let counted = wanted.counted.filter(is_open);
                let by_lengths = |number: f64| {
                    // `T2` without a unit may be a square.
                    let may_be_square = number < 3.0 && of_unit.is_none();
                    let lengths = lengths(all, read, &units, &are_stated).filter(|_| !may_be_square)?;
                    let times = read.quantities[place].iter().map(|it| unit.to_si(it[0]));
                    swings_of_numbered_time(number, &lengths.into_iter().zip(times).collect::<Vec<_>>())
                };
                let counted =
                    counted.map(|counted| counted.count(table, column, usual, by_lengths)).transpose()?;
                let (count, of_count) = counted.unwrap_or((1.0, None));
                let is_as_before = unit == units[place] && count.total_cmp(&counts[place]).is_eq();
                if number > 0 && !is_as_before {
                    let column = table.describe(column).map_err(refusal)?;
                    return Err(format!(
                        "{column} has another unit or number of swings than the other readings: use <--columns> or <--role>"
                    ));
                }
                (units[place], counts[place]) = (unit, count);
                if number == 0 {
                    are_stated[place] = of_unit.is_some() && fractions[place].is_none();
                    inferences.extend(of_unit.into_iter().chain(of_count).map(|it| in_words(&it)));
                }
            }
        }
        Ok(Self { units, counts, are_stated, fractions, inferences })
    }
}

/// The lengths of the rows in metres, where a table has them: with a stated unit, or so short that they may be metres.
fn lengths<const N: usize>(
    wanted: &[Wanted; N],
    read: &Readings,
    units: &[Unit; N],
    are_stated: &[bool; N],
) -> Option<Vec<f64>> {
    /// Longest pendulum of a table without a unit of its lengths, in metres: shorter than those of most tables in centimetres.
    const LONGEST: f64 = 5.0;
    let is_length = |it: &Wanted| it.role == Role::Lengths && it.uncertainties_of.is_none();
    let place = wanted.iter().position(is_length)?;
    let first = |readings: &Vec<f64>| Some(units[place].to_si(*readings.first()?));
    let lengths: Option<Vec<f64>> = read.quantities[place].iter().map(first).collect();
    let is_stated = are_stated[place] || wanted[place].states_unit();
    lengths.filter(|lengths| is_stated || lengths.iter().all(|length| *length < LONGEST))
}

/// A sentence about rows that repeat others.
fn repeats(rows: &RepeatedRows) -> String {
    match rows {
        RepeatedRows::Passage { lines: [first, last], of: [first_of, last_of] } => {
            format!(
                "lines {first} to {last} repeat lines {first_of} to {last_of}, number by number: they count once"
            )
        }
        RepeatedRows::Each(times) => format!("each row stands in {times} lines: it counts once"),
    }
}

/// A sentence about a column of relative uncertainties.
fn parts(table: &Table, column: &Column, fraction: f64) -> Result<String, String> {
    let place = table.describe(column).map_err(refusal)?;
    let of_what = if fraction < 1e-2 { format!("{fraction} of") } else { "per cent of".to_owned() };
    Ok(format!("{place} is in {of_what} the values"))
}
