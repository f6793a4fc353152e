//! The file of a length table: its columns and their units.

use crate::arguments::{
    AMPLITUDES, AmplitudeUnit, ColumnsOption, CountedOptions, DialectOptions, GroupOption, Inferences,
    LengthUnit, Wanted, column_or_one_amplitude,
};
use crate::figure::lengths::MeasuredLengths;
use crate::query_error::{QueryError, option};
use libration::quantity::{Angle, Quantity};
use libration_lab::fit::{LengthColumns, LengthTable};
use std::path::PathBuf;

/// The file, and options for reading it.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct FitLengthsInput {
    /// A table of lengths and periods, optionally with uncertainties; - for standard input
    file: PathBuf,
    #[command(flatten)]
    columns: ColumnsOption,
    #[command(flatten)]
    group: GroupOption,
    /// Unit of the lengths and of their uncertainties [default: that of the header, else m]
    #[arg(long, value_enum)]
    length_unit: Option<LengthUnit>,
    /// The amplitude of all swings, such as 10deg [default: negligible]
    #[arg(long, value_name = "ANGLE", value_parser = crate::arguments::angle)]
    amplitude: Option<Angle>,
    /// Unit of a column of amplitudes [default: that of the header, else rad, or deg for angles of π or more]
    #[arg(long, value_enum)]
    amplitude_unit: Option<AmplitudeUnit>,
    #[command(flatten)]
    counted: CountedOptions,
    #[command(flatten)]
    dialect: DialectOptions,
}

/// The measurements, and the settings with which they were read.
#[derive(Clone, Debug)]
pub(super) struct LengthFile {
    pub(super) measured: MeasuredLengths,
    pub(super) dropped: usize,
    /// The units stated in the header.
    pub(super) inferences: Inferences,
    pub(super) half_periods: bool,
    /// Standard uncertainties of the periods by their rounding.
    rounding: Vec<f64>,
    /// Standard uncertainties of the periods by the common error of all timings.
    pub(super) shared_timing: Option<Vec<f64>>,
    /// Names of the groups of the rows.
    pub(super) groups: Option<Vec<String>>,
    /// The lines of the file that the rows came from.
    pub(super) lines: Vec<u64>,
}

impl LengthFile {
    /// Takes the rounding of the periods as their uncertainty.
    pub(super) fn weight_by_rounding(&mut self) {
        self.measured.period_uncertainties = Some(self.rounding.clone());
        let text = "the rows scatter less than the last digit of their periods, which is their uncertainty";
        self.inferences.sentences.push(text.to_owned());
    }
}

/// Amplitude in radians above which radians are not assumed: few pendulums swing that far, and small swings in degrees have such numbers.
const LARGE: f64 = 1.0;

impl FitLengthsInput {
    pub(super) fn name(&self) -> String {
        self.file.display().to_string()
    }

    pub(super) fn read(&self) -> Result<LengthFile, QueryError> {
        let table = self.dialect.read(&self.file)?;
        let group = self.group.group.as_ref();
        let read = self.columns.read(&self.name(), &table, &self.wanted(), group, "fit lengths")?;
        let [lengths, periods, length_uncertainties, of_periods, amplitudes] = read.columns;
        let lengths = lengths.unwrap_or_default();
        let periods = periods.unwrap_or_default();
        let largest =
            amplitudes.iter().flatten().fold(0.0_f64, |largest, amplitude| largest.max(amplitude.abs()));
        if largest > LARGE && !read.are_stated[4] {
            return Err(QueryError::usage(
                option("amplitude-unit"),
                format!(
                    "is needed: the amplitudes, up to {largest}, have no unit, and may be degrees or radians"
                ),
            ));
        }
        let amplitudes = column_or_one_amplitude(amplitudes, self.amplitude.as_ref())?;
        let exactly = |value: f64| Quantity { value, uncertainty: None };
        let columns = LengthColumns {
            lengths: &lengths,
            periods: &periods,
            length_uncertainties: length_uncertainties.as_deref(),
            period_uncertainties: of_periods.as_deref(),
            amplitudes: &amplitudes.into_iter().map(exactly).collect::<Vec<Quantity>>(),
        };
        let rounding = read.rounding[1].clone();
        let table = LengthTable::new(&columns).map_err(|error| self.no_answer(error))?;
        let table = table.with_rounding(rounding.clone());
        let table = match &read.repeated[1] {
            Some(readings) => table.with_readings(readings.clone()),
            None => table,
        };
        let period_uncertainties = of_periods;
        Ok(LengthFile {
            measured: MeasuredLengths { lengths, periods, length_uncertainties, period_uncertainties, table },
            dropped: read.dropped,
            inferences: read.inferences,
            half_periods: read.counts[1].total_cmp(&0.5).is_eq(),
            rounding,
            shared_timing: read.shared_timing,
            groups: read.groups,
            lines: read.lines,
        })
    }

    fn wanted(&self) -> [Wanted; 5] {
        let (lengths, periods) = (Wanted::lengths(self.length_unit), Wanted::periods(self.counted));
        let of_both = [lengths.uncertainties(0), periods.uncertainties(1)];
        let amplitudes = Wanted::amplitudes(self.amplitude_unit).only_named(AMPLITUDES);
        [lengths, periods, of_both[0], of_both[1], amplitudes]
    }

    pub(super) fn no_answer(&self, reason: impl std::fmt::Display) -> QueryError {
        QueryError::no_result(&self.name(), reason)
    }
}
