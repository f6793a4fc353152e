//! `libration expand`: exact perturbation series of any oscillator.

mod code;
mod evaluate;
mod fields;
mod letters;
mod listing;
mod mathml;
mod scaling_law;
pub(crate) mod slow_flow;
mod subject;
mod write;

use crate::arguments::{self, Asked, Chosen, ChosenWithLetters, OscillatorOptions};
use crate::output::description::Answers;
use crate::output::number::short;
use crate::output::series::{Coefficient, certainty, radius_certainty};
use crate::output::{Form, FormOptions};
use crate::parallel::until_asked;
use crate::query_error::{QueryError, option};
use crate::{call, interrupt, parallel};
use code::Language;
use libration::algebra::Rational;
use libration::comparison::{SeriesComparison, SeriesQuantity};
use libration::expression::Equation;
use libration::oscillator::{Kind, Oscillator};
use libration::perturbation::{
    Expansion, ExpansionError, Gauge, MAX_ORDER, MAX_PARAMETER_ORDER, expand_watched, expand_with_pi_watched,
};
use libration::quantity::is_angle_name;
use libration::watch::{Progress, Stage, Watch};
use std::io::Write;
use std::sync::Mutex;
use subject::{About, Subject};

/// Exact series for an oscillator's frequency, harmonics and period, to any order
///
/// Periodic motions are expanded by Lindstedt and Poincaré's method in a parameter ε whose meaning, the gauge, can be
/// chosen; frequency, period and harmonics are also given as functions of the amplitude, which is the same in every
/// gauge. Self-excited oscillators with an open parameter, such as `van_der_pol`, are expanded in that parameter.
/// Other parameters without a value stay letters: the coefficients are then polynomials in them.
///
/// A force in proportion to one power of the displacement, such as x^3 or x*abs(x), has no small oscillations to expand about; the answer is
/// then its scaling law, Ω = C·√k·A^((p−1)/2) with the exact C, and its harmonics, which are the same at all amplitudes.
///
/// Under weak damping or excitation, whose strength stays a letter, the answer is the slow flow: A′, how the amplitude changes, and ψ′,
/// how the phase runs, as polynomials in the amplitude and the letter, with the motion x(A, ψ). Powers of the velocity may be even,
/// x'*abs(x'), and zero, sign(x'). Where a limit cycle has no expansion in an open strength, the slow flow is the answer without being asked for.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
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
  libration list oscillators                    # the built-in ones

Gauges: fundamental (ε is the coefficient of cos Ωt, of sin Ωt where the force
is the opposite at -x with the same velocity), x_max, half_swing,
energy (ε = √(2E)/ω0), nome (pendulum, ε = 8√q), or the coefficients of
a₁ = A₁ε + A₂ε² + …, such as A1=1,A3=-1. In a slow flow A is x_max, where
the motion turns, or fundamental, the coefficient of cos ψ.

Letters: parameters of a typed equation that --set gives no value, and those of
a built-in one that --letters names. Roots are those for positive letters; where
ω0² is a sum, a name for ω0 stays in the coefficients.

What --evaluate leaves out is below a proven bound where there is one. Elsewhere it
is an estimate, which is too small in about 1 of 100 cases, at order 5 and below
in about 2 of 100.

Ctrl-C stops a long computation and writes the orders that are certain by then.")]
pub(crate) struct Expand {
    #[command(flatten)]
    oscillator: OscillatorOptions,
    /// Parameters of a built-in oscillator that stay letters, with commas between
    #[arg(long, value_name = "NAME,…", value_delimiter = ',')]
    letters: Vec<String>,
    /// The highest power of the expansion parameter [default: 7; 31 with --evaluate, 15 where no powers vanish]
    #[arg(long, value_parser = arguments::count::<MAX_ORDER>)]
    order: Option<usize>,
    /// Meaning of the expansion parameter [default: fundamental, of a slow flow `x_max`]
    #[arg(long)]
    gauge: Option<Gauge>,
    /// Give the slow flow under weak damping or excitation to this power of its strength [default: 2]
    #[arg(long, value_name = "POWER", value_parser = arguments::count::<MAX_PARAMETER_ORDER>, conflicts_with_all = ["evaluate", "letters"])]
    damping_order: Option<usize>,
    /// The letter that is this strength, where several have no value; the strength left open of a named system
    #[arg(long, value_name = "NAME", conflicts_with_all = ["evaluate", "letters"])]
    small: Option<String>,
    /// Evaluate the series term by term at this amplitude, the largest displacement from the equilibrium, such as 0.5,
    /// or 40deg where the variable is an angle; for a limit cycle, at this value of its parameter
    #[arg(long, value_name = "AMPLITUDE", conflicts_with = "latex")]
    evaluate: Option<String>,
    /// The quantity to evaluate: period (T/T0), frequency (Ω/ω0), or a harmonic, such as a3, the coefficient of cos 3Ωt
    /// or sin 3Ωt
    #[arg(long, default_value = "period", requires = "evaluate")]
    quantity: SeriesQuantity,
    /// Write LaTeX
    #[arg(long, conflicts_with_all = ["json", "csv"])]
    latex: bool,
    /// Write formulas or functions of a programming language
    #[arg(long, value_enum, conflicts_with_all = ["json", "csv", "latex", "evaluate"])]
    format: Option<Format>,
    #[command(flatten)]
    form: FormOptions,
}

