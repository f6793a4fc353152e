//! `libration inspect`: what a file of measurements holds.

use crate::arguments::{RecordingOptions, told};
use crate::failure::Failure;
use crate::output::FormOptions;
use std::io::Write;
use std::path::PathBuf;

/// What a file of measurements holds: format, columns with their quantities and units, and what would be fitted
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  libration inspect swing.csv
  libration inspect pendulum.xls --json
  libration inspect encoder.csv --counts-per-turn 4000
  libration inspect video.txt --unit deg")]
pub(crate) struct Inspect {
    /// What the instrument wrote: text, Excel or an archive of text files; - for the standard input
    file: PathBuf,
    #[command(flatten)]
    recording: RecordingOptions,
    #[command(flatten)]
    form: FormOptions,
}

impl Inspect {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), Failure> {
        let traces = self.recording.traces(&self.file)?;
        let _ = self.form;
        for finding in &traces.findings {
            writeln!(out, "{}", told(finding))?;
        }
        for trace in &traces.traces {
            writeln!(out, "trace {} {:?} {} rows", trace.name(), trace.seen(), trace.len())?;
        }
        Ok(())
    }
}
