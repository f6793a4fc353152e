//! The file of a response: its columns and their units.

use crate::arguments::{
    AmplitudeUnit, ColumnsOption, DialectOptions, DisplacementUnit, FrequencyUnit, Inferences, Wanted,
};
use crate::figure::fitted_response::Measured;
use crate::query_error::QueryError;
use libration_lab::fit::response::{AmplitudeErrors, ResponseColumns, ResponseTable};
use libration_lab::measurement::Unit;
use std::path::PathBuf;

/// The file, and options for reading it.
#[derive(Clone, Debug, clap::Args)]
pub(super) struct Input {
    /// A table of drive frequencies and amplitudes, optionally with phases and with uncertainties; - for standard input
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
    errors: Errors,
    #[command(flatten)]
    dialect: DialectOptions,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Errors {
    Absolute,
    Relative,
}

/// The measurements, and the settings with which they were read.
#[derive(Clone, Debug)]
pub(super) struct ResponseFile {
    pub(super) measured: Measured,
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

impl Input {
    pub(super) fn read(&self) -> Result<ResponseFile, QueryError> {
        let table = self.dialect.read(&self.file)?;
        let read = self.columns.read(&self.name(), &table, &self.wanted(), None, "fit response")?;
        let unit = match read.units[1] {
            Unit::Metre | Unit::Centimetre | Unit::Millimetre | Unit::Inch | Unit::Foot => "m",
            Unit::Count | Unit::Pixel => "counts",
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
                Errors::Absolute => AmplitudeErrors::Absolute,
                Errors::Relative => AmplitudeErrors::Relative,
            },
        };
        let table = ResponseTable::new(&columns).map_err(|error| self.no_answer(error))?;
        let measured = Measured {
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

    fn wanted(&self) -> [Wanted; 6] {
        let frequencies = Wanted::frequencies(self.frequency_unit);
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
