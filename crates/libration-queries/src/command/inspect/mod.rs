//! `libration inspect`: the contents of a file of measurements.

mod answer;
mod fields;
mod spectrum;
mod write;

use crate::arguments::{RecordingOptions, read_bytes};
use crate::output::FormOptions;
use crate::output::description::Answers;
use crate::query_error::QueryError;
use answer::InspectResult;
use spectrum::SpectrumQuestion;
use std::io::Write;
use std::path::PathBuf;

/// The fields with and without harmonics.
pub(crate) fn answers() -> Vec<Answers> {
    [fields::answers(), vec![spectrum::answers()]].concat()
}

/// The contents of a file of measurements: columns with quantities and units, faults, and the proposed fit
///
/// Everything is detected in the file; each finding names the option that overrides it, and the fits take the same options.
/// Where a file leaves something open, it is described together with the options that would settle it.
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration inspect examples/swing_synthetic.csv
  libration inspect examples/swing_synthetic.csv --spectrum
  libration inspect examples/phone/swing.txt --angle-unit rad --spectrum \\
    --harmonics 5 --figure spectrum.svg
  libration inspect examples/gate_synthetic.csv --json --values
  libration inspect examples/swing_synthetic.csv --angle 2 --angle-unit deg
  printf '0 9\\n0.1 5\\n0.2 3\\n' | libration inspect - --angle 2 --angle-unit deg
  printf 't (s),x,y\\n0,5,0\\n1,4,1\\n2,5,0\\n' | libration inspect - --pivot 0,3")
)]
pub(crate) struct Inspect {
    /// File of the instrument: text, Excel, or an archive of text files; - for standard input
    file: PathBuf,
    /// In JSON, list the numbers of all columns, and the rows that would be fitted in seconds and radians
    #[arg(long, requires = "json", conflicts_with = "spectrum")]
    values: bool,
    #[command(flatten)]
    form: FormOptions,
    #[command(flatten)]
    question: SpectrumQuestion,
    #[command(flatten)]
    recording: RecordingOptions,
}

impl Inspect {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        if self.question.spectrum {
            return self.question.answer(&self.file, &self.recording, &self.form, out);
        }
        let bytes = read_bytes(&self.file)?;
        let recording = self.recording.recording_in(&self.file, &bytes)?;
        let file = self.file.display().to_string();
        let answer = InspectResult::new(file, bytes.len(), recording, &self.recording.choices());
        let table_fit = match (&answer.traces, &answer.gates) {
            (Err(_), None) => self.recording.table_fit(&bytes),
            _ => None,
        };
        write::answer(out, &InspectResult { with_values: self.values, table_fit, ..answer }, self.form.form())
    }
}
