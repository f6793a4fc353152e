//! `libration expand`: exact perturbation series of any oscillator.

mod answer;
mod code;
mod evaluate;
mod fields;
mod letters;
mod listing;
mod mathml;
mod numbers;
mod scaling_law;
pub(crate) mod slow_flow;
mod subject;
mod symbolic_flow;
mod write;

use crate::arguments::{self, ChosenWithLetters, OscillatorOptions};
use crate::interrupt;
use crate::output::description::Answers;
use crate::output::language::{Format, FormatOptions};
use crate::output::series::Coefficient;
use crate::output::{Form, FormOptions};
use crate::query_error::QueryError;
use answer::ExpandResult;
use libration::comparison::SeriesQuantity;
use libration::perturbation::{Gauge, MAX_ORDER, MAX_PARAMETER_ORDER};
use numbers::refusal;
use std::io::Write;

pub(super) use symbolic_flow::failure as slow_flow_failure;

/// Exact series for an oscillator's frequency, harmonics and period, to any order
///
/// Periodic motions are expanded by Lindstedt and Poincaré's method in a parameter ε whose meaning, the gauge, can be
/// chosen; frequency, period and harmonics are also given as functions of the amplitude, which is the same in every
/// gauge. Self-excited oscillators with an open parameter, such as `van_der_pol`, are expanded in that parameter.
/// Other parameters without a value are symbolic: the coefficients are then polynomials in them.
///
/// A force in proportion to one power of the displacement, such as x^3 or x*abs(x), has no small oscillations to expand about; the result is
/// then its scaling law, Ω = C·√k·A^((p−1)/2) with the exact C, and its harmonics, which are the same at all amplitudes.
///
/// Under weak damping or excitation of symbolic strength, the result is the slow flow: A′, the rate of the amplitude, and ψ′, the rate
/// of the phase, as polynomials in the amplitude and the strength, with the motion x(A, ψ). Powers of the velocity may be even,
/// x'*abs(x'), and zero, sign(x'). Where a limit cycle has no expansion in a symbolic strength, the slow flow is the result without --damping-order too.
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration expand pendulum --order 7
  libration expand pendulum --order 9 --gauge A1=1,A3=-1
  libration expand \"x'' + x + 0.1*x^3 = 0\" --order 5 --latex
  libration expand quadratic --order 6 --gauge half_swing
  libration expand van_der_pol --order 8 --json
  libration expand pendulum --evaluate 40deg    # T/T0 term by term
  libration expand duffing --set epsilon=0.1 --evaluate 2 --quantity a3
  libration expand \"x'' + w^2*x + a*x^2 + b*x^3 = 0\" --order 5
  libration expand \"x'' + w^2*x + a*x^2 + b*x^3 = 0\" --set b=0 --latex
  libration expand \"x'' + 3*x*x' + x^3 + x = 0\"   # every period is the same
  libration expand \"x'' + x + x*abs(x) = 0\" --order 3   # powers of pi
  libration expand \"x'' + k*x*abs(x) = 0\"         # a scaling law
  libration expand \"x'' = a*x - b*x^3\" --about \"sqrt(a/b)\" --order 4
  libration expand \"\\ddot{x} + \\omega^2 x + \\alpha x^3 = 0\" --order 3
  libration expand cubic_quintic --letters alpha,beta --json
  libration expand duffing --letters epsilon --order 9 --format c > duffing.c
  libration expand damped_pendulum --set n=2 --order 5 --damping-order 2
  libration expand \"x'' + c*(x^2 - 1)*x' + x + x^3 = 0\" --damping-order 3
  libration expand \"x'' + eps*(m*x' + a*x^3) + x = eps*cos(W*t)\" --resonance 1/1
  libration expand \"x''+m*x'+x+x^2=F*cos(W*t)\" --resonance 1/1 --small m:2,F:2
  libration list oscillators                    # the built-in ones

Gauges: fundamental (ε is the coefficient of cos Ωt, of sin Ωt where the force
is the opposite at -x with the same velocity), x_max, half_swing,
energy (ε = √(2E)/ω0), nome (pendulum, ε = 8√q), or the coefficients of
a₁ = A₁ε + A₂ε² + …, such as A1=1,A3=-1. In a slow flow A is x_max, where
the motion turns, or fundamental, the coefficient of cos ψ.

Symbols: parameters of a typed equation that --set gives no value, and those of
a built-in one that --letters names. Roots are those for positive symbols; where
ω0² is a sum, a name for ω0 stays in the coefficients.

Slow flow with symbols: --resonance P/Q is drive over natural frequency, as
W = (P/Q)·ω0 + eps·sigma; A and phi are those of x = A*cos((Q/P)*W*t + phi) and
terms of other frequencies. Where the small parameters and W have values by
--set, or W by --evaluate, steady states are given in numbers, to compare with
libration response --orders Q/P.

What --evaluate leaves out is below a proven bound where there is one. Elsewhere it
is an estimate, which is too small in about 1 of 100 cases, at order 5 and below
in about 2 of 100.

