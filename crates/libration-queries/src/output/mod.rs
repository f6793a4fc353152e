//! Output of results: as a table to read, as JSON, as CSV, or as a file.
//!
//! # Method
//! Tables are as wide as the terminal, or as `COLUMNS` says, and 80 columns in files and pipes (`program.rs`); titles and words are folded, and
//! wide tables stand in blocks, so that nothing is lost. A field is described once (`output/field`): name, unit, meaning, value and appearance;
//! JSON, CSV, tables, sheets and `libration fields` follow. Commands whose output is written by hand (`expand`, `backbone`, `modes`, `simulate`,
//! `inspect`, `fit`) have a table of descriptions in `fields.rs`.

pub(crate) mod budget;
pub(crate) mod combined;
pub(crate) mod csv;
pub(crate) mod description;
pub(crate) mod destination;
pub(crate) mod field;
pub(crate) mod file;
pub(crate) mod formulas;
pub(crate) mod groups;
pub(crate) mod json;
pub(crate) mod language;
pub(crate) mod leftover;
pub(crate) mod mathml;
pub(crate) mod normal_gravity;
pub(crate) mod number;
pub(crate) mod progress;
pub(crate) mod scatter;
pub(crate) mod screen;
pub(crate) mod series;
pub(crate) mod standard;
pub(crate) mod table;
pub(crate) mod warnings;

use std::io::{self, Write};
use std::path::Path;

/// The form of a result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Form {
    Table,
    Json,
    Csv,
}

/// Announces, below a result in text, the files that were written.
pub(crate) fn announce(out: &mut dyn Write, form: Form, written: &[String]) -> io::Result<()> {
    if form != Form::Table || written.is_empty() {
        return Ok(());
    }
    written.iter().try_for_each(|text| table::write_text(out, "", text))
}

/// The options that choose the form.
#[derive(Clone, Copy, Debug, clap::Args)]
pub(crate) struct FormOptions {
    /// Write JSON: unrounded numbers, stable names, "schema": 2
    #[arg(long, conflicts_with = "csv")]
    json: bool,
    /// Write comma-separated values: unrounded numbers, one header line
    #[arg(long)]
    csv: bool,
}

impl FormOptions {
    /// The chosen form, or else the one of the extension of a file.
    pub(crate) fn form_of_file(self, path: Option<&Path>) -> Form {
        let ending = path.and_then(Path::extension).map(|ending| ending.to_ascii_lowercase());
        match (self.form(), ending.as_deref().and_then(|ending| ending.to_str())) {
            (Form::Table, Some("json")) => Form::Json,
            (Form::Table, Some("csv")) => Form::Csv,
            (form, _) => form,
        }
    }

    pub(crate) fn form(self) -> Form {
        match (self.json, self.csv) {
            (true, _) => Form::Json,
            (_, true) => Form::Csv,
            _ => Form::Table,
        }
    }
}
