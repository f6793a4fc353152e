//! `libration fit periods`: measured periods against amplitude, explained by the exact law.

mod fields;
mod input;
mod report;
mod write;

use crate::arguments::{ApparatusOptions, FormulaChoice, LinearDampingOption, positive};
use crate::document;
use crate::figure;
use crate::output::groups::{self, Groups};
use crate::output::normal_gravity::NormalGravity;
use crate::output::{FormOptions, announce};
use crate::query_error::QueryError;
use fields::FitPeriodsResult;
use input::{FitPeriodsInput, ReadPeriods};
use libration_lab::fit::{self, Law, MeasuredPeriod, PeriodFit};
use std::io::Write;
use std::path::PathBuf;

pub(crate) use fields::answers;

/// Measured periods against amplitude: T0 under the exact law and every other, a test of the exact law, gravity
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration fit periods examples/period_table_synthetic.csv
  libration fit periods examples/period_table_synthetic.csv \\
    --length 0.994m±0.001m --figure fit.svg
  libration fit periods examples/period_table_synthetic.csv \\
    --columns amplitude,period,-,sigma_period --amplitude-unit rad
  libration fit periods examples/period_table_synthetic.csv \\
    --reject-outliers 5 --json
  libration fit periods examples/class/amplitudes.csv --length 0.5m±1mm \\
    --shared-timing 0.05s
  libration fit periods examples/class/one_length.csv --length 56cm±1mm \\
    --amplitude 10deg
  libration fit periods examples/period_table_synthetic.csv \\
    --length 0.994m±0.001m --latitude 48.1deg --elevation 520m \\
    --report periods.html

Every law is fitted by weighted least squares in T0 alone. The test of the exact
law fits T = T0·[1 + β(R − 1)], where R = T/T0 by the exact law: β = 1 is the
exact law.")
)]
pub(crate) struct FitPeriods {
    #[command(flatten)]
    input: FitPeriodsInput,
    /// Leave out rows more than this many robust standard deviations from the exact law
    #[arg(long, value_name = "N", value_parser = positive)]
    reject_outliers: Option<f64>,
    #[command(flatten)]
    formulas: FormulaChoice,
    /// Draw the data, the laws and the residuals to FILE.svg, .pdf, .png or .json
    #[arg(long, value_name = "FILE", value_parser = figure::file::drawable)]
    figure: Option<PathBuf>,
    /// Write a report with pictures to FILE.html, or to FILE.md or FILE.tex with the pictures next to it
    #[arg(long, value_name = "FILE", value_parser = document::name)]
    report: Option<PathBuf>,
    #[command(flatten)]
    layout: figure::Layout,
    #[command(flatten)]
    form: FormOptions,
    #[command(flatten)]
    apparatus: ApparatusOptions,
    #[command(flatten)]
    damping: LinearDampingOption,
}

impl FitPeriods {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        let measured = self.input.read()?;
        let no_answer = |error| QueryError::no_result(&self.input.name(), error);
        let formulas = self.formulas.chosen_or_all();
        let ratios: Vec<_> =
            formulas.iter().map(|formula| |amplitude| formula.period_ratio_at(amplitude)).collect();
        let laws: Vec<Law> =
            formulas.iter().zip(&ratios).map(|(f, ratio)| Law::new(f.key(), ratio)).collect();
        let options = fit::PeriodsOptions { reject_outliers: self.reject_outliers };
        let fit = fit::fit_periods(&measured.table, &laws, &options).map_err(no_answer)?;
        let correlations = self.apparatus.correlations();
        let period =
            fit.measured_period(self.apparatus.angle_scale(), self.apparatus.clock(), self.damping.damping());
        let shared_timing = measured.shared_of(&fit);
        let period = MeasuredPeriod { shared_timing, ..period };
        let apparatus = self.apparatus.apparatus()?;
        let budget = apparatus.map(|apparatus| fit::evaluate_budget(&apparatus, &period, correlations));
        let budget = budget.transpose().map_err(|error| QueryError::no_result("gravity", error))?;
        let normal = self.apparatus.normal_gravity()?;
        let normal = budget.as_ref().zip(normal);
        let normal = normal.map(|(budget, normal)| NormalGravity { measured: budget.gravity(), normal });
        let left_out = if self.reject_outliers.is_some() { &fit.outliers[..] } else { &[] };
        let mut written = figure::file::drawn(self.figure.as_deref(), &self.layout, || {
            Ok(figure::periods::fitted(&measured.without(left_out), &fit))
        })?;
        let groups = self.groups(&measured, &fit);
        let answer = FitPeriodsResult {
            measured: &measured,
            groups: groups.as_ref(),
            fit: &fit,
            budget: budget.as_ref(),
            length: self.apparatus.length(),
            normal,
        };
        if let Some(path) = &self.report {
            written.push(document::write(path, &report::document(&answer, &self.input.name(), left_out))?);
        }
        answer.write(out, self.form.form())?;
        Ok(announce(out, self.form.form(), &written)?)
    }

    /// T0 of each group, where the rows have groups; the clock and the observer are shared.
    fn groups(&self, measured: &ReadPeriods, fit: &PeriodFit) -> Option<Groups> {
        let both = [self.apparatus.clock(), measured.shared_of(fit)]
            .map(|relative| relative.unwrap_or(0.0) * fit.exact.t0.value);
        let shared = both.iter().map(|one| one * one).sum::<f64>().sqrt();
        let of_rows = |rows: &[usize]| {
            let others: Vec<usize> = (0..measured.table.len()).filter(|row| !rows.contains(row)).collect();
            let options = fit::PeriodsOptions { reject_outliers: self.reject_outliers };
            let fit = fit::fit_periods(&measured.table.without(&others), &[], &options);
            let exact = fit.map_err(|error| error.to_string())?.exact;
            Ok((exact.t0, exact.uncertainty_degrees_of_freedom()))
        };
        Groups::fitted(measured.groups.as_ref()?, &groups::T0, shared, of_rows)
    }
}
