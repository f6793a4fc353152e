//! The file of a response: its columns and their units.

use crate::arguments::{
    AmplitudeUnit, ColumnsInSi, ColumnsOption, CountedOptions, DialectOptions, DisplacementUnit,
    FrequencyUnit, Inferences, Wanted,
};
use crate::figure::fitted_response::MeasuredResponse;
use crate::query_error::QueryError;
use libration_lab::fit::response::{AmplitudeErrors, ResponseColumns, ResponseTable};
use libration_lab::measurement::{Column, CountedPeriods, QuantityColumns, Role, Table, TableQuantity, Unit};
use std::f64::consts::TAU;
use std::path::PathBuf;

/// The file, and options for reading it.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct FitResponseInput {
    /// A table of drive frequencies, or periods, and amplitudes, optionally with phases and with uncertainties; - for standard input
    file: PathBuf,
    #[command(flatten)]
    columns: ColumnsOption,
    /// Unit of the frequencies and of their uncertainties [default: that of the header]
    #[arg(long, value_enum)]
    frequency_unit: Option<FrequencyUnit>,
    /// Unit of the amplitudes and of their uncertainties [default: that of the header, else rad]
    #[arg(long, value_enum)]
    amplitude_unit: Option<DisplacementUnit>,
    /// Unit of the phases and of their uncertainties [default: that of the header, else rad]
    #[arg(long, value_enum)]
    phase_unit: Option<AmplitudeUnit>,
    /// Errors of all amplitudes if no uncertainties are stated: the same absolute error, or the same relative error
    #[arg(long, value_enum, default_value = "absolute")]
    errors: ResponseErrors,
    #[command(flatten)]
    dialect: DialectOptions,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum ResponseErrors {
    Absolute,
    Relative,
}

/// The measurements, and the settings with which they were read.
#[derive(Clone, Debug)]
pub(super) struct ResponseFile {
    pub(super) measured: MeasuredResponse,
    pub(super) dropped: usize,
    /// The units stated in the header.
    pub(super) inferences: Inferences,
    pub(super) unit: &'static str,
}

impl ResponseFile {
    pub(super) fn is_angle(&self) -> bool {
        self.unit == "rad"
    }
}

impl FitResponseInput {
    pub(super) fn read(&self) -> Result<ResponseFile, QueryError> {
        let table = self.dialect.read(&self.file)?;
        let has_periods = self.has_periods(&table);
        let wanted = self.wanted(has_periods);
        let read = self.columns.read(&self.name(), &table, &wanted, None, "fit response")?.of_all_groups();
        let read = if has_periods { of_periods(read) } else { read };
        let unit = match read.units[1] {
            Unit::Count | Unit::Pixel => "counts",
            unit if unit.measures_as(Unit::Metre) => "m",
            _ => "rad",
        };
        let [frequencies, amplitudes, of_frequencies, of_amplitudes, phases, of_phases] = read.columns;
        let (frequencies, amplitudes) = (frequencies.unwrap_or_default(), amplitudes.unwrap_or_default());
        let columns = ResponseColumns {
            frequencies: &frequencies,
            amplitudes: &amplitudes,
            phases: phases.as_deref(),
            frequency_uncertainties: of_frequencies.as_deref(),
            amplitude_uncertainties: of_amplitudes.as_deref(),
            phase_uncertainties: of_phases.as_deref(),
            unstated_errors: match self.errors {
                ResponseErrors::Absolute => AmplitudeErrors::Absolute,
                ResponseErrors::Relative => AmplitudeErrors::Relative,
            },
        };
        let table = ResponseTable::new(&columns).map_err(|error| self.no_answer(error))?;
        let measured = MeasuredResponse {
            frequencies,
            amplitudes,
            phases,
            frequency_uncertainties: of_frequencies,
            amplitude_uncertainties: of_amplitudes,
            phase_uncertainties: of_phases,
            is_angle: unit == "rad",
            unit,
            table,
        };
        Ok(ResponseFile { measured, dropped: read.dropped, inferences: read.inferences, unit })
    }

    /// Returns `true` if the table has periods of the drive and no frequencies: by the heading of the first of the given columns, or of any column.
    fn has_periods(&self, table: &Table) -> bool {
        let names = |role: Role, column: &Column| {
            let quantity = TableQuantity { name: "", role, only_named: None };
            let columns = QuantityColumns { readings: vec![column.clone()], ..QuantityColumns::default() };
            table.heads(&quantity, &columns)
        };
        let names_periods = |column: &Column| {
            let heading = table.describe(column).unwrap_or_default().to_lowercase();
            let is_counted = matches!(table.counted_periods(column), Ok(CountedPeriods::Said(_)));
            names(Role::Times, column)
                && (is_counted || ["period", "périod", "períod"].iter().any(|word| heading.contains(word)))
        };
        let columns = || (1..=table.width()).map(Column::Number);
        match self.columns.first() {
            _ if self.frequency_unit.is_some() || self.columns.gives_role("frequency") => false,
            Some(column) => names_periods(&column),
            None => {
                // Periods next to lengths are those of pendulums.
                let has_other =
                    |column: Column| names(Role::Frequencies, &column) || table.names_lengths(&column);
                !columns().any(has_other) && columns().any(|column| names_periods(&column))
            }
        }
    }

    fn wanted(&self, has_periods: bool) -> [Wanted; 6] {
        let frequencies = match has_periods {
            true => Wanted::periods(CountedOptions::default()),
            false => Wanted::frequencies(self.frequency_unit),
        };
        let amplitudes = Wanted::displacements(self.amplitude_unit);
        let phases = Wanted::phases(self.phase_unit).only_named(&["phase", "lag", "phi", "φ"]);
        let of_values = [frequencies.uncertainties(0), amplitudes.uncertainties(1), phases.uncertainties(4)];
        [frequencies, amplitudes, of_values[0], of_values[1], phases, of_values[2]]
    }

    pub(super) fn name(&self) -> String {
        self.file.display().to_string()
    }

    pub(super) fn no_answer(&self, reason: impl std::fmt::Display) -> QueryError {
        QueryError::no_result(&self.name(), reason)
    }
}

/// Frequencies 2π/T in place of periods T, with their uncertainties.
fn of_periods(mut read: ColumnsInSi<6>) -> ColumnsInSi<6> {
    let periods = read.columns[0].take().unwrap_or_default();
    if let Some(uncertainties) = &mut read.columns[2] {
        for (uncertainty, period) in uncertainties.iter_mut().zip(&periods) {
            *uncertainty *= TAU / (period * period);
        }
    }
    read.columns[0] = Some(periods.into_iter().map(|period| TAU / period).collect());
    read.inferences.sentences.push("the frequencies are 2π over the periods of the drive".to_owned());
    read
}
