//! `libration fit amplitudes`: falling amplitudes or turning points, with the damping law and the quality factor.

mod columns;
mod fields;
mod input;
mod report;
mod write;

use crate::command::fit_trace::DampingChoice;
use crate::document;
use crate::figure;
use crate::output::{FormOptions, announce};
use crate::query_error::QueryError;
use fields::FitAmplitudesResult;
use input::FitAmplitudesInput;
use libration::quantity::Quantity;
use libration_lab::fit::amplitudes::{AmplitudesOptions, fit_amplitudes};
use std::io::Write;
use std::path::PathBuf;

pub(crate) use fields::answers;

/// Amplitudes or turning points against time or number of swings: damping law, its coefficients, quality factor
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration fit amplitudes examples/amplitudes_synthetic.csv
  libration fit amplitudes examples/amplitudes_synthetic.csv --model linear \\
    --figure amplitudes.svg
  libration fit amplitudes examples/amplitudes_synthetic.csv --columns 1,2 \\
    --period 1.42s --json
  libration fit amplitudes examples/amplitudes_synthetic.csv \\
    --report amplitudes.html

The energy falls at its mean rate over an undamped cycle, which is right for
weak damping; a warning says where it is not, as close to the top.
Q is ω0/c for linear damping, where A falls as exp(-ct/2); for other laws
2πE/ΔE of a cycle at the amplitude that is named. Numbers of swings give Q
without a period; times need --period, a column of periods T, or one of
numbers n.")
)]
pub(crate) struct FitAmplitudes {
    #[command(flatten)]
    input: FitAmplitudesInput,
    /// Period of small swings, such as 1.42s±0.01s [default: by columns of periods T, or of times t and numbers of swings n]
    #[arg(long, value_name = "PERIOD", value_parser = crate::arguments::period_with_uncertainty)]
    period: Option<Quantity>,
    /// The damping: dry, linear, quadratic, a sum such as dry+linear, or auto for the simplest law that the rows do not exclude
    #[arg(long, value_name = "DAMPING", default_value = "auto")]
    model: DampingChoice,
    /// Draw the data, the law and the residuals to FILE.svg, .pdf, .png or .json
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

impl FitAmplitudes {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        let file = self.input.read()?;
        let damping = match self.model {
            DampingChoice::Auto => None,
            DampingChoice::Given(damping) => Some(damping),
        };
        let options = AmplitudesOptions { damping, period: self.period };
        let fit =
            fit_amplitudes(&file.measured.table, &options).map_err(|error| self.input.no_answer(error))?;
        let mut written = figure::file::drawn(self.figure.as_deref(), &self.layout, || {
            Ok(figure::amplitudes::fitted(&file.measured, &fit))
        })?;
        let answer = FitAmplitudesResult { file: &file, fit: &fit };
        if let Some(path) = &self.report {
            written.push(document::write(path, &report::document(&answer, &self.input.name()))?);
        }
        answer.write(out, self.form.form())?;
        Ok(announce(out, self.form.form(), &written)?)
    }
}
