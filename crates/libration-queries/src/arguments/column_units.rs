//! The units of chosen columns: said by an option, else written in the header, else those of the SI.

use super::{ChosenColumns, CountedOptions};
use libration_lab::measurement::{Column, MeasurementError, Role, Table, Unit, WrittenUnit};

/// The quantity expected in a column, and the options given for it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wanted {
    role: Role,
    /// The option of the unit, and the unit where it is said.
    option: Option<(&'static str, Option<Unit>)>,
    /// Index of the column of which these are the uncertainties.
    uncertainties_of: Option<usize>,
    /// Options for times that may last several periods.
    counted: Option<CountedOptions>,
}

/// The units of the columns, and what was inferred from the header.
#[derive(Clone, Debug)]
struct ColumnUnits<const N: usize> {
    units: [Unit; N],
    /// Number of periods that each time lasts; one for columns that do not hold times.
    counts: [f64; N],
    inferences: Vec<String>,
}

/// The numbers of chosen columns in units of the SI, in the rows that have them all.
#[derive(Clone, Debug)]
pub(crate) struct ColumnsInSi<const N: usize> {
    pub(crate) columns: [Option<Vec<f64>>; N],
    /// The line each row came from, counted from one.
    pub(crate) lines: Vec<u64>,
    /// Number of incomplete rows.
    pub(crate) dropped: usize,
    /// Number of periods that the times of each column lasted.
    pub(crate) counts: [f64; N],
    /// Settings inferred from the header.
    pub(crate) inferences: Vec<String>,
    /// Units in which the columns were read.
    pub(crate) units: [Unit; N],
}

impl<const N: usize> ColumnsInSi<N> {
    /// The chosen columns of a table, or why they are not what is wanted.
    pub(crate) fn from_table(
        table: &Table,
        chosen: &ChosenColumns<N>,
        wanted: &[Wanted; N],
    ) -> Result<Self, String> {
        let ChosenColumns { columns: chosen, note, is_said } = chosen;
        let asked: Vec<Column> = chosen.iter().flatten().cloned().collect();
        let selection = table.select(&asked).map_err(|error| error.to_string())?;
        let units = ColumnUnits::from_headings(table, chosen, wanted, *is_said)?;
        let columns = units.in_si(selection.columns, chosen);
        let sheet = table.chosen_sheet().map(|name| format!("sheet `{name}` is read"));
        Ok(Self {
            columns,
            lines: selection.lines,
            dropped: selection.dropped,
            counts: units.counts,
            inferences: sheet.into_iter().chain(units.inferences).chain(note.clone()).collect(),
            units: units.units,
        })
    }
}

impl Wanted {
    /// Periods, from times that may last several of them.
    pub(crate) fn periods(counted: CountedOptions) -> Self {
        Self { role: Role::Times, option: None, uncertainties_of: None, counted: Some(counted) }
    }

    /// Times, or numbers without a unit.
    pub(crate) fn times() -> Self {
        Self { role: Role::Times, option: None, uncertainties_of: None, counted: None }
    }

    pub(crate) fn lengths(said: Option<impl Into<Unit>>) -> Self {
        let option = Some(("--length-unit", said.map(Into::into)));
        Self { role: Role::Lengths, option, uncertainties_of: None, counted: None }
    }

    pub(crate) fn amplitudes(said: Option<impl Into<Unit>>) -> Self {
        let option = Some(("--amplitude-unit", said.map(Into::into)));
        Self { role: Role::Angles, option, uncertainties_of: None, counted: None }
    }

    pub(crate) fn frequencies(said: Option<impl Into<Unit>>) -> Self {
        let option = Some(("--frequency-unit", said.map(Into::into)));
        Self { role: Role::Frequencies, option, uncertainties_of: None, counted: None }
    }

    pub(crate) fn displacements(said: Option<impl Into<Unit>>) -> Self {
        let option = Some(("--amplitude-unit", said.map(Into::into)));
        Self { role: Role::Displacements, option, uncertainties_of: None, counted: None }
    }

    pub(crate) fn phases(said: Option<impl Into<Unit>>) -> Self {
        let option = Some(("--phase-unit", said.map(Into::into)));
        Self { role: Role::Angles, option, uncertainties_of: None, counted: None }
    }

    /// The uncertainties of what the column at this place holds.
    pub(crate) fn uncertainties(self, of: usize) -> Self {
        Self { uncertainties_of: Some(of), ..self }
    }