/// Formats of an expansion besides tables, JSON and CSV.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Format {
    /// The same as --latex
    Latex,
    /// Formulas in MathML, one a line
    Mathml,
    /// Functions in C
    C,
    /// Functions in Python
    Python,
    /// Functions in Rust
    Rust,
    /// A module in Fortran 2008
    Fortran,
}

impl Format {
    fn language(self) -> Option<Language> {
        match self {
            Self::Latex | Self::Mathml => None,
            Self::C => Some(Language::C),
            Self::Python => Some(Language::Python),
            Self::Rust => Some(Language::Rust),
            Self::Fortran => Some(Language::Fortran),
        }
    }
}

/// The order to which an expansion is listed.
const LISTED: usize = 7;
/// The order to which an expansion is evaluated.
const EVALUATED: usize = 31;
/// The same where no powers vanish, so that there are as many terms.
const EVALUATED_OF_TWO_SIDES: usize = 15;

/// An expansion with the words for it.
struct Answer<C = Rational> {
    subject: Subject,
    is_angle: bool,
    /// Letters and constants, where parameters are letters.
    letters: Option<Letters<C>>,
    expansion: Expansion<C>,
    /// The order that was asked for, when Ctrl-C was pressed before it was reached.
    interrupted: Option<usize>,
}

impl<C> Letters<C> {
    /// The names for constants that do not say themselves what they are, as π does.
    fn explained(&self) -> impl Iterator<Item = &(String, String)> {
        self.constants.iter().filter(|(name, constant)| name != constant)
    }
}

/// The letters of an expansion, and ω0 by them.
struct Letters<C> {
    names: Vec<String>,
    /// Names in the coefficients for constants that are no products of letters.
    constants: Vec<(String, String)>,
    omega0: String,
    /// Symbol of ω0 in the coefficients.
    omega0_name: Option<String>,
    /// Coefficients of Ω by powers of the variable, where ω0 is a product of letters.
    frequency: Option<Vec<C>>,
}

pub(crate) fn answers() -> Vec<Answers> {
    vec![fields::answers(), evaluate::answers(), slow_flow::answers(), scaling_law::answers()]
}

