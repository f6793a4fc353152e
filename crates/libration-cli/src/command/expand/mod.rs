//! `libration expand`: exact perturbation series of any oscillator.

mod json;
mod listing;

use crate::arguments::{self, Chosen, OscillatorOptions};
use crate::failure::Failure;
use crate::output::{Form, FormOptions};
use libration::perturbation::{Expansion, Gauge, MAX_ORDER, expand};
use std::io::Write;

/// Exact series of an oscillator's frequency, harmonics and period, to any order
///
/// Periodic motions are expanded by Lindstedt and Poincaré's method in a parameter ε whose meaning, the gauge, can be
/// chosen; frequency, period and harmonics are also given as functions of the amplitude, which is the same in every
/// gauge. Self-excited oscillators with an open parameter, such as `van_der_pol`, are expanded in that parameter.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  libration expand pendulum --order 7
  libration expand pendulum --order 9 --gauge A1=1,A3=-1
  libration expand \"x'' + x + 0.1*x^3 = 0\" --order 5 --latex
  libration expand quadratic --order 6 --gauge half_swing
  libration expand van_der_pol --order 8 --json

Gauges: fundamental (ε is the coefficient of cos Ωt), x_max, half_swing, energy (ε = √(2E)/ω0),
nome (pendulum, ε = 8√q), or the coefficients of a₁ = A₁ε + A₂ε² + …, such as A1=1,A3=-1.")]
pub(crate) struct Expand {
    #[command(flatten)]
    oscillator: OscillatorOptions,
    /// The highest power of the expansion parameter
    #[arg(long, default_value = "7", value_parser = arguments::count::<MAX_ORDER>)]
    order: usize,
    /// What the expansion parameter means
    #[arg(long, default_value = "fundamental")]
    gauge: Gauge,
    /// Write LaTeX
    #[arg(long, conflicts_with_all = ["json", "csv"])]
    latex: bool,
    #[command(flatten)]
    form: FormOptions,
}

/// An expansion with the words for it.
struct Answer {
    key: Option<&'static str>,
    title: String,
    equation: String,
    equation_latex: String,
    expansion: Expansion,
    notes: Vec<String>,
}

impl Expand {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), Failure> {
        let chosen = self.oscillator.chosen()?;
        let expansion = expand(&chosen.oscillator, self.order, &self.gauge)
            .map_err(|error| Failure::no_answer("expansion", error))?;
        let answer = Answer::new(chosen, expansion);
        match self.form.form() {
            Form::Json => json::write(out, &answer)?,
            Form::Csv => json::write_csv(out, &answer)?,
            Form::Table if self.latex => listing::write_latex(out, &answer)?,
            Form::Table => listing::write(out, &answer)?,
        }
        Ok(())
    }
}

impl Answer {
    fn new(chosen: Chosen, expansion: Expansion) -> Self {
        let equation = chosen.oscillator.equation();
        Self {
            key: chosen.key,
            title: chosen.title,
            equation: equation.to_string(),
            equation_latex: equation.to_latex().join(r",\quad "),
            expansion,
            notes: vec![],
        }
    }
}
