//! `libration fit response`: measured response curves of a driven oscillator.

mod fields;
mod input;
mod report;
mod write;

use crate::document;
use crate::figure::{self, fitted_response};
use crate::output::{FormOptions, announce};
use crate::query_error::QueryError;
use crate::{interrupt, parallel};
use fields::FitResponseResult;
use input::{FitResponseInput, ResponseFile};
use libration::progress::{Progress, Status};
use libration_lab::fit::response::{
    FittedCurve, MeasuredAmplitude, ResponseFit, ResponseFitError, ResponseModel, ResponsesFit, fit_response,
};
use std::io::Write;
use std::path::PathBuf;

pub(crate) use fields::answers;

/// Amplitudes and phases of a driven oscillator against frequency: natural frequency, damping and drive, through its jumps
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration fit response examples/response_synthetic.csv
  libration fit response examples/response_synthetic.csv --model pendulum \\
    --figure response.svg --report response.html
  libration fit response examples/response_synthetic.csv --columns 1,2,-,3 \\
    --amplitude-unit deg --json

x'' = -c x' - ω0² sin x + A cos Ωt, or with ω0² x + κ x³ (duffing), or ω0² x
(linear), with all harmonics. The drive that sustains a response of the measured
amplitude is compared with A: it is single-valued on each branch, so that points
of sweeps up and down are fitted together.")
)]
pub(crate) struct FitResponse {
    #[command(flatten)]
    input: FitResponseInput,
    /// The oscillator [default: the simplest consistent with the rows; a pendulum if amplitudes are angles]
    #[arg(long, value_enum)]
    model: Option<ModelChoice>,
    /// The quantity measured as the amplitude
    #[arg(long, value_enum, default_value = "peak")]
    measured: MeasuredQuantity,
    /// Draw the data and the curve, its unstable part dashed, to FILE.svg, .pdf, .png or .json
    #[arg(long, value_name = "FILE", value_parser = figure::file::drawable)]
    figure: Option<PathBuf>,
    /// Write a report with pictures to FILE.html, or to FILE.md or FILE.tex with the pictures next to it
    #[arg(long, value_name = "FILE", value_parser = document::name)]
    report: Option<PathBuf>,
    #[command(flatten)]
    layout: figure::Layout,
    #[command(flatten)]
    form: FormOptions,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum ModelChoice {
    Linear,
    Pendulum,
    Duffing,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum MeasuredQuantity {
    /// The largest displacement
    Peak,
    /// The harmonic with the frequency of the drive, as of a lock-in amplifier
    Fundamental,
}

fn how_far() -> String {
    "fit of the response".to_owned()
}

impl FitResponse {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        let file = self.input.read()?;
        interrupt::listen()?;
        let (fit, curve) = parallel::with_progress(how_far, || self.fitted(&file))?;
        let mut written = figure::file::drawn(self.figure.as_deref(), &self.layout, || {
            Ok(fitted_response::fitted(&file.measured, fit.best(), &curve))
        })?;
        let answer = FitResponseResult { file: &file, fit: &fit, curve: &curve };
        if let Some(path) = &self.report {
            written.push(document::write(path, &report::document(&answer, &self.input.name()))?);
        }
        answer.write(out, self.form.form())?;
        Ok(announce(out, self.form.form(), &written)?)
    }

    fn fitted(&self, file: &ResponseFile) -> Result<(ResponsesFit, FittedCurve), QueryError> {
        let progress = |_: Status| parallel::update(&how_far);
        let measured = match self.measured {
            MeasuredQuantity::Peak => MeasuredAmplitude::Peak,
            MeasuredQuantity::Fundamental => MeasuredAmplitude::Fundamental,
        };
        let fit = fit_response(&file.measured.table, &self.models(file), measured, &progress);
        let fit = fit.map_err(|error| self.failure(&error))?;
        let curve = self.curve(fit.best(), file, &progress)?;
        Ok((fit, curve))
    }

    fn models(&self, file: &ResponseFile) -> Vec<ResponseModel> {
        match self.model {
            Some(ModelChoice::Linear) => vec![ResponseModel::Linear],
            Some(ModelChoice::Pendulum) => vec![ResponseModel::Pendulum],
            Some(ModelChoice::Duffing) => vec![ResponseModel::Duffing],
            None => {
                let possible = |model: &ResponseModel| file.is_angle() || *model != ResponseModel::Pendulum;
                ResponseModel::ALL.into_iter().filter(possible).collect()
            }
        }
    }

    /// A little beyond the measured frequencies on both sides; no curve where a motion cannot be followed.
    fn curve(
        &self,
        fit: &ResponseFit,
        file: &ResponseFile,
        progress: &dyn Progress,
    ) -> Result<FittedCurve, QueryError> {
        const BEYOND: f64 = 0.06;
        let [low, high] = file.measured.table.frequency_range();
        let margin = BEYOND * (high - low).max(0.1 * high);
        let range = [(low - margin).max(0.5 * low), high + margin];
        let curve = fit.curve(range, progress);
        match interrupt::check().is_break() {
            true => Err(self.failure(&ResponseFitError::Interrupted)),
            false => Ok(curve.unwrap_or_default()),
        }
    }

    fn failure(&self, error: &ResponseFitError) -> QueryError {
        match error {
            ResponseFitError::Interrupted => {
                QueryError::cancelled("interrupted before a fit was found: nothing is written")
            }
            _ => self.input.no_answer(error),
        }
    }
}
