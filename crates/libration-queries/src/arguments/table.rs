//! Tables of measurements: layout of the file, columns and units.

use super::read_bytes;
use super::undecided::what_would_decide;
use crate::query_error::QueryError;
use libration_lab::measurement::{Column, DecimalMark, Delimiter, Header, ReadOptions, Table, Unit};
use std::path::Path;

/// Options for the layout of a file, in place of inferred settings.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct DialectOptions {
    /// Sheet of a workbook or file of an archive, by number or name
    #[arg(long, value_parser = column)]
    pub(super) sheet: Option<Column>,
    /// Separator of the cells
    #[arg(long, value_enum)]
    delimiter: Option<Separator>,
    /// Decimal point or decimal comma
    #[arg(long, value_enum)]
    decimal: Option<DecimalOption>,
    /// Line that names the columns: detect, present, absent, or its number
    #[arg(long, value_parser = header, default_value = "detect", hide_default_value = true)]
    header: Header,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Separator {
    Comma,
    Semicolon,
    Tab,
    Space,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum DecimalOption {
    Point,
    Comma,
}

impl DialectOptions {
    /// The table in a file.
    pub(crate) fn read(&self, path: &Path) -> Result<Table, QueryError> {
        let bytes = read_bytes(path)?;
        Table::read_sheet(&bytes, &self.options(), self.sheet.as_ref())
            .map_err(|error| QueryError::no_result(&path.display().to_string(), what_would_decide(&error)))
    }

    pub(super) fn options(&self) -> ReadOptions {
        let delimiter = self.delimiter.map(|separator| match separator {
            Separator::Comma => Delimiter::Comma,
            Separator::Semicolon => Delimiter::Semicolon,
            Separator::Tab => Delimiter::Tab,
            Separator::Space => Delimiter::Whitespace,
        });
        let decimal = self.decimal.map(|mark| match mark {
            DecimalOption::Point => DecimalMark::Point,
            DecimalOption::Comma => DecimalMark::Comma,
        });
        ReadOptions { delimiter, decimal, header: self.header, ..ReadOptions::default() }
    }
}

pub(super) fn column(text: &str) -> Result<Column, String> {
    Ok(text.parse().unwrap_or_else(|never| match never {}))
}

fn header(text: &str) -> Result<Header, String> {
    match text.trim() {
        "detect" => Ok(Header::Detect),
        "present" => Ok(Header::Present),
        "absent" => Ok(Header::Absent),
        number => {
            let line = number.parse().ok().filter(|&line| line > 0);
            line.map(Header::Line)
                .ok_or_else(|| "give detect, present, absent or the number of a line".to_owned())
        }
    }
}

/// A column by number or name; `None` for `-`.
pub(crate) fn optional_column(text: &str) -> Option<Column> {
    let text = text.trim();
    (text != "-").then(|| text.parse().unwrap_or_else(|never| match never {}))
}

/// The unit of a column of amplitudes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum AmplitudeUnit {
    Rad,
    Deg,
}

impl From<AmplitudeUnit> for Unit {
    fn from(unit: AmplitudeUnit) -> Self {
        match unit {
            AmplitudeUnit::Rad => Self::Radian,
            AmplitudeUnit::Deg => Self::Degree,
        }
    }
}

/// The unit of a column of lengths.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum LengthUnit {
    M,
    Dm,
    Cm,
    Mm,
    In,
    Ft,
}

impl From<LengthUnit> for Unit {
    fn from(unit: LengthUnit) -> Self {
        match unit {
            LengthUnit::M => Self::Metre,
            LengthUnit::Dm => Self::Decimetre,
            LengthUnit::Cm => Self::Centimetre,
            LengthUnit::Mm => Self::Millimetre,
            LengthUnit::In => Self::Inch,
            LengthUnit::Ft => Self::Foot,
        }
    }
}

/// The unit of a column of frequencies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum FrequencyUnit {
    #[value(name = "Hz")]
    Hz,
    #[value(name = "kHz")]
    Khz,
    #[value(name = "rad/s")]
    RadPerS,
    #[value(name = "deg/s")]
    DegPerS,
}

impl From<FrequencyUnit> for Unit {
    fn from(unit: FrequencyUnit) -> Self {
        match unit {
            FrequencyUnit::Hz => Self::Hertz,
            FrequencyUnit::Khz => Self::Kilohertz,
            FrequencyUnit::RadPerS => Self::RadianPerSecond,
            FrequencyUnit::DegPerS => Self::DegreePerSecond,
        }
    }
}

/// The unit of a column of displacements.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum DisplacementUnit {
    Rad,
    Deg,
    M,
    Cm,
    Mm,
    In,
    /// Values of a converter or in any other unit, such as volts
    Counts,
}

impl From<DisplacementUnit> for Unit {
    fn from(unit: DisplacementUnit) -> Self {
        match unit {
            DisplacementUnit::Rad => Self::Radian,
            DisplacementUnit::Deg => Self::Degree,
            DisplacementUnit::M => Self::Metre,
            DisplacementUnit::Cm => Self::Centimetre,
            DisplacementUnit::Mm => Self::Millimetre,
            DisplacementUnit::In => Self::Inch,
            DisplacementUnit::Counts => Self::Count,
        }
    }
}
