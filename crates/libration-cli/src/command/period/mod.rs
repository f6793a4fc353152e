//! `libration period`: the exact period, and every published formula with its error.

mod sheet;
mod table;

use crate::arguments::{AmplitudeOptions, FormulaChoice, PendulumOptions};
use crate::failure::Failure;
use crate::interrupt;
use crate::output::json::{self, Record};
use crate::output::progress::watched;
use crate::output::{Form, FormOptions};
use libration::pendulum::{Amplitude, Pendulum};
use libration::period_formulas::{PeriodFormula, fractional_errors};
use serde_json::Value;
use std::io::Write;

/// The exact period at one or more amplitudes, and every published formula with its error
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  libration period 60deg
  libration period 179.999999deg --length 57cm --gravity 9.81m/s^2
  libration period pi-1e-300 --json
  libration period 1deg:179deg:1deg --formulas bernoulli,kidd_fogg
  libration period 10deg:170deg:10deg --csv    # with every formula
  printf '60deg\\n1.2\\npi-1e-6\\n' | libration period --from-file - --csv")]
pub(crate) struct Period {
    #[command(flatten)]
    amplitudes: AmplitudeOptions,
    #[command(flatten)]
    formulas: FormulaChoice,
    /// The order of the formulas
    #[arg(long, value_enum, default_value = "error")]
    sort: Order,
    #[command(flatten)]
    pendulum: PendulumOptions,
    #[command(flatten)]
    form: FormOptions,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Order {
    /// Smallest error first
    Error,
    /// As in the catalogue
    Catalogue,
}

/// What one formula says at one amplitude.
#[derive(Clone, Copy, Debug)]
struct Estimate<'a> {
    formula: &'a PeriodFormula,
    ratio: f64,
    fractional_error: f64,
}

impl Period {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), Failure> {
        let amplitudes = self.amplitudes.read()?;
        let pendulum = self.pendulum.pendulum()?;
        interrupt::listen()?;
        match self.form.form() {
            Form::Json => {
                let formulas = self.formulas.chosen_or_all();
                let amplitudes = watched(amplitudes.iter(), amplitudes.len(), "amplitudes");
                let results = amplitudes.map(|a| self.record(&a, &pendulum, formulas));
                json::document_with_list(out, self.pendulum.record(), "results", results)?;
            }
            Form::Csv => table::write_csv(out, self, &amplitudes, &pendulum)?,
            Form::Table => match amplitudes.single() {
                Some(amplitude) => sheet::write(out, self, &amplitude, &pendulum)?,
                None => table::write(out, self, &amplitudes, &pendulum)?,
            },
        }
        out.flush()?;
        interrupt::ended_early("the amplitudes")
    }

    fn record(&self, amplitude: &Amplitude, pendulum: &Pendulum, formulas: &[PeriodFormula]) -> Record {
        let period = pendulum.period(amplitude);
        let estimates = self.estimates(amplitude, formulas).into_iter().map(|estimate| {
            let record = Record::new()
                .with("key", estimate.formula.key())
                .number("ratio", estimate.ratio)
                .number("period_s", pendulum.small_angle_period() * estimate.ratio)
                .number("fractional_error", estimate.fractional_error);
            Value::from(record)
        });
        Record::new()
            .number("amplitude_rad", amplitude.radians())
            .number("complement_rad", amplitude.complement())
            .number("small_angle_period_s", pendulum.small_angle_period())
            .number("period_s", period)
            .number("frequency_hz", period.recip())
            .number("ratio", amplitude.period_ratio())
            .number("excess", amplitude.period_excess())
            .number("nome", amplitude.nome())
            .number("condition", amplitude.condition())
            .with("formulas", estimates.collect::<Vec<_>>())
    }

    /// What the formulas say, in the order asked for.
    fn estimates<'a>(&self, amplitude: &Amplitude, formulas: &'a [PeriodFormula]) -> Vec<Estimate<'a>> {
        let angle = amplitude.angle();
        let errors = fractional_errors(formulas, &angle);
        let estimate = |(formula, fractional_error): (&'a PeriodFormula, f64)| Estimate {
            formula,
            ratio: formula.period_ratio(&angle),
            fractional_error,
        };
        let mut estimates: Vec<_> = formulas.iter().zip(errors).map(estimate).collect();
        if self.sort == Order::Error {
            estimates.sort_by(|a, b| a.fractional_error.abs().total_cmp(&b.fractional_error.abs()));
        }
        estimates
    }
}
