//! `libration period`: the exact period, or the amplitude that has it, and every published formula with its error.

mod fields;
mod sheet;
mod table;

use crate::arguments::{AmplitudeOptions, FormulaChoice, PendulumOptions};
use crate::figure::PictureOptions;
use crate::interrupt;
use crate::output::{Form, FormOptions, announce};
use crate::query_error::QueryError;
use fields::{Estimate, Swing};
use libration::internals::InOrder;
use libration::period_formulas::{PeriodFormula, fractional_errors};
use libration::quantity::Angle;
use std::io::Write;
use std::sync::Arc;
use table::SwingsTable;

pub(crate) use fields::answers;

/// The exact period at one or more amplitudes, or the amplitude of a period, and every published formula with its error
#[derive(Debug, clap::Args)]
#[command(override_usage = "libration period [OPTIONS] <AMPLITUDE>...
       libration period [OPTIONS] --from-file|--period|--ratio|--excess <VALUE>")]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration period 60deg
  libration period 179.999999deg --length 57cm --gravity 9.81m/s^2
  libration period pi-1e-300 --json
  libration period --period '2.10(1)s'    # its amplitude
  libration period 1deg:179deg:1deg --formulas bernoulli,kidd_fogg
  libration period 10deg:170deg:10deg --csv    # with every formula
  libration period 10deg:170deg:10deg --figure periods.svg
  printf '60deg\\n1.2\\npi-1e-6\\n' | libration period --from-file - --csv")
)]
pub(crate) struct Period {
    #[command(flatten)]
    amplitudes: AmplitudeOptions,
    #[command(flatten)]
    formulas: FormulaChoice,
    /// The order of the formulas
    #[arg(long, value_enum, default_value = "error")]
    sort: FormulaOrder,
    #[command(flatten)]
    picture: PictureOptions,
    #[command(flatten)]
    pendulum: PendulumOptions,
    #[command(flatten)]
    form: FormOptions,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum FormulaOrder {
    /// Smallest error first
    Error,
    /// As in the catalogue
    Catalogue,
}

impl Period {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        let (pendulum, of_small_swings) = match self.amplitudes.depend_on_the_pendulum() {
            true => self.pendulum.with_uncertainty()?,
            false => (self.pendulum.pendulum()?, 0.0),
        };
        let amplitudes = Arc::new(self.amplitudes.read(&pendulum, of_small_swings)?);
        interrupt::listen()?;
        let swings = SwingsTable { question: self, amplitudes: &amplitudes, pendulum: &pendulum };
        let (shown, options) = (Arc::clone(&amplitudes), self.pendulum);
        let drawn = self.picture.drawn(move || table::picture(&shown, &pendulum, options))?;
        match self.form.form() {
            Form::Json => swings.write_json(out)?,
            Form::Csv => swings.write_csv(out)?,
            Form::Table => match amplitudes.single() {
                Some(given) => sheet::write(out, self, &Swing::new(given, &pendulum))?,
                None => swings.write(out)?,
            },
        }
        announce(out, self.form.form(), &drawn)?;
        out.flush()?;
        interrupt::ended_early("the amplitudes")
    }

    /// The estimates of the formulas, in the order requested.
    fn sorted<'a>(&self, mut estimates: Vec<Estimate<'a>>) -> Vec<Estimate<'a>> {
        if self.sort == FormulaOrder::Error {
            estimates.put_in_order(|a, b| a.fractional_error.abs().total_cmp(&b.fractional_error.abs()));
        }
        estimates
    }
}

/// The estimates of the formulas for each swing, in the order of the formulas.
fn estimates<'a>(swings: &[Swing], formulas: &'a [PeriodFormula]) -> Vec<Vec<Estimate<'a>>> {
    let angles: Vec<Angle> = swings.iter().map(|swing| swing.amplitude.angle()).collect();
    let mut errors = fractional_errors(formulas, &angles).into_iter();
    let mut of_swing = |(swing, angle): (&Swing, &Angle)| {
        let estimate = |(formula, fractional_error): (&'a PeriodFormula, f64)| {
            let ratio = formula.period_ratio(angle);
            let period = swing.small_angle_period * ratio;
            Estimate { formula, period, ratio, fractional_error }
        };
        formulas.iter().zip(errors.by_ref()).map(estimate).collect()
    };
    swings.iter().zip(&angles).map(&mut of_swing).collect()
}
