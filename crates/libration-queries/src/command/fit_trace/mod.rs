//! `libration fit trace`: measured swings explained by the damped pendulum at any amplitude.

mod answer;
mod fields;
mod input;
mod model;
mod options;
pub(crate) mod report;
mod sheet;
mod units;

use crate::arguments::{ApparatusOptions, RecordingOptions};
use crate::document;
use crate::figure;
use crate::output::{Form, FormOptions, announce, json};
use crate::query_error::QueryError;
use answer::FitTraceResult;
use input::{FitTraceInput, ReadRecordings};
use libration_lab::fit::trace::TraceOptions;
pub(super) use model::DampingChoice;
use std::io::Write;
use std::path::PathBuf;

pub(crate) use fields::answers;

/// Measured swings: ω0, damping and gravity from angles or angular velocities in time, at any amplitude
///
/// The equation of motion θ″ = −ω0² sin θ − d·sign θ′ − b·θ′ − c·θ′|θ′| is integrated and fitted to all rows of all
/// traces, which share ω0 and the damping; each has its own zero of the angle and its own start. Every cycle is also
/// measured by itself, which tests the exact law of the period: T = T0·[1 + β(R − 1)] with β = 1.
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration fit trace examples/swing_synthetic.csv --length 0.56m±0.002m
  libration fit trace examples/swing_synthetic.csv --report swing.html
  libration fit trace examples/swing_synthetic.csv --robust \\
    --model linear+quadratic --from 2s --to 10s --figure fit.svg
  libration fit trace examples/swing_synthetic.csv --time 1 --angle 2 \\
    --angle-unit deg --json")
)]
pub(crate) struct FitTrace {
    #[command(flatten)]
    input: FitTraceInput,
    /// Damping: auto to compare all kinds, or undamped, dry, linear, quadratic, or sums such as dry+linear
    #[arg(long, default_value = "auto")]
    model: DampingChoice,
    /// Give less weight to rows far from the fitted motion (robust fit)
    #[arg(long)]
    robust: bool,
    /// Fit the scale of the angles too, from the dependence of the period on the amplitude
    #[arg(long)]
    free_scale: bool,
    /// Write a report with pictures to FILE.html, or to FILE.md or FILE.tex with the pictures next to it
    #[arg(long, value_name = "FILE", value_parser = document::name)]
    report: Option<PathBuf>,
    /// Draw the data, the fitted motion and the residuals to FILE.svg, .pdf, .png or .json
    #[arg(long, value_name = "FILE", value_parser = figure::file::drawable)]
    figure: Option<PathBuf>,
    #[command(flatten)]
    layout: figure::Layout,
    #[command(flatten)]
    form: FormOptions,
    #[command(flatten)]
    apparatus: ApparatusOptions,
    #[command(flatten)]
    recording: RecordingOptions,
}

impl FitTrace {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        let measured = self.input.read(&self.recording)?;
        let answer = self.fitted(&measured)?;
        let mut written = figure::file::drawn(self.figure.as_deref(), &self.layout, || {
            Ok(report::pictures::of_all(&answer))
        })?;
        if let Some(path) = &self.report {
            written.push(document::write(path, &report::document(&answer))?);
        }
        match self.form.form() {
            Form::Json => json::document(out, fields::record(&answer))?,
            Form::Csv => fields::of_row().write_csv(out, &fields::rows(&answer))?,
            Form::Table => sheet::write(out, &answer)?,
        }
        Ok(announce(out, self.form.form(), &written)?)
    }

    fn fitted<'a>(&self, measured: &'a ReadRecordings) -> Result<FitTraceResult<'a>, QueryError> {
        let options =
            TraceOptions { robust: self.robust, free_scale: self.free_scale, ..TraceOptions::default() };
        FitTraceResult::new(measured, self.model, options, &self.apparatus)
    }
}
