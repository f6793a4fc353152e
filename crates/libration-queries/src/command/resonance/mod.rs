//! `libration resonance`: the slow flow of coupled modes near equilibrium, and their exchange of energy.

mod fields;
mod letters;
mod write;

use crate::arguments::{EquilibriumOptions, InitialOptions, SystemOptions, count, part};
use crate::figure::resonance::ModeAmplitudes;
use crate::output::language::FormatOptions;
use crate::output::{FormOptions, announce};
use crate::query_error::{QueryError, argument, option};
use crate::{figure, interrupt, parallel};
use libration::normal_form::{
    Exchange, ExchangeError, LARGEST_ORDER, MeasuredExchange, NormalForm, NormalFormError,
};
use libration::progress::Quiet;
use libration::systems::Model;
use std::io::Write;
use std::path::PathBuf;

pub(crate) use fields::answers;

/// Slow changes of the modes of a system near equilibrium: the normal form with its resonances, and the exchange of energy between modes
///
/// With aⱼ the complex amplitude of mode j, coordinates are xₑ + Re Σ aⱼφⱼ to first order. Terms that turn as fast as aⱼ stay in aⱼ′,
/// exactly where the modes are exact; all others are removed, each divided by its divisor.
///
/// With symbols in the equations the result is the slow flow of the coordinates as formulas, free or driven.
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration resonance spring_pendulum --set kappa=3
  libration resonance spring_pendulum --set kappa=3 --order 5 \\
    --initial r=1.3733,theta=0.04
  libration resonance double_pendulum --json
  libration resonance \"x'' = x - x^3\" --about x=1
  libration resonance \"x'' = -x - x*y; y'' = -4.1*y - x^2/2\" --order 4 \\
    --initial x=0.1,y=0.02 --figure exchange.svg
  libration resonance \"x''+w1^2*x+eps*a*x*y=0; y''+w2^2*y+eps*b*x^2=0\" \\
    --ratios 1:2
  libration resonance \"x''+x+eps*x*y=0; y''+4*y+eps*x^2=0\" --ratios 1:2 \\
    --format python > slow_flow.py

Slow flow with symbols: each coordinate is its amplitude times a cosine near its
natural frequency, and terms of other frequencies. --ratios are those of the
natural frequencies, --resonance P/Q is the drive's over that of the first
coordinate; small differences are called sigma. Coupling, damping and resonant
drives must be small.

With --initial the exchange from this state is found by the slow flow, in closed
form where it is one of two modes at 2:1, and by integration of the whole motion,
whose mean frequencies are exact.")
)]
pub(crate) struct ResonanceQuestion {
    #[command(flatten)]
    system: SystemOptions,
    #[command(flatten)]
    equilibrium: EquilibriumOptions,
    #[command(flatten)]
    initial: InitialOptions,
    /// Highest order in the amplitudes [default: 3], or with symbols in the small parameters [default: the largest of these, and at
    /// least one at which all terms without small parameter act]
    #[arg(long, value_name = "N", value_parser = count::<LARGEST_ORDER>)]
    order: Option<usize>,
    /// Small parameters with their orders, of equations with symbols, such as a:1,mu:2 [default: eps, if it occurs]
    #[arg(long, value_name = "NAME:ORDER,…")]
    small: Option<String>,
    /// Approximate ratios of the natural frequencies of equations with symbols, such as 1:2 [default: those implied by equal symbols or
    /// numbers]
    #[arg(long, value_name = "N:N…")]
    ratios: Option<String>,
    /// Resonance of a drive cos(W*t) in equations with symbols: W = (P/Q)·ω, over the natural frequency of the first
    /// coordinate
    #[arg(long, value_name = "P/Q")]
    resonance: Option<String>,
    /// Divisors below this fraction of the least frequency count as resonances
    #[arg(long, value_name = "PART", default_value = "0.1", value_parser = part)]
    detuning: f64,
    /// Draw the amplitudes in time to FILE.svg, .pdf, .png or .json instead of listing the terms; needs --initial
    #[arg(long, value_name = "FILE", value_parser = figure::file::drawable, requires = "initial")]
    figure: Option<PathBuf>,
    #[command(flatten)]
    layout: figure::Layout,
    #[command(flatten)]
    formats: FormatOptions,
    #[command(flatten)]
    form: FormOptions,
}

