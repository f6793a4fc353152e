//! How answers are written: as a table to read, as JSON, as CSV, or as a file.

pub(crate) mod csv;
pub(crate) mod file;
pub(crate) mod json;
pub(crate) mod number;
pub(crate) mod progress;
pub(crate) mod series;
pub(crate) mod table;

/// The form of an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Form {
    Table,
    Json,
    Csv,
}

/// The options that choose the form.
#[derive(Clone, Copy, Debug, clap::Args)]
pub(crate) struct FormOptions {
    /// Write JSON: unrounded numbers, stable names, "schema": 1
    #[arg(long, conflicts_with = "csv")]
    json: bool,
    /// Write comma-separated values: unrounded numbers, one header line
    #[arg(long)]
    csv: bool,
}

impl FormOptions {
    pub(crate) fn form(self) -> Form {
        match (self.json, self.csv) {
            (true, _) => Form::Json,
            (_, true) => Form::Csv,
            _ => Form::Table,
        }
    }
}
