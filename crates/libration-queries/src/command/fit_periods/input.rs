//! The file of a period table: its columns, its unit, its dialect.

use crate::arguments::{
    AMPLITUDES, AmplitudeUnit, ColumnsInSi, ColumnsOption, CountedOptions, DialectOptions, GroupOption,
    Inferences, LengthUnit, TableFit, Wanted, column_or_one_amplitude,
};
use crate::figure::periods::Measurement;
use crate::query_error::QueryError;
use libration::quantity::Angle;
use libration_lab::fit::{PeriodFit, PeriodTable, Uncertainties};
use libration_lab::measurement::Table;
use std::path::PathBuf;

/// The file, and options for reading it.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct FitPeriodsInput {
    /// A table of amplitudes and periods, optionally with uncertainties; - for standard input
    file: PathBuf,
    #[command(flatten)]
    columns: ColumnsOption,
    #[command(flatten)]
    group: GroupOption,
    /// The amplitude of all swings, such as 10deg, for a table without amplitudes
    #[arg(long, value_name = "ANGLE", value_parser = crate::arguments::angle)]
    amplitude: Option<Angle>,
    /// Unit of the amplitudes and of their uncertainties [default: that of the header, else rad, or deg for angles of π or more]
    #[arg(long, value_enum)]
    amplitude_unit: Option<AmplitudeUnit>,
    #[command(flatten)]
    counted: CountedOptions,
    #[command(flatten)]
    dialect: DialectOptions,
}

/// The measurements, as columns (rad and s) and as the table to fit.
#[derive(Clone, Debug)]
pub(super) struct ReadPeriods {
    pub(super) rows: Vec<Measurement>,
    pub(super) table: PeriodTable,
    pub(super) lines: Vec<u64>,
    pub(super) dropped: usize,
    /// The units stated in the header.
    pub(super) inferences: Inferences,
    /// Standard uncertainties of the periods by the common error of all timings.
    pub(super) shared_timing: Option<Vec<f64>>,
    /// Names of the groups of the rows.
    pub(super) groups: Option<Vec<String>>,
}

impl ReadPeriods {
    /// The relative standard uncertainty of T0 by the common error of all timings.
    pub(super) fn shared_of(&self, fit: &PeriodFit) -> Option<f64> {
        let shared = self.shared_timing.as_ref()?;
        let kept =
            (0..shared.len()).filter(|row| fit.table.len() == shared.len() || !fit.outliers.contains(row));
        fit.relative_shift(&kept.map(|row| shared[row]).collect::<Vec<_>>())
    }

    /// The rows without these.
    pub(super) fn without(&self, left_out: &[usize]) -> Vec<Measurement> {
        let kept = self.rows.iter().enumerate().filter(|(index, _)| !left_out.contains(index));
        kept.map(|(_, row)| *row).collect()
    }
}

impl FitPeriodsInput {
    pub(super) fn name(&self) -> String {
        self.file.display().to_string()
    }

    pub(super) fn read(&self) -> Result<ReadPeriods, QueryError> {
        let table = self.dialect.read(&self.file)?;
        let group = self.group.group.as_ref();
        let read = self.columns.read(&self.name(), &table, &self.wanted(), group, "fit periods");
        let read = read.map_err(|error| match TableFit::of(&table) {
            None if self.amplitude.is_none() => {
                error.with_hint("<--amplitude> is that of all swings, for a table without amplitudes")
            }
            _ => error,
        })?;
        self.refuse_lengths(&table)?;
        self.measured(read)
    }

    /// Refuses a table of several lengths, which have no common T0.
    fn refuse_lengths(&self, table: &Table) -> Result<(), QueryError> {
        const COMMAND: &str = "fit lengths";
        let is_of_lengths = || TableFit::of(table).is_some_and(|fit| fit.command == COMMAND);
        if self.columns.are_given() || !is_of_lengths() {
            return Ok(());
        }
        let wanted = [Wanted::lengths(None::<LengthUnit>), Wanted::periods(self.counted)];
        let read = self.columns.read(&self.name(), table, &wanted, self.group.group.as_ref(), COMMAND);
        let lengths = read.ok().and_then(|read| read.columns.into_iter().next()?).unwrap_or_default();
        match lengths.windows(2).all(|pair| pair[0].total_cmp(&pair[1]).is_eq()) {
            true => Ok(()),
            false => Err(self
                .no_answer("the rows have several lengths, and T0 is that of one")
                .with_hint("all of them give g by <libration fit lengths>, which has <--amplitude> too")),
        }
    }

    fn wanted(&self) -> [Wanted; 4] {
        let (amplitudes, periods) = (Wanted::amplitudes(self.amplitude_unit), Wanted::periods(self.counted));
        let amplitudes =
            if self.amplitude.is_some() { amplitudes.only_named(AMPLITUDES) } else { amplitudes };
        [amplitudes, periods, amplitudes.uncertainties(0), periods.uncertainties(1)]
    }

    fn measured(&self, read: ColumnsInSi<4>) -> Result<ReadPeriods, QueryError> {
        let [amplitudes, periods, of_amplitudes, of_periods] = read.columns;
        let periods = periods.unwrap_or_default();
        let mut amplitudes = column_or_one_amplitude(amplitudes, self.amplitude.as_ref())?;
        if self.amplitude.is_some() {
            amplitudes = amplitudes.repeat(periods.len());
        }
        let uncertainties =
            Uncertainties { amplitudes: of_amplitudes.as_deref(), periods: of_periods.as_deref() };
        let table = PeriodTable::new(&amplitudes, &periods, uncertainties);
        let [_, rounding, ..] = read.rounding;
        let table = table.map_err(|error| self.no_answer(error))?.with_rounding(rounding);
        let [_, repeated, ..] = read.repeated;
        let table = match repeated {
            Some(readings) => table.with_readings(readings),
            None => table,
        };
        let row = |index: usize| Measurement {
            amplitude: amplitudes[index].abs(),
            period: periods[index],
            amplitude_uncertainty: of_amplitudes.as_ref().map(|column| column[index]),
            period_uncertainty: of_periods.as_ref().map(|column| column[index]),
        };
        let rows = (0..periods.len()).map(row).collect();
        Ok(ReadPeriods {
            rows,
            table,
            lines: read.lines,
            dropped: read.dropped,
            inferences: read.inferences,
            shared_timing: read.shared_timing,
            groups: read.groups,
        })
    }

    fn no_answer(&self, reason: impl std::fmt::Display) -> QueryError {
        QueryError::no_result(&self.name(), reason)
    }
}
