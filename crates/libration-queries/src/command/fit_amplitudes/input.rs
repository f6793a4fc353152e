//! The file of a table of amplitudes: its columns and their units.

use super::columns::{self, Against, Roles};
use crate::arguments::{
    ChosenColumns, ColumnsInSi, ColumnsOption, DialectOptions, DisplacementUnit, Inferences, Wanted, length,
};
use crate::call::in_words;
use crate::figure::amplitudes::MeasuredAmplitudes;
use crate::query_error::{QueryError, option};
use libration_lab::fit::amplitudes::{
    AmplitudeColumns, AmplitudeReading, AmplitudeTable, Position, Sides, UnstatedErrors,
};
use libration_lab::measurement::{Table, Unit};
use std::path::PathBuf;

/// The file, and options for reading it.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct FitAmplitudesInput {
    /// A table of times or numbers of swings and of amplitudes or turning points, optionally with uncertainties; - for standard input
    file: PathBuf,
    #[command(flatten)]
    columns: ColumnsOption,
    /// Quantity of the first column [default: from its header]
    #[arg(long, value_enum)]
    against: Option<Against>,
    /// Unit of the amplitudes and of their uncertainties [default: that of the header, else rad below π]
    #[arg(long, value_enum)]
    amplitude_unit: Option<DisplacementUnit>,
    /// Distance from the pivot to the point that is read: horizontal displacements then give angles
    #[arg(long, value_name = "LENGTH", value_parser = length)]
    length: Option<f64>,
    /// Amplitudes, or turning points of both sides on one scale [default: both sides if rows alternate or have both signs]
    #[arg(long, value_enum)]
    sides: Option<SidesChoice>,
    /// Errors of all amplitudes if no uncertainties are stated: the same absolute error, or the same relative error
    #[arg(long, value_enum, default_value = "absolute")]
    errors: UnstatedAmplitudeErrors,
    #[command(flatten)]
    dialect: DialectOptions,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum SidesChoice {
    One,
    Both,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum UnstatedAmplitudeErrors {
    Absolute,
    Relative,
}

/// The measurements, and the settings with which they were read.
#[derive(Clone, Debug)]
pub(super) struct AmplitudeFile {
    pub(super) measured: MeasuredAmplitudes,
    pub(super) dropped: usize,
    /// Settings inferred from the file.
    pub(super) inferences: Inferences,
}

impl FitAmplitudesInput {
    pub(super) fn read(&self) -> Result<AmplitudeFile, QueryError> {
        let table = self.dialect.read(&self.file)?;
        let roles = match self.columns.are_given() {
            true => None,
            false => Roles::of(&table),
        };
        let given = roles
            .as_ref()
            .map_or_else(|| self.columns.clone(), |roles| self.columns.with_roles(roles.texts()));
        let chosen = given.choose(&self.name(), &table, &self.wanted(), None)?;
        let against = self.against(roles.as_ref(), &table, &chosen)?;
        let read = ColumnsInSi::from_table(&table, &chosen, &self.wanted())
            .map_err(|error| self.no_answer(error))?;
        let read = in_full_swings(read.of_all_groups(), &table, &chosen, against);
        let values = read.columns[1].iter().flatten();
        let largest = values.fold(0.0_f64, |largest, value| largest.max(value.abs()));
        if largest >= std::f64::consts::PI && !read.are_stated[1] {
            let reason = format!(
                "is needed: the amplitudes, up to {largest}, have no unit, and may be degrees or lengths, but not radians"
            );
            return Err(QueryError::usage(option("amplitude-unit"), reason));
        }
        self.checked(against, read.units[1], read.columns, read.dropped, read.inferences)
    }

    /// The measurements of these columns, with the options and units applied.
    fn checked(
        &self,
        against: Against,
        unit: Unit,
        columns: [Option<Vec<f64>>; 6],
        dropped: usize,
        mut inferences: Inferences,
    ) -> Result<AmplitudeFile, QueryError> {
        let unit = match unit {
            Unit::Count | Unit::Pixel => "counts",
            unit if unit.measures_as(Unit::Metre) => "m",
            _ => "rad",
        };
        let [positions, values, of_positions, of_values, numbers, periods] = columns;
        let (positions, values) = (positions.unwrap_or_default(), values.unwrap_or_default());
        let columns = AmplitudeColumns {
            position_uncertainties: of_positions.as_deref(),
            value_uncertainties: of_values.as_deref(),
            swing_numbers: numbers.as_deref().filter(|_| against == Against::Time),
            periods: periods.as_deref(),
            sides: self.sides.map(|sides| match sides {
                SidesChoice::One => Sides::One,
                SidesChoice::Both => Sides::Both,
            }),
            unstated_errors: match self.errors {
                UnstatedAmplitudeErrors::Absolute => UnstatedErrors::Absolute,
                UnstatedAmplitudeErrors::Relative => UnstatedErrors::Relative,
            },
            ..AmplitudeColumns::new(against.position(), &positions, self.reading(unit)?, &values)
        };
        let table = AmplitudeTable::new(&columns).map_err(|error| self.no_answer(error))?;
        if self.sides.is_none() && table.sides() == Sides::Both {
            inferences
                .sentences
                .push(in_words("the rows are turning points of both sides (<--sides=one> for amplitudes)"));
        }
        if table.counts_half_swings() {
            inferences.sentences.push(
                "the numbers are those of half swings, as opposite turning points are whole numbers apart"
                    .to_owned(),
            );
        }
        let measured =
            MeasuredAmplitudes { unit: self.unit_of_law(unit), is_horizontal: self.length.is_some(), table };
        Ok(AmplitudeFile { measured, dropped, inferences })
    }

    fn wanted(&self) -> [Wanted; 6] {
        let positions = Wanted::times(columns::POSITION);
        let amplitudes = Wanted::displacements(self.amplitude_unit);
        let of_both = [positions.uncertainties(0), amplitudes.uncertainties(1)];
        let further =
            [columns::SWING_NUMBER, columns::PERIOD].map(|name| Wanted::times(name).only_named(&[]));
        [positions, amplitudes, of_both[0], of_both[1], further[0], further[1]]
    }

    /// The quantity of the first column: from the option, else from its header.
    fn against(
        &self,
        roles: Option<&Roles>,
        table: &Table,
        chosen: &ChosenColumns<6>,
    ) -> Result<Against, QueryError> {
        if let Some(against) = self.against {
            return Ok(against);
        }
        let named = match roles {
            Some(roles) => Some(roles.against()),
            None => chosen.column(0).and_then(|column| columns::against(table, column)),
        };
        named.ok_or_else(|| {
            self.no_answer("the header does not say whether the first column holds times or numbers of swings: give <--against=time> or <--against=swings>")
        })
    }

    fn reading(&self, unit: &str) -> Result<AmplitudeReading, QueryError> {
        match (self.length, unit) {
            (Some(length), "m") => Ok(AmplitudeReading::Horizontal { length }),
            (Some(_), _) => Err(QueryError::usage(
                option("length"),
                format!(
                    "it turns displacements into angles, and the amplitudes are in {unit}: leave it out, or give <--amplitude-unit=m>"
                ),
            )),
            (None, "rad") => Ok(AmplitudeReading::Angle),
            (None, _) => Ok(AmplitudeReading::Displacement),
        }
    }

    /// The unit of the fitted amplitudes.
    fn unit_of_law(&self, unit: &'static str) -> &'static str {
        if self.length.is_some() { "rad" } else { unit }
    }

    pub(super) fn name(&self) -> String {
        self.file.display().to_string()
    }

    pub(super) fn no_answer(&self, reason: impl std::fmt::Display) -> QueryError {
        QueryError::no_result(&self.name(), reason)
    }
}

/// The columns with full swings in place of half swings where headings name these.
fn in_full_swings(
    mut read: ColumnsInSi<6>,
    table: &Table,
    chosen: &ChosenColumns<6>,
    against: Against,
) -> ColumnsInSi<6> {
    let columns = if against == Against::Swings { &[0, 2, 4][..] } else { &[4] };
    for &index in columns {
        // Uncertainties of numbers of swings have the unit of these.
        let Some(column) = chosen.column(if index == 2 { 0 } else { index }) else { continue };
        if !columns::are_half_swings(table, column) {
            continue;
        }
        read.columns[index].iter_mut().flatten().for_each(|number| *number *= 0.5);
        if let Ok(column) = table.describe(column)
            && index != 2
        {
            read.inferences.sentences.push(format!("{column} holds numbers of half swings"));
        }
    }
    read
}

impl Against {
    fn position(self) -> Position {
        match self {
            Self::Time => Position::Time,
            Self::Swings => Position::Swings,
        }
    }
}
