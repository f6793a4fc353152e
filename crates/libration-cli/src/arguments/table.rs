//! A table of measurements: how its file is written, which columns are meant, in which units.

use super::read_bytes;
use crate::failure::Failure;
use libration::measurement::{Column, Delimiter, Header, Options, Table};
use libration::quantity::{Angle, QuantityError};
use std::path::Path;

/// How a table is written, where it is not to be told from the file.
#[derive(Clone, Copy, Debug, clap::Args)]
pub(crate) struct DialectOptions {
    /// What separates the columns [default: found in the file]
    #[arg(long, value_enum)]
    delimiter: Option<Separator>,
    /// Whether the first row names the columns
    #[arg(long, value_enum, default_value = "detect")]
    header: FirstRow,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Separator {
    Comma,
    Semicolon,
    Tab,
    Space,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum FirstRow {
    Detect,
    Present,
    Absent,
}

impl DialectOptions {
    /// The table in a file.
    pub(crate) fn read(self, path: &Path) -> Result<Table, Failure> {
        let bytes = read_bytes(path)?;
        Table::read(&bytes, &self.options())
            .map_err(|error| Failure::no_answer(&path.display().to_string(), error))
    }

    fn options(self) -> Options {
        let delimiter = self.delimiter.map(|separator| match separator {
            Separator::Comma => Delimiter::Comma,
            Separator::Semicolon => Delimiter::Semicolon,
            Separator::Tab => Delimiter::Tab,
            Separator::Space => Delimiter::Whitespace,
        });
        let header = match self.header {
            FirstRow::Detect => Header::Detect,
            FirstRow::Present => Header::Present,
            FirstRow::Absent => Header::Absent,
        };
        Options { delimiter, header, ..Options::default() }
    }
}

/// A column by number or name; none for -.
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

impl AmplitudeUnit {
    /// The column in radians.
    pub(crate) fn radians(self, values: &[f64]) -> Result<Vec<f64>, QuantityError> {
        let radians = |&value: &f64| match self {
            Self::Rad => Ok(value),
            Self::Deg => Angle::from_degrees(value).map(|angle| angle.radians()),
        };
        values.iter().map(radians).collect()
    }
}

/// The unit of a column of lengths.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(crate) enum LengthUnit {
    M,
    Cm,
    Mm,
    In,
}

impl LengthUnit {
    /// The column in metres.
    pub(crate) fn metres(self, values: &[f64]) -> Vec<f64> {
        // Divisors are exact where factors such as 0.01 are not.
        let (factor, divisor) = match self {
            Self::M => (1.0, 1.0),
            Self::Cm => (1.0, 100.0),
            Self::Mm => (1.0, 1000.0),
            Self::In => (254.0, 10_000.0),
        };
        values.iter().map(|value| value * factor / divisor).collect()
    }
}
