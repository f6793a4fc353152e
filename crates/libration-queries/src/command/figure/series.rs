//! `libration figure series`: errors of partial sums of a series.

use super::PictureOptions;
use crate::arguments::{self, Chosen, OscillatorOptions};
use crate::figure::chart::Picture;
use crate::figure::series::{Abscissa, ErrorCurve, SeriesSetting, against_amplitude, against_terms};
use crate::output::number::count;
use crate::output::series::{subscript, superscript};
use crate::query_error::{Parameter, QueryError, option};
use crate::{interrupt, parallel};
use libration::comparison::{ExactValue, ExactValueError, Radius, SeriesComparison, SeriesQuantity};
use libration::oscillator::Oscillator;
use libration::perturbation::{Expansion, Gauge, MAX_ORDER, SeriesEvaluation, expand};
use libration::progress::{Progress, Status};
use libration::quantity::Displacement;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The error of a perturbation series against the amplitude, with its radius of convergence, or against the number of terms
#[derive(Debug, clap::Args)]
#[cfg_attr(
    not(target_arch = "wasm32"),
    command(after_help = "Examples:
  libration figure series pendulum --output series.svg
  libration figure series duffing --amplitudes 0.5,0.9,1.1 --order 41 \\
    --output terms.png
  libration figure series van_der_pol --quantity frequency --output limit.svg")
)]
pub(super) struct Series {
    #[command(flatten)]
    oscillator: OscillatorOptions,
    /// The order of the expansion; partial sums are shown up to the powers 2, 4, 8, … below it
    #[arg(long, default_value = "33", value_parser = arguments::count::<MAX_ORDER>)]
    order: usize,
    /// The quantity that is expanded: period (T/T0), frequency (Ω/ω0), or a harmonic, such as a3
    #[arg(long, default_value = "period")]
    quantity: SeriesQuantity,
    /// Plot the error against the highest power of the partial sum instead, at these amplitudes, such as 30deg,90deg,150deg
    #[arg(long, value_name = "A,A", value_delimiter = ',', conflicts_with = "to")]
    amplitudes: Vec<String>,
    /// The largest amplitude shown [default: a fifth beyond the radius of convergence]
    #[arg(long, value_name = "AMPLITUDE")]
    to: Option<String>,
    /// The smallest error shown
    #[arg(long, default_value = "1e-14", value_parser = arguments::positive)]
    lowest: f64,
    #[command(flatten)]
    pub(super) options: PictureOptions,
}

/// The largest amplitude shown where no radius of convergence is known.
const UNKNOWN_RADIUS: f64 = 2.0;
/// Largest amplitude of the picture, in radii of convergence.
const BEYOND: f64 = 1.2;
/// Largest amplitude of the picture, in units of the last motion's or of the radius of convergence, whichever is larger.
const END: f64 = 1.02;
/// The error at the top.
const HIGHEST: f64 = 10.0;
/// Amplitudes at which a curve is computed.
const SAMPLES: u32 = 240;
/// Halves of the first step: the error of one correction, a fourth power, falls to 2⁻²⁴ of what it is there, below 1e-16 for the pendulum.
const HALVES: usize = 6;
/// More curves than a picture can keep apart.
const MOST_AMPLITUDES: usize = 12;

impl Series {
    pub(super) fn picture(&self) -> Result<Picture, QueryError> {
        if self.lowest >= HIGHEST {
            return Err(QueryError::no_result(
                option("lowest"),
                format!("{} is not below {HIGHEST}", self.lowest),
            ));
        }
        let chosen = self.oscillator.chosen()?;
        interrupt::listen()?;
        let subject = SeriesSubject {
            oscillator: chosen.oscillator.clone(),
            expansion: self.expansion(&chosen)?,
            quantity: self.quantity,
        };
        let (relation, expansion) = (subject.relation(), &subject.expansion);
        let powers = powers(&relation);
        if powers.is_empty() {
            let reason = format!(
                "the {} does not change with the amplitude to this order: give a higher <--order>, or another oscillator",
                self.quantity
            );
            return Err(QueryError::no_result(option("quantity"), reason));
        }
        let setting = setting(&chosen, expansion, self.quantity, self.lowest);
        if self.amplitudes.is_empty() {
            self.in_amplitude(&chosen, &subject, &powers, setting)
        } else {
            self.in_terms(&chosen, &subject, setting)
        }
    }

    fn expansion(&self, chosen: &Chosen) -> Result<Expansion, QueryError> {
        let order = self.order;
        let expansion = parallel::unless_cancelled(&format!("the series to order {order}"), |progress| {
            expand(&chosen.oscillator, order, &Gauge::Fundamental, progress)
        });
        expansion
            .ok_or_else(early)?
            .map_err(|error| QueryError::no_result("expansion", &error).with_remedies(&error.remedies()))
    }