    fn usual(self) -> Unit {
        match self.role {
            Role::Times => Unit::Second,
            Role::Lengths => Unit::Metre,
            Role::Angles | Role::Displacements => Unit::Radian,
            Role::Frequencies => Unit::RadianPerSecond,
        }
    }

    fn written(self, table: &Table, column: &Column, is_said: bool) -> Result<WrittenUnit, MeasurementError> {
        match self.uncertainties_of {
            _ if is_said => table.unit_of_chosen(column, self.role),
            Some(_) => table.unit_of_uncertainty(column, self.role),
            None => table.unit(column, self.role),
        }
    }

    /// The unit of a column, with a sentence where the header says one.
    fn unit(
        self,
        table: &Table,
        column: &Column,
        usual: Unit,
        is_said: bool,
    ) -> Result<(Unit, Option<String>), String> {
        let written = self.written(table, column, is_said).map_err(refusal)?;
        let place = table.describe(column).map_err(refusal)?;
        let said = self.option.and_then(|(option, said)| Some((option, said?)));
        Ok(match (said, written) {
            (Some((option, unit)), WrittenUnit::Known(other)) if unit != other => (
                unit,
                Some(format!("{place} is read in {unit} ({option}), not in {other} as its header says")),
            ),
            (Some((_, unit)), _) => (unit, None),
            (None, WrittenUnit::Known(unit)) => (unit, Some(format!("{place} is in {unit}"))),
            (None, WrittenUnit::Nothing)
                if self.role == Role::Frequencies && self.uncertainties_of.is_none() =>
            {
                return Err(format!(
                    "{place} has no unit, and frequencies are in Hz as often as in rad/s: give it by <--frequency-unit>"
                ));
            }
            (None, WrittenUnit::Nothing) => (usual, None),
            (None, WrittenUnit::Unknown(text)) => match self.option {
                Some((option, _)) if self.uncertainties_of.is_none() => {
                    return Err(format!(
                        "{place}: `{text}` is not a known unit of {}: give it by <{option}>",
                        self.role
                    ));
                }
                None if self.uncertainties_of.is_none() && text.contains(['^', '²', '/']) => {
                    return Err(format!(
                        "{place}: `{text}` is not a unit of {}: give a column of periods themselves, in s, ms, us or min",
                        self.role
                    ));
                }
                _ => (usual, Some(format!("{place} is taken in {usual}: `{text}` is not a known unit"))),
            },
        })
    }
}

impl<const N: usize> ColumnUnits<N> {
    /// The units of the columns that are chosen; uncertainties without a unit have that of their values.
    fn from_headings(
        table: &Table,
        columns: &[Option<Column>; N],
        wanted: &[Wanted; N],
        is_said: bool,
    ) -> Result<Self, String> {
        let (mut units, mut counts, mut inferences) = (wanted.map(Wanted::usual), [1.0; N], Vec::new());
        for (place, (column, wanted)) in columns.iter().zip(wanted).enumerate() {
            let Some(column) = column else { continue };
            let usual = wanted.uncertainties_of.map_or(units[place], |of| units[of]);
            let (unit, sentence) = wanted.unit(table, column, usual, is_said)?;
            units[place] = unit;
            inferences.extend(sentence);
            if let Some(counted) = wanted.counted {
                let usual = wanted.uncertainties_of.map_or(1.0, |of| counts[of]);
                let (count, sentence) = counted.count(table, column, usual)?;
                counts[place] = count;
                inferences.extend(sentence);
            }
        }
        Ok(Self { units, counts, inferences })
    }

    /// The numbers of the columns in units of the SI, times as those of one period.
    fn in_si(&self, columns: Vec<Vec<f64>>, chosen: &[Option<Column>; N]) -> [Option<Vec<f64>>; N] {
        let mut columns = columns.into_iter();
        std::array::from_fn(|place| {
            let numbers = chosen[place].as_ref().and_then(|_| columns.next())?;
            let (unit, count) = (self.units[place], self.counts[place]);
            Some(numbers.into_iter().map(|number| unit.to_si(number) / count).collect())
        })
    }
}

fn refusal(error: MeasurementError) -> String {
    match error {
        MeasurementError::HoldsOther { .. } => format!("{error} (<--columns>)"),
        _ => error.to_string(),
    }
}
