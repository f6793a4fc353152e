//! `libration inspect FILE --spectrum`: the harmonics of measured swings.

mod fields;
mod write;

use crate::arguments::{self, RecordingOptions, finding_with_option};
use crate::figure;
use crate::figure::measured_spectrum::{MeasuredSpectrum, measured_spectra};
use crate::interrupt::{self, Cancellation};
use crate::output::{FormOptions, announce};
use crate::parallel;
use crate::query_error::{QueryError, option};
use libration_lab::fit::spectrum::{SpectrumError, SpectrumOptions, fit_spectrum};
use libration_lab::measurement::{Trace, Traces};
use std::io::Write;
use std::path::{Path, PathBuf};

pub(super) use fields::answers;

/// More than any trace tells.
const MOST_HARMONICS: usize = 99;
/// More than any trace has.
const MOST_SWINGS: usize = 100_000;

/// Options for the harmonics.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Harmonics")]
pub(super) struct SpectrumQuestion {
    /// Measure the harmonics of the swings, each compared with that of the pendulum
    #[arg(long)]
    pub(super) spectrum: bool,
    /// The highest harmonic
    #[arg(long, value_name = "N", requires = "spectrum", default_value = "7", value_parser = arguments::count::<MOST_HARMONICS>)]
    harmonics: usize,
    /// Number of swings in a window, at least three
    #[arg(long, value_name = "N", requires = "spectrum", default_value = "5", value_parser = arguments::count::<MOST_SWINGS>)]
    swings: usize,
    /// Draw the spectrum with the pendulum's harmonics to FILE.svg, .pdf, .png or .json
    #[arg(long, value_name = "FILE", requires = "spectrum", value_parser = figure::file::drawable)]
    figure: Option<PathBuf>,
    #[command(flatten)]
    layout: figure::Layout,
}

/// The harmonics of the traces of a file.
struct SpectrumResult {
    file: String,
    findings: Vec<String>,
    spectra: Vec<MeasuredSpectrum>,
    /// Reasons why other traces have no spectrum.
    left_out: Vec<String>,
}

impl SpectrumQuestion {
    pub(super) fn answer(
        &self,
        file: &Path,
        recording: &RecordingOptions,
        form: &FormOptions,
        out: &mut dyn Write,
    ) -> Result<(), QueryError> {
        let traces = recording.traces(file)?;
        let answer = self.spectra(&file.display().to_string(), &traces)?;
        let drawn = figure::file::drawn(self.figure.as_deref(), &self.layout, || {
            Ok(measured_spectra(&answer.spectra))
        })?;
        answer.write(out, form.form())?;
        Ok(announce(out, form.form(), &drawn)?)
    }

    /// An error only where no trace has harmonics.
    fn spectra(&self, file: &str, traces: &Traces) -> Result<SpectrumResult, QueryError> {
        interrupt::listen()?;
        let options = SpectrumOptions { harmonics: self.harmonics, swings: self.swings };
        let of = |trace: &Trace| fit_spectrum(trace, &options, &Cancellation);
        let all = || traces.traces.iter().map(of).collect::<Vec<_>>();
        let results = parallel::with_progress(|| "harmonics of the swings".to_owned(), all);
        let findings = traces.findings.iter().map(finding_with_option).collect();
        let mut answer =
            SpectrumResult { file: file.to_owned(), findings, spectra: vec![], left_out: vec![] };
        let mut first_error = None;
        for (trace, result) in traces.traces.iter().zip(results) {
            let name = trace.name().to_owned();
            match result {
                Ok(spectrum) => answer.spectra.push(MeasuredSpectrum { name, spectrum }),
                Err(error) => {
                    answer.left_out.push(if name.is_empty() {
                        error.to_string()
                    } else {
                        format!("{name}: {error}")
                    });
                    first_error.get_or_insert(error);
                }
            }
        }
        match first_error {
            Some(error) if answer.spectra.is_empty() => Err(failure(file, &error)),
            _ => match interrupt::check().is_break() {
                true => Err(interrupted()),
                false => Ok(answer),
            },
        }
    }
}

fn failure(file: &str, error: &SpectrumError) -> QueryError {
    use libration_lab::fit::cycles::CyclesError;
    match error {
        SpectrumError::Interrupted(_) | SpectrumError::Cycles(CyclesError::Interrupted(_)) => interrupted(),
        SpectrumError::ShortWindows(_) => QueryError::no_result(option("swings"), error),
        _ => QueryError::no_result(file, error),
    }
}

fn interrupted() -> QueryError {
    QueryError::cancelled("interrupted: nothing is written")
}