    fn in_amplitude(
        &self,
        chosen: &Chosen,
        subject: &SeriesSubject,
        powers: &[usize],
        setting: SeriesSetting,
    ) -> Result<Picture, QueryError> {
        let relation = &subject.relation();
        let radius = relation.radius().filter(|radius| radius.value().is_finite());
        let to = match &self.to {
            Some(text) => positive(chosen, &option("to"), text)?.to_f64(),
            None => BEYOND * radius.map_or(UNKNOWN_RADIUS, |radius| radius.value()),
        };
        let sampled = subject.sampled(to);
        if sampled.is_empty() && interrupt::is_cancelled() {
            return Err(early());
        }
        if sampled.is_empty() {
            let reason = "there is no motion at these amplitudes: give a smaller <--to>";
            return Err(QueryError::no_result("figure series", reason));
        }
        let lines = lines(relation, &sampled, powers, &setting);
        let radius = radius.map(|radius| (radius.value(), radius_label(&radius)));
        let last = sampled.last().map_or(0.0, |sample| sample.amplitude);
        let to = to.min(END * f64::max(last, radius.map_or(0.0, |(radius, _)| radius)));
        Ok(against_amplitude(&lines, radius, to, &setting))
    }

    fn in_terms(
        &self,
        chosen: &Chosen,
        subject: &SeriesSubject,
        setting: SeriesSetting,
    ) -> Result<Picture, QueryError> {
        if self.amplitudes.len() > MOST_AMPLITUDES {
            let reason = format!("{} are too many: give at most {MOST_AMPLITUDES}", self.amplitudes.len());
            return Err(QueryError::usage(option("amplitudes"), reason));
        }
        let mut lines = vec![];
        let relation = subject.relation();
        for text in &self.amplitudes {
            let displacement = positive(chosen, &option("amplitudes"), text)?;
            let amplitude = displacement.to_f64();
            let Some(exact) = subject.exact_at(&displacement) else { break };
            let exact = exact.map_err(|error| no_exact(text, &error))?;
            let evaluation = relation.evaluation_at(amplitude);
            let errors = evaluation
                .steps()
                .iter()
                .filter_map(|step| Some((count(step.power), resolved_error(step.sum, &exact)?)));
            lines.push(ErrorCurve {
                family: "amplitude",
                label: format!("{} = {}", setting.abscissa.symbol, setting.abscissa.shown(amplitude)),
                errors: errors.collect(),
            });
        }
        if lines.is_empty() { Err(early()) } else { Ok(against_terms(&lines, &setting)) }
    }
}

/// The error of a run cancelled before there is anything to draw.
fn early() -> QueryError {
    QueryError::cancelled("interrupted before the first error was known: nothing is drawn")
}

/// The subject of the picture.
struct SeriesSubject {
    oscillator: Oscillator,
    expansion: Expansion,
    quantity: SeriesQuantity,
}

impl SeriesSubject {
    fn relation(&self) -> SeriesComparison<'_> {
        SeriesComparison::new(&self.oscillator, &self.expansion, self.quantity)
    }

    fn exact_at(&self, amplitude: &Displacement) -> Option<Result<ExactValue, ExactValueError>> {
        let relation = self.relation();
        parallel::unless_cancelled("the exact values", |progress| relation.exact_from(amplitude, progress))
    }

    /// Even steps from zero to the amplitude at which motions end or enclose another equilibrium; the first one is halved, so that errors run down to
    /// the axis.
    fn sampled(&self, to: f64) -> Vec<AmplitudeSample> {
        let (relation, done) = (self.relation(), AtomicUsize::new(0));
        let step = to / f64::from(SAMPLES);
        let halves = std::iter::successors(Some(0.5 * step), |half| Some(0.5 * half)).take(HALVES);
        let mut amplitudes: Vec<f64> = halves.collect();
        amplitudes.reverse();
        amplitudes.extend((1..=SAMPLES).map(|number| step * f64::from(number)));
        let how_far =
            || format!("{} of at most {} amplitudes", done.load(Ordering::Relaxed), amplitudes.len());
        let sample = || {
            let progress = |_: Status| parallel::update(&how_far);
            let counted = amplitudes.iter().copied().inspect(|_| {
                done.fetch_add(1, Ordering::Relaxed);
            });
            counted.map_while(|amplitude| AmplitudeSample::at(&relation, amplitude, &progress)).collect()
        };
        parallel::with_progress(how_far, sample)
    }
}

