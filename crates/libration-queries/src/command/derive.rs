//! `libration derive`: worked derivations, every formula checked.

use super::expand::{BOOKKEEPING, slow_flow_failure};
use crate::arguments::{
    self, ChosenWithLetters, EquationText, OscillatorOptions, PendulumOptions, drive_resonance, small_orders,
};
use crate::output::file;
use crate::query_error::{QueryError, argument, option};
use crate::{interrupt, parallel};
use libration::expression::Equation;
use libration::internals::progress::Watch;
use libration::oscillator::NumbersOrLetters;
use libration::pendulum::Amplitude;
use libration::perturbation::{Gauge, SlowFlowError, SymbolicSlowFlowOptions};
use libration::progress::{Progress, Status};
use libration::quantity::Displacement;
use libration_derivation::{
    Derivation, DerivationError, HIGHEST_DAMPING_ORDER, HIGHEST_ORDER, Released, Swing, averaging,
    limit_cycle, perturbation, slow_flow,
};
use std::io::Write;
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};

/// A worked derivation, step by step, with each formula checked by computing it
///
/// Each formula is followed by how it was checked: exactly in fractions, or to 77 digits at several amplitudes. With --amplitude each step also shows its numbers for that pendulum.
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration derive --method elliptic > period.md
  libration derive --method elliptic --amplitude 40deg --length 1m \\
    --format html --output period.html
  libration derive --method short --format html --output first.html
  libration derive --method formulas --format latex --output formulas.tex
  libration derive --method perturbation --order 7 --amplitude 60deg \\
    --format html --output series.html
  libration derive --method perturbation quadratic --order 4 --gauge A1=1,A2=1/2
  libration derive --method perturbation quadratic --format ipynb \\
    --output quadratic.ipynb
  libration derive --method perturbation \"x'' + w^2*x + b*x^3 = 0\" --order 3
  libration derive --method perturbation \"x'' + x + x*abs(x) = 0\" --order 4
  libration derive --method averaging --set n=2 --order 5 --damping-order 2 \\
    --format html --output damping.html
  libration derive --method averaging --resonance 1/1 \\
    \"x'' + 2*eps*mu*x' + w0^2*x + eps*a*x^3 = eps*F*cos(W*t)\"
  libration derive --method limit-cycle van_der_pol --order 4 --format ipynb \\
    --output van_der_pol.ipynb
  libration derive --method elliptic --exercises --format html \\
    --output exercises.html
  libration derive --method short --answer \"3.1=omega0^2*(1 - theta0^2/8)\"
  libration derive --method perturbation \"x'' + x + 0.1*x^3 = 0\" --amplitude 0.5")
)]
pub(crate) struct Derive {
    /// The derivation
    #[arg(long, alias = "road", value_enum)]
    method: Method,
    #[command(flatten)]
    series: SeriesOptions,
    /// Show the numbers at this amplitude, such as 40deg; for other oscillators, a plain number
    #[arg(long, value_parser = arguments::displacement)]
    amplitude: Option<Displacement>,
    #[command(flatten)]
    pendulum: PendulumOptions,
    /// Leave out the results, as exercises, and give them as solutions at the end
    #[arg(long)]
    exercises: bool,
    /// Compare an answer to an exercise: the number of the formula, and the formula for its question mark, such as
    /// `3.1=omega0^2*(1-theta0^2/8)`
    #[arg(long, value_name = "NUMBER=FORMULA")]
    answer: Option<String>,
    /// Format of the derivation
    #[arg(long, value_enum, default_value = "markdown")]
    format: DerivationFormat,
    /// Write to this file instead of standard output
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// Options of the methods with series alone.
#[derive(Debug, clap::Args)]
struct SeriesOptions {
    /// Series: a key of the catalogue, such as duffing, or an equation [default: pendulum, for averaging `damped_pendulum`, for limit-cycle `van_der_pol`]
    #[arg(value_name = "OSCILLATOR|EQUATION")]
    oscillator: Option<EquationText>,
    /// Series: the highest power of the expansion parameter or amplitude, up to 9 [default: 5, of a limit cycle 4]
    #[arg(long, value_parser = arguments::count::<HIGHEST_ORDER>)]
    order: Option<usize>,
    /// Averaging: the highest power of the small parameter, 1 to 4 [default: 2]; with several symbols or a drive 1 or 2 [default: the lowest that acts, and that of each symbol]
    #[arg(long, value_parser = arguments::count::<HIGHEST_DAMPING_ORDER>)]
    damping_order: Option<usize>,
    /// Averaging, limit-cycle: the small symbol, if several have no value, or small symbols with orders, such as mu:1,F:1
    #[arg(long, value_name = "LETTER|SYMBOLS")]
    small: Option<String>,
    /// Averaging: the resonance of a drive with W = (P/Q)·ω0, drive over natural frequency
    #[arg(long, value_name = "P/Q")]
    resonance: Option<String>,
    /// Perturbation: meaning of the expansion parameter, such as energy or A1=1,A3=-1 [default: fundamental]
    #[arg(long)]
    gauge: Option<Gauge>,
    /// Series: the value of a parameter; may be given several times
    #[arg(long, value_name = "NAME=VALUE")]
    set: Vec<String>,
    /// Perturbation: the equilibrium, if there are several
    #[arg(long, value_name = "X")]
    about: Option<String>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Method {
    /// The exact period: energy, elliptic integral, series, mean
    Elliptic,
    /// Two pages for a first course: from sin θ ≈ θ − θ³/6 to T ≈ T0 (1 + θ0²/16)
    Short,
    /// Origin of the published formulas for the period
    Formulas,
    /// Motion and period of a free oscillator, order by order; parameters may stay symbols
    Perturbation,
    /// Amplitude and phase under weak damping or excitation, power by power; with several symbols or a drive, to products of two small terms, in lowest order with steady states
    #[value(alias = "damping")]
    Averaging,
    /// Amplitude, frequency and form of a limit cycle, in powers of its excitation
    LimitCycle,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum DerivationFormat {
    /// Markdown with formulas in LaTeX
    Markdown,
    /// A document for pdflatex
    Latex,
    /// A self-contained page with formulas in MathML
    Html,
    /// A Jupyter notebook, whose cells check each formula again with Python's fractions and floats
    Ipynb,
}

impl Derive {
    pub(crate) fn answer(&self, out: &mut dyn Write) -> Result<(), QueryError> {
        let (derivation, is_whole) = self.derivation()?;
        let are_exercises = self.exercises || self.answer.is_some();
        let derivation = if are_exercises { derivation.exercises() } else { derivation };
        let derivation = if is_whole { derivation } else { derivation.broken_off() };
        let text = match &self.answer {
            Some(answer) => self.judgement(answer, &derivation)?,
            None => self.format.write(&derivation),
        };
        match &self.output {
            Some(path) => {
                file::write(path, text.as_bytes())?;
                writeln!(out, "{} written: {}", path.display(), derivation.title)?;
            }
            None => out.write_all(text.as_bytes())?,
        }
        out.flush()?;
        match is_whole {
            true => Ok(()),
            false => Err(QueryError::cancelled("interrupted: the steps up to then are written")),
        }
    }

    /// The judgement of an answer to one of the exercises.
    fn judgement(&self, text: &str, exercises: &Derivation) -> Result<String, QueryError> {
        let refused = |reason: String| QueryError::usage(option("answer"), reason);
        let (number, answer) = text.split_once('=').ok_or_else(|| {
            refused(format!(
                "`{text}`: give the number of a formula and an answer, such as 3.1=omega0^2*(1-theta0^2/8)"
            ))
        })?;
        let judgement = exercises.judge(number.trim(), answer).map_err(|error| refused(error.to_string()))?;
        match self.format {
            DerivationFormat::Markdown => Ok(libration_derivation::judgement_to_markdown(&judgement)),
            DerivationFormat::Html => Ok(libration_derivation::judgement_to_html(&judgement)),
            DerivationFormat::Latex | DerivationFormat::Ipynb => {
                let reason = "the judgement of an answer is in Markdown or HTML: leave it out";
                Err(QueryError::usage(option("format"), reason))
            }
        }
    }

    /// The derivation, and whether it came to its end.
    fn derivation(&self) -> Result<(Derivation, bool), QueryError> {
        if self.amplitude.is_none() && !self.pendulum.is_default() {
            let reason =
                "<--length> and <--gravity> show their numbers at an amplitude: add <--amplitude=40deg>";
            return Err(QueryError::misuse(reason));
        }
        self.series.refuse(self.method)?;
        let derivation = match self.method {
            Method::Perturbation => return self.perturbation(),
            Method::Averaging => return self.averaging(),
            Method::LimitCycle => return self.limit_cycle(),
            Method::Elliptic => libration_derivation::elliptic,
            Method::Short => libration_derivation::first_correction,
            Method::Formulas => libration_derivation::formulas,
        };
        derivation(self.swing()?.as_ref()).map(|derivation| (derivation, true)).map_err(failure)
    }

    /// The swing for which numbers are requested, if there is one.
    fn swing(&self) -> Result<Option<Swing>, QueryError> {
        let Some(displacement) = &self.amplitude else { return Ok(None) };
        let angle = displacement.to_angle();
        let angle = angle
            .ok_or_else(|| QueryError::usage(option("amplitude"), "give an angle of at most 2^53 rad"))?;
        let amplitude =
            Amplitude::new(angle).map_err(|error| QueryError::no_result(option("amplitude"), error))?;
        Ok(Some(Swing { pendulum: self.pendulum.pendulum()?, amplitude }))
    }

    fn perturbation(&self) -> Result<(Derivation, bool), QueryError> {
        let options = &self.series;
        let name = options.oscillator.as_deref().unwrap_or(PENDULUM);
        let chosen = OscillatorOptions::new(name, &options.set, options.about.as_deref());
        let (oscillator, key) = match chosen.chosen_with_letters(&[])? {
            Ok(ChosenWithLetters::Numbers(named)) => (NumbersOrLetters::Numbers(named.oscillator), named.key),
            Ok(ChosenWithLetters::Letters(named)) => (NumbersOrLetters::Letters(named.oscillator), named.key),
            Err(error) => return Err(arguments::no_oscillator(error)),
        };
        let is_pendulum = key == Some(PENDULUM) && options.set.is_empty();
        if !is_pendulum && !self.pendulum.is_default() {
            let reason = "<--length> and <--gravity> belong to the pendulum: leave them out";
            return Err(QueryError::misuse(reason));
        }
        let frequency = if is_pendulum { Some(self.pendulum.pendulum()?.angular_frequency()) } else { None };
        let released =
            self.amplitude.clone().map(|amplitude| Released { amplitude, angular_frequency: frequency });
        let gauge = options.gauge.clone().unwrap_or_default();
        let order = options.order.unwrap_or(DEFAULT_ORDER);
        cancellable(|progress| perturbation(oscillator.clone(), order, &gauge, released.as_ref(), progress))
    }

    fn averaging(&self) -> Result<(Derivation, bool), QueryError> {
        self.refuse_amplitude("averaging gives laws for all small amplitudes")?;
        if let Some(asked) = self.series.with_symbols()? {
            return self.slow_flow(asked);
        }
        let options = &self.series;
        let name = options.oscillator.as_deref().unwrap_or(DAMPED_PENDULUM);
        let small = options.small.as_deref();
        let asked = OscillatorOptions::new(name, &options.set, None);
        let asked = asked.asked_of_system(small).unwrap_or_else(|| asked.asked())?;
        let order = options.order.unwrap_or(DEFAULT_ORDER);
        let damping_order = options.damping_order.unwrap_or(DEFAULT_DAMPING_ORDER);
        cancellable(|progress| averaging(&asked.equation, small, order, damping_order, progress))
    }

    fn limit_cycle(&self) -> Result<(Derivation, bool), QueryError> {
        self.refuse_amplitude("a limit cycle has one amplitude, which is derived")?;
        if let Some(asked) = self.series.with_symbols()? {
            return self.slow_flow(asked);
        }
        let options = &self.series;
        let name = options.oscillator.as_deref().unwrap_or(SELF_EXCITED);
        let asked = OscillatorOptions::new(name, &options.set, None).asked()?;
        let order = options.order.unwrap_or(DEFAULT_CYCLE_ORDER);
        let small = options.small.as_deref();
        cancellable(|progress| limit_cycle(&asked.equation, small, order, progress))
    }

    fn slow_flow(&self, (equation, asked): WithSymbols) -> Result<(Derivation, bool), QueryError> {
        let options = &self.series;
        if options.order.is_some() {
            let reason = "with several symbols or a drive powers are counted in small parameters: give <--damping-order=2> for the products of two";
            return Err(QueryError::usage(option("order"), reason));
        }
        let asked = SymbolicSlowFlowOptions { order: options.damping_order, ..asked };
        cancellable(|progress| slow_flow(&equation, &asked, progress))
    }

    fn refuse_amplitude(&self, reason: &str) -> Result<(), QueryError> {
        let reason = format!("{reason}: leave it out, or simulate the motion by <libration simulate>");
        if self.amplitude.is_some() { Err(QueryError::usage(option("amplitude"), reason)) } else { Ok(()) }
    }
}

/// A derivation; `true` with it if it is complete, `false` if it is cancelled.
fn cancellable(
    derive: impl Fn(&dyn Progress) -> Result<Derivation, DerivationError> + Sync,
) -> Result<(Derivation, bool), QueryError> {
    interrupt::listen()?;
    let done = AtomicUsize::new(0);
    let how_far = || format!("{} parts of the derivation are done", done.load(Ordering::Relaxed));
    parallel::with_progress(how_far, || {
        let progress = |status: Status| {
            done.store(status.done, Ordering::Relaxed);
            parallel::update(&how_far)
        };
        let watch = Watch::new(&progress);
        let outcome = derive(&watch);
        outcome.map(|derivation| (derivation, !watch.is_stopped())).map_err(failure)
    })
}

const PENDULUM: &str = "pendulum";
const DAMPED_PENDULUM: &str = "damped_pendulum";
const SELF_EXCITED: &str = "van_der_pol";
const DEFAULT_ORDER: usize = 5;
const DEFAULT_CYCLE_ORDER: usize = 4;
const DEFAULT_DAMPING_ORDER: usize = 2;

fn failure(error: DerivationError) -> QueryError {
    let remedies = error.remedies();
    let refused = match error {
        DerivationError::Amplitude { .. }
        | DerivationError::NotAnAmplitude(_)
        | DerivationError::NoNumbers => QueryError::no_result(option("amplitude"), error),
        DerivationError::Order { .. }
        | DerivationError::AmplitudeOrder { .. }
        | DerivationError::CycleOrder { .. } => QueryError::usage(option("order"), error),
        DerivationError::DampingOrder { .. } => QueryError::usage(option("damping-order"), error),
        DerivationError::SlowFlow(SlowFlowError::WhichIsSmall { .. }) => {
            QueryError::usage(option("small"), format!("{error}, such as <--small> c"))
        }
        DerivationError::SlowFlow(SlowFlowError::UnknownParameter { .. }) => {
            QueryError::usage(option("small"), error)
        }
        DerivationError::Symbolic(error) => return slow_flow_failure(&error),
        DerivationError::Interrupted(_) => {
            QueryError::cancelled("interrupted before the first step: nothing is written")
        }
        error => QueryError::no_result("derivation", error),
    };
    refused.with_remedies(&remedies)
}

/// An equation with several symbols or a drive, and its small parameters.
type WithSymbols = (Equation, SymbolicSlowFlowOptions);

impl SeriesOptions {
    /// The equation if it has several symbols without value or a drive, or if a resonance or small parameters with orders are given.
    fn with_symbols(&self) -> Result<Option<WithSymbols>, QueryError> {
        let resonance = self.resonance.as_deref().map(drive_resonance).transpose()?;
        let small = self.small.as_deref();
        let is_forced = resonance.is_some() || small.is_some_and(|small| small.contains([':', ',']));
        let Some(text) = &self.oscillator else {
            return match is_forced {
                true => Err(QueryError::misuse("give the equation of the oscillator")),
                false => Ok(None),
            };
        };
        let equation = match OscillatorOptions::new(text, &self.set, None).asked() {
            Ok(asked) => asked.equation,
            Err(error) if is_forced => return Err(error),
            Err(_) => return Ok(None),
        };
        let open = equation.parameters();
        let is_marked = open.contains(BOOKKEEPING) || small.is_some_and(|name| open.contains(name));
        if is_forced || equation.depends_on_time() || (open.len() > 1 && is_marked) {
            let small = small.map(small_orders).transpose()?.unwrap_or_default();
            return Ok(Some((equation, SymbolicSlowFlowOptions { small, resonance, ..Default::default() })));
        }
        Ok(None)
    }

    /// Refuses options that belong to other methods.
    fn refuse(&self, method: Method) -> Result<(), QueryError> {
        const SERIES: &[Method] = &[Method::Perturbation, Method::Averaging, Method::LimitCycle];
        let given = [
            (argument("OSCILLATOR|EQUATION"), self.oscillator.is_some(), SERIES),
            (option("order"), self.order.is_some(), SERIES),
            (option("set"), !self.set.is_empty(), SERIES),
            (option("gauge"), self.gauge.is_some(), &[Method::Perturbation]),
            (option("about"), self.about.is_some(), &[Method::Perturbation]),
            (option("damping-order"), self.damping_order.is_some(), &[Method::Averaging]),
            (option("resonance"), self.resonance.is_some(), &[Method::Averaging]),
            (option("small"), self.small.is_some(), &[Method::Averaging, Method::LimitCycle]),
        ];
        match given.iter().find(|(_, given, methods)| *given && !methods.contains(&method)) {
            Some((name, _, methods)) => {
                let names: Vec<&str> = methods.iter().map(|method| method.name()).collect();
                let reason =
                    format!("is for {} {} only: leave it out", option("method"), names.join(" and "));
                Err(QueryError::usage(name, reason))
            }
            None => Ok(()),
        }
    }
}

impl Method {
    fn name(self) -> &'static str {
        match self {
            Self::Elliptic => "elliptic",
            Self::Short => "short",
            Self::Formulas => "formulas",
            Self::Perturbation => "perturbation",
            Self::Averaging => "averaging",
            Self::LimitCycle => "limit-cycle",
        }
    }
}

impl DerivationFormat {
    fn write(self, derivation: &Derivation) -> String {
        match self {
            Self::Markdown => libration_derivation::to_markdown(derivation),
            Self::Latex => libration_derivation::to_latex(derivation),
            Self::Html => libration_derivation::to_html(derivation),
            Self::Ipynb => libration_derivation::to_notebook(derivation),
        }
    }
}