impl Expand {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        interrupt::listen()?;
        if let Some(asked) = self.slow_flow()? {
            return self.answer_slow_flow(out, asked);
        }
        if let Some(answer) = scaling_law::Answer::of(self.oscillator.asked_with_letters(&self.letters)?) {
            return self.answer_scaling_law(out, answer);
        }
        let chosen = match self.evaluate {
            None => match self.oscillator.chosen_with_letters(&self.letters)? {
                Ok(chosen) => chosen,
                Err(error) => return self.slow_flow_or(out, arguments::no_oscillator(error)),
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
                    "with letters nothing is known of how far the series converge".to_owned()
                })?;
                answer.missing_orders()
            }
        };
        out.flush()?;
        missing.map_or(Ok(()), |missing| Err(QueryError::cancelled(format!("interrupted: {missing}"))))
    }

    /// Writes the slow flow, with a note, if an open parameter is the strength of a force that has no expansion as a limit cycle, but has a slow
    /// flow.
    fn slow_flow_or(&self, out: &mut dyn Write, refused: QueryError) -> Result<(), QueryError> {
        let is_written =
            self.format.and_then(Format::language).is_none() && self.format != Some(Format::Mathml);
        if self.evaluate.is_some() || !is_written {
            return Err(refused);
        }
        let mut answer = vec![];
        match self.oscillator.asked().and_then(|asked| self.answer_slow_flow(&mut answer, asked)) {
            Ok(()) => {}
            Err(interrupted) if interrupted.is_cancelled() => return Err(interrupted),
            Err(_) => return Err(refused),
        }
        call::current().note(
            "there is no expansion as a limit cycle; this is the slow flow (--damping-order), how the amplitude changes",
        );
        Ok(out.write_all(&answer)?)
    }

    /// Writes the answer, and tells what it lacks when Ctrl-C was pressed; an error where the slow flow may be the answer.
    fn answer_in_numbers(
        &self,
        out: &mut dyn Write,
        chosen: Chosen,
    ) -> Result<Result<Option<String>, ExpansionError>, QueryError> {
        let amplitude =
            self.evaluate.as_ref().map(|text| chosen.amplitude(&option("evaluate"), text)).transpose()?;
        let usual = match (&amplitude, chosen.oscillator.kind()) {
            (None, _) => LISTED,
            (Some(_), Kind::TwoSided) => EVALUATED_OF_TWO_SIDES,
            (Some(_), _) => EVALUATED,
        };
        let order = self.order.unwrap_or(usual);
        let oscillator = chosen.oscillator.clone();
        if amplitude.is_none() && self.format.and_then(Format::language).is_none() {
            let exact = with_orders_shown(order, |watch| {
                expand_with_pi_watched(&oscillator, order, &self.gauge(), watch)
            });
            if let Some(expansion) = exact.map_err(refusal)? {
                let equation = oscillator.equation();
                self.write(out, &Answer::about(equation, chosen, expansion, None, None), String::new)?;
                return Ok(Ok(None));
            }
        }
        let answer = match expanded(&chosen.oscillator, order, &self.gauge()) {
            Ok(expansion) => Answer::new(chosen, expansion, None),
            Err(ExpansionError::Interrupted { known: Some(known) }) => {
                Answer::new(chosen, *known, Some(order))
            }
            Err(error @ ExpansionError::NotPolynomial) => return Ok(Err(error)),
            Err(error) => return Err(refusal(error)),
        };
        if let Some(amplitude) = amplitude {
            return evaluate::write(out, self.form.form(), &answer, &oscillator, self.quantity, &amplitude)
                .map(Ok);
        }
        self.write(out, &answer, || validity(&oscillator, &answer.expansion))?;
        Ok(Ok(answer.missing_orders()))
    }

    /// The gauge: the definition of the expansion parameter.
    fn gauge(&self) -> Gauge {
        self.gauge.clone().unwrap_or(Gauge::Fundamental)
    }

    /// The equation whose slow flow is asked for, by an option or by a key that only damped systems have.
    fn slow_flow(&self) -> Result<Option<Asked>, QueryError> {
        match self.oscillator.asked_of_system(self.small.as_deref()) {
            Some(asked) => asked.map(Some),
            None if self.damping_order.is_some() || self.small.is_some() => self.oscillator.asked().map(Some),
            None => Ok(None),
        }
    }

    fn answer_slow_flow(&self, out: &mut dyn Write, asked: Asked) -> Result<(), QueryError> {
        if self.evaluate.is_some() {
            let reason =
                "the slow flow is not a series at one amplitude: simulate the motion by <libration simulate>";
            return Err(QueryError::usage(option("evaluate"), reason));
        }
        let latex = match self.format {
            None => self.latex,
            Some(Format::Latex) => true,
            Some(_) => {
                return Err(QueryError::usage(
                    option("format"),
                    "a slow flow is written as text, latex, JSON or CSV",
                ));
            }
        };
        let order = self.order.unwrap_or(LISTED);
        let gauge = self.gauge.clone().unwrap_or(Gauge::XMax);
        let orders = [order, self.damping_order.unwrap_or(slow_flow::DAMPING_ORDER)];
        let answer = slow_flow::Answer::new(asked, self.small.as_deref(), orders, &gauge)?;
        slow_flow::write(out, self.form.form(), latex, &answer)?;
        Ok(out.flush()?)
    }

    fn answer_scaling_law(&self, out: &mut dyn Write, answer: scaling_law::Answer) -> Result<(), QueryError> {
        let latex = match self.format {
            None => self.latex,
            Some(Format::Latex) => true,
            Some(_) => {
                let reason = "a scaling law is written as text, latex, JSON or CSV";
                return Err(QueryError::usage(option("format"), reason));
            }
        };
        let answer = match &self.evaluate {
            None => answer,
            Some(text) => answer.at(text)?,
        };
        scaling_law::write(out, self.form.form(), latex, &answer)?;
        Ok(out.flush()?)
    }

    fn write<C: Coefficient>(
        &self,
        out: &mut dyn Write,
        answer: &Answer<C>,
        validity: impl Fn() -> String,
    ) -> Result<(), QueryError> {
        if let Some(language) = self.format.and_then(Format::language) {
            return Ok(code::write(out, answer, language, &validity())?);
        }
        match self.form.form() {
            Form::Json => write::write_json(out, answer)?,
            Form::Csv => write::write_csv(out, answer)?,
            Form::Table if self.format == Some(Format::Mathml) => mathml::write(out, answer)?,
            Form::Table if self.latex || self.format == Some(Format::Latex) => {
                listing::write_latex(out, answer)?;
            }
            Form::Table => listing::write(out, answer)?,
        }
        Ok(())
    }
}