/// The errors of the partial sums, and of a Padé approximant for comparison.
fn lines(
    relation: &SeriesComparison<'_>,
    sampled: &[AmplitudeSample],
    powers: &[usize],
    setting: &SeriesSetting,
) -> Vec<ErrorCurve> {
    /// Degrees of the approximant, as far as the order allows.
    const DEGREES: [usize; 4] = [8, 6, 4, 2];
    let line = |family: &'static str, label: String, value: &dyn Fn(&AmplitudeSample) -> f64| {
        let error = |sample: &AmplitudeSample| {
            Some((sample.amplitude, resolved_error(value(sample), &sample.exact)?))
        };
        ErrorCurve { label, family, errors: sampled.iter().filter_map(error).collect() }
    };
    let symbol = &setting.abscissa.symbol;
    let mut lines: Vec<ErrorCurve> = powers
        .iter()
        .map(|&power| {
            let label = format!("to {symbol}{}", superscript(power));
            line("partial sum", label, &|sample| sum_to(&sample.evaluation, power))
        })
        .collect();
    let entry = DEGREES.into_iter().find_map(|degree| Some((degree, relation.approximant(degree)?)));
    if let Some((degree, approximant)) = entry {
        let label = format!("Padé [{degree}/{degree}]");
        lines.push(line("Padé", label, &|sample| approximant.value_at(sample.amplitude)));
    }
    lines
}

fn no_exact(text: &str, reason: &ExactValueError) -> QueryError {
    QueryError::no_result(option("amplitudes"), format!("{}: {reason}", text.trim()))
}

fn positive(chosen: &Chosen, argument: &Parameter, text: &str) -> Result<Displacement, QueryError> {
    let amplitude = chosen.amplitude(argument, text)?;
    if amplitude.to_f64() > 0.0 {
        return Ok(amplitude);
    }
    Err(QueryError::usage(argument, format!("`{}`: give an amplitude above zero", text.trim())))
}

fn setting(chosen: &Chosen, expansion: &Expansion, quantity: SeriesQuantity, lowest: f64) -> SeriesSetting {
    let abscissa = if expansion.variable.is_strength() {
        Abscissa {
            symbol: expansion.variable.name().replace("mu", "μ"), name: "strength", in_degrees: false
        }
    } else {
        let symbol = if chosen.is_angle() { "θ₀" } else { "A" }.to_owned();
        Abscissa { symbol, name: "amplitude", in_degrees: chosen.is_angle() }
    };
    let quantity = match quantity {
        SeriesQuantity::Period => "T/T₀".to_owned(),
        SeriesQuantity::Frequency => "Ω/ω₀".to_owned(),
        SeriesQuantity::Cosine(k) => format!("a{}", subscript(k)),
    };
    let title = match chosen.key {
        Some(_) => chosen.title.clone(),
        None => chosen.oscillator.equation().to_string(),
    };
    SeriesSetting { title, quantity, abscissa, lowest, highest: HIGHEST }
}

/// The last powers of the partial sums: 2, 4, 8, … and the last one, if each adds much to the one before.
fn powers(relation: &SeriesComparison<'_>) -> Vec<usize> {
    let present: Vec<usize> =
        (1..relation.series().len()).filter(|n| !relation.series()[*n].is_zero()).collect();
    let doubled = std::iter::successors(Some(2), |power: &usize| power.checked_mul(2));
    let end = present.last().copied().unwrap_or(0);
    let mut powers: Vec<usize> = doubled
        .take_while(|power| 3 * *power <= 2 * end)
        .filter_map(|power| present.iter().copied().rfind(|n| *n <= power))
        .chain(present.last().copied())
        .collect();
    powers.dedup();
    powers
}

/// The error of a value, if it exceeds the uncertainty of the exact value.
fn resolved_error(value: f64, exact: &ExactValue) -> Option<f64> {
    Some(value - exact.value).filter(|error| error.abs() > exact.uncertainty)
}

/// An amplitude with the exact value there.
struct AmplitudeSample {
    amplitude: f64,
    exact: ExactValue,
    evaluation: SeriesEvaluation,
}

impl AmplitudeSample {
    fn at(relation: &SeriesComparison<'_>, amplitude: f64, progress: &dyn Progress) -> Option<Self> {
        let exact = relation.exact_at(amplitude, progress).ok().filter(|exact| exact.encloses.is_none())?;
        Some(Self { amplitude, exact, evaluation: relation.evaluation_at(amplitude) })
    }
}

/// The sum of the terms up to a power.
fn sum_to(evaluation: &SeriesEvaluation, power: usize) -> f64 {
    let kept = evaluation.steps().iter().take_while(|step| step.power <= power);
    kept.last().map_or(f64::NAN, |step| step.sum)
}

fn radius_label(radius: &Radius) -> &'static str {
    match radius {
        Radius::Known(_) => "radius of convergence",
        Radius::Estimated(_) => "radius of convergence, estimated",
    }
}