/// Default order of a normal form: the lowest at which frequencies change with the amplitudes.
const USUAL_ORDER: usize = 3;

/// The result to write.
struct ResonanceResult {
    model: Model,
    form: NormalForm,
    initial: Option<Vec<f64>>,
    exchange: Option<Result<(Exchange, MeasuredExchange), ExchangeError>>,
}

impl ResonanceQuestion {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        if self.has_letters()? {
            return self.answer_with_letters(out);
        }
        if let Some(given) = self.formats.given() {
            let reason = "it writes the formulas of a slow flow with symbols: leave out the value of a parameter, or give <--ratios> or <--small>";
            return Err(QueryError::usage(option(given), reason));
        }
        let model = self.system.model()?;
        let initial = match self.initial.is_given() {
            true => Some(self.initial.read(&model)?.state),
            false => None,
        };
        let guess = self.equilibrium.guess(&model)?;
        let order = self.order.unwrap_or(USUAL_ORDER);
        interrupt::listen()?;
        let answer = parallel::unless_cancelled("the normal form", |progress| {
            let form = NormalForm::about(model.equation(), &guess, order, self.detuning, progress)?;
            let exchange = initial.as_ref().map(|state| {
                let exchange = form.exchange(state, progress)?;
                let measured = form.measured_exchange(model.equation(), state, &exchange, progress)?;
                Ok((exchange, measured))
            });
            Ok(ResonanceResult { model, form, initial, exchange })
        });
        let early =
            || QueryError::cancelled("interrupted before the normal form was known: nothing is written");
        let answer = answer.ok_or_else(early)?.map_err(failure)?;
        let drawn = figure::file::drawn(self.figure.as_deref(), &self.layout, || {
            Ok(figure::resonance::amplitudes(&answer.shown()?))
        })?;
        answer.write(out, self.form.form(), drawn.is_empty())?;
        Ok(announce(out, self.form.form(), &drawn)?)
    }
}

impl ResonanceResult {
    /// The time range of the picture: two exchanges, or forty periods if there is no exchange.
    fn shown(&self) -> Result<ModeAmplitudes<'_>, QueryError> {
        const PERIODS: f64 = 40.0;
        const SAMPLES: usize = 240;
        let missing =
            || QueryError::usage(option("figure"), "it shows a motion: give its start by <--initial>");
        let state = self.initial.as_ref().ok_or_else(missing)?;
        let none = |error: ExchangeError| QueryError::no_result(option("initial"), error);
        let slowest = self.form.modes.modes.iter().map(|mode| mode.frequency()).fold(f64::INFINITY, f64::min);
        let span = match &self.exchange {
            Some(Ok((exchange, _))) => 2.0 * exchange.period,
            _ => PERIODS * std::f64::consts::TAU / slowest,
        };
        let interval = span / crate::output::number::count(SAMPLES);
        let seen = self.form.seen_path(self.model.equation(), state, interval, SAMPLES, &Quiet);
        let seen = seen.map_err(none)?;
        let slow = self.form.slow_path(&seen[0], interval, SAMPLES, &Quiet).map_err(none)?;
        Ok(ModeAmplitudes { model: &self.model, initial: state, interval, slow, seen })
    }
}

fn failure(error: NormalFormError) -> QueryError {
    match error {
        NormalFormError::Order(_) => QueryError::usage(option("order"), error),
        _ => QueryError::no_result(argument("SYSTEM|EQUATION"), error),
    }
}
