//! `libration fit periods`: measured periods against amplitude, explained by the exact law.

mod input;
mod write;

use crate::arguments::{FormulaChoice, length_with_uncertainty, positive};
use crate::failure::Failure;
use crate::figure;
use crate::output::FormOptions;
use input::Input;
pub(crate) use input::Measurement;
use libration::fit::{self, Law};
use libration::quantity::Quantity;
use std::io::Write;
use std::path::PathBuf;

/// Measured periods against amplitude: T0 under the exact law and every other, a test of the exact law, gravity
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  libration fit periods examples/period_table_synthetic.csv
  libration fit periods measured.txt --length 0.57m±0.004m --figure fit.svg
  libration fit periods measured.csv --columns angle,period,-,error --amplitude-unit deg
  libration fit periods measured.csv --reject-outliers 5 --json

Every law is fitted by weighted least squares in T0 alone. The test of the exact law
fits T = T0·[1 + β(R − 1)], with R = T/T0 of the exact law: β = 1 is the exact law.")]
pub(crate) struct FitPeriods {
    #[command(flatten)]
    input: Input,
    /// Length of the pendulum with its uncertainty, such as 0.57m±0.004m: gives gravity
    #[arg(long, value_parser = length_with_uncertainty)]
    length: Option<Quantity>,
    /// Leave out the rows further than this many robust standard deviations from the exact law
    #[arg(long, value_name = "N", value_parser = positive)]
    reject_outliers: Option<f64>,
    #[command(flatten)]
    formulas: FormulaChoice,
    /// Draw the data, the laws and the residuals to FILE.svg or FILE.png
    #[arg(long, value_name = "FILE", value_parser = figure::file::drawable)]
    figure: Option<PathBuf>,
    #[command(flatten)]
    form: FormOptions,
}

impl FitPeriods {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), Failure> {
        let measured = self.input.read()?;
        let no_answer = |error| Failure::no_answer(&self.input.name(), error);
        let formulas = self.formulas.chosen_or_all();
        let ratios: Vec<_> =
            formulas.iter().map(|formula| |amplitude| formula.period_ratio_at(amplitude)).collect();
        let laws: Vec<Law> =
            formulas.iter().zip(&ratios).map(|(f, ratio)| Law::new(f.key(), ratio)).collect();
        let options = fit::Options { reject_outliers: self.reject_outliers };
        let fit = fit::periods(&measured.table, &laws, &options).map_err(no_answer)?;
        let gravity = self.length.map(|length| fit::gravity(&fit.exact, length)).transpose();
        let gravity = gravity.map_err(|error| Failure::no_answer("--length", error))?;
        if let Some(path) = &self.figure {
            let left_out = if self.reject_outliers.is_some() { &fit.outliers[..] } else { &[] };
            figure::file::write(path, &figure::periods::fitted(&measured.without(left_out), &fit))?;
        }
        let answer = write::Answer { measured: &measured, fit: &fit, gravity, length: self.length };
        answer.write(out, self.form.form())
    }
}