Ctrl-C stops a long computation and writes the orders confirmed by then.")
)]
pub(crate) struct Expand {
    #[command(flatten)]
    oscillator: OscillatorOptions,
    /// Symbolic parameters of a built-in oscillator, separated by commas
    #[arg(long, value_name = "NAME,…", value_delimiter = ',')]
    letters: Vec<String>,
    /// The highest power of the expansion parameter [default: 7; 31 with --evaluate, 15 if no powers vanish]
    #[arg(long, value_parser = arguments::count::<MAX_ORDER>)]
    order: Option<usize>,
    /// Meaning of the expansion parameter [default: fundamental, of a slow flow `x_max`]
    #[arg(long)]
    gauge: Option<Gauge>,
    /// Give the slow flow under weak damping or excitation to this power of its strength [default: 2]
    #[arg(long, value_name = "POWER", value_parser = arguments::count::<MAX_PARAMETER_ORDER>, conflicts_with_all = ["evaluate", "letters"])]
    damping_order: Option<usize>,
    /// The symbol of this strength, if several have no value or the system is a named one; for a slow flow with symbols, small
    /// parameters with their orders, such as a2:1,a3:2,mu:2,F:2 [default: eps, if it occurs]
    #[arg(long, value_name = "NAME:ORDER,…", conflicts_with = "letters")]
    small: Option<String>,
    /// Give the slow flow of a driven oscillator near W = (P/Q)·ω0, drive over natural frequency: 1/1 primary, 1/3
    /// superharmonic, 3/1 subharmonic resonance
    #[arg(long, value_name = "P/Q", conflicts_with_all = ["damping_order", "letters", "gauge"])]
    resonance: Option<String>,
    /// Evaluate the series term by term at this amplitude, the largest displacement from the equilibrium, such as 0.5, or 40deg if the
    /// variable is an angle; for a limit cycle, at this value of its parameter
    #[arg(long, value_name = "AMPLITUDE", conflicts_with_all = ["latex", "format"])]
    evaluate: Option<String>,
    /// The quantity to evaluate: period (T/T0), frequency (Ω/ω0), or a harmonic, such as a3, the coefficient of cos 3Ωt
    /// or sin 3Ωt
    #[arg(long, default_value = "period", requires = "evaluate")]
    quantity: SeriesQuantity,
    #[command(flatten)]
    formats: FormatOptions,
    #[command(flatten)]
    form: FormOptions,
}

/// Order up to which an expansion is listed.
const LISTED: usize = 7;

/// The small parameter if none is named.
pub(super) const BOOKKEEPING: &str = "eps";

pub(crate) fn answers() -> Vec<Answers> {
    // Where several options of these are given, the first names the fields.
    let series = [fields::answers(), symbolic_flow::answers(), evaluate::answers()];
    series.into_iter().chain([slow_flow::answers(), scaling_law::answers()]).collect()
}

impl Expand {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        interrupt::listen()?;
        if self.is_symbolic_flow() {
            return self.answer_symbolic_flow(out);
        }
        if let Some(asked) = self.slow_flow()? {
            return self.answer_slow_flow(out, asked);
        }
        if let Some(answer) =
            scaling_law::ScalingLawResult::of(self.oscillator.asked_with_letters(&self.letters)?)
        {
            return self.answer_scaling_law(out, answer);
        }
        let chosen = match self.evaluate {
            None => match self.oscillator.chosen_with_letters(&self.letters) {
                Ok(Ok(chosen)) => chosen,
                Ok(Err(error)) => return self.slow_flow_or(out, arguments::no_oscillator(error)),
                Err(refused) => return self.symbolic_flow_or(out, refused),
            },
            // A value takes the values of all parameters.
            Some(_) => ChosenWithLetters::Numbers(self.oscillator.chosen_without(&self.letters)?),
        };
        let missing = match chosen {
            ChosenWithLetters::Numbers(chosen) => match self.answer_in_numbers(out, chosen)? {
                Ok(missing) => missing,
                Err(error) => return self.slow_flow_or(out, refusal(error)),
            },
            ChosenWithLetters::Letters(chosen) => {
                let answer = letters::answer(chosen, self.order.unwrap_or(LISTED), &self.gauge())?;
                self.write(out, &answer, || {
                    "with symbols, the radius of convergence of the series is not known".to_owned()
                })?;
                answer.missing_orders()
            }
        };
        out.flush()?;
        missing.map_or(Ok(()), |missing| Err(QueryError::cancelled(format!("interrupted: {missing}"))))
    }

    /// The gauge: the definition of the expansion parameter.
    fn gauge(&self) -> Gauge {
        self.gauge.clone().unwrap_or(Gauge::Fundamental)
    }

    fn write<C: Coefficient>(
        &self,
        out: &mut dyn Write,
        answer: &ExpandResult<C>,
        validity: impl Fn() -> String,
    ) -> Result<(), QueryError> {
        let format = self.formats.format();
        if let Some(language) = format.and_then(Format::language) {
            return Ok(code::write(out, answer, language, &validity())?);
        }
        match (self.form.form(), format) {
            (Form::Json, _) => write::write_json(out, answer)?,
            (Form::Csv, _) => write::write_csv(out, answer)?,
            (Form::Table, Some(Format::Mathml)) => mathml::write(out, answer)?,
            (Form::Table, Some(_)) => listing::write_latex(out, answer)?,
            (Form::Table, None) => listing::write(out, answer)?,
        }
        Ok(())
    }
}