fn refusal(error: ExpansionError) -> QueryError {
    match error {
        ExpansionError::Interrupted { .. } => {
            QueryError::cancelled("interrupted before any order was certain")
        }
        error => QueryError::no_result("expansion", &error).with_remedies(&error.remedies()),
    }
}

/// The range of convergence of the period's series, as far as it is known.
fn validity(oscillator: &Oscillator, expansion: &Expansion) -> String {
    let relation = SeriesComparison::new(oscillator, expansion, SeriesQuantity::Period);
    let radius = until_asked("the radius of convergence", |_| relation.radius()).flatten();
    let variable = if expansion.variable.is_strength() { "strengths" } else { "amplitudes" };
    match radius {
        None => format!("how far the series converge is not known; they are for small {variable}"),
        Some(radius) if radius.value().is_infinite() => {
            format!("the series of the period converges for all {variable}")
        }
        Some(radius) => {
            let certainty = certainty(radius_certainty(&radius));
            let below = short(radius.value(), 6);
            format!(
                "the series of the period converges for {variable} below {below} ({certainty}), slowly near it"
            )
        }
    }
}

fn expanded(oscillator: &Oscillator, order: usize, gauge: &Gauge) -> Result<Expansion, ExpansionError> {
    with_orders_shown(order, |watch| expand_watched(oscillator, order, gauge, watch))
}

/// The result of a computation, with a line of progress while it takes long, until Ctrl-C is pressed.
fn with_orders_shown<T: Send>(order: usize, compute: impl FnOnce(&Watch<'_>) -> T + Send) -> T {
    let latest = Mutex::new(None);
    let how_far = || latest.lock().ok().and_then(|latest| *latest).map_or_else(String::new, in_words);
    let how_far = || format!("order {order}: {}", how_far());
    let ask = |progress| {
        if let Ok(mut latest) = latest.lock() {
            *latest = Some(progress);
        }
        parallel::go_on(&how_far)
    };
    parallel::with_progress(how_far, || compute(&Watch::new(&ask)))
}

fn in_words(Progress { stage, done: order, .. }: Progress) -> String {
    match stage {
        Stage::Prime { done } => format!("{done} primes done, order {order} modulo the next"),
        Stage::Fractions { primes } => format!("fractions from {primes} primes"),
        Stage::Floats { bits } => format!("order {order} with {bits} bits"),
        _ => format!("checking order {order}"),
    }
}

impl<C> About for Answer<C> {
    fn subject(&self) -> &Subject {
        &self.subject
    }
}

impl Answer {
    fn new(chosen: Chosen, expansion: Expansion, interrupted: Option<usize>) -> Self {
        let equation = chosen.oscillator.equation().clone();
        Self::about(&equation, chosen, expansion, None, interrupted)
    }
}

impl<C> Answer<C> {
    fn about<O>(
        equation: &Equation,
        chosen: Chosen<O>,
        expansion: Expansion<C>,
        letters: Option<Letters<C>>,
        interrupted: Option<usize>,
    ) -> Self {
        let Chosen { key, title, values, read_as, .. } = chosen;
        let subject = Subject::new(equation, (key, title), values, read_as);
        Self { is_angle: is_angle_name(&subject.variable), subject, letters, expansion, interrupted }
    }

    /// The frequency itself, where it is not Ω/ω0.
    fn frequency(&self) -> Option<&[C]> {
        let letters = self.letters.as_ref()?;
        letters.frequency.as_deref().filter(|_| letters.omega0 != "1")
    }

    /// A statement of the orders that were complete when Ctrl-C was pressed during the expansion.
    fn missing_orders(&self) -> Option<String> {
        let asked = self.interrupted?;
        let order = self.expansion.order;
        let is_certain = order < asked && self.letters.is_none();
        let left = if is_certain { "which is certain" } else { "which is not checked by another road" };
        Some(format!("order {order} of {asked}, {left}, is written"))
    }
}
