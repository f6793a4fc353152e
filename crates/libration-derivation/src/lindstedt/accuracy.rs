//! Accuracy of the series at an amplitude.

use super::super::check::DerivationError;
use super::super::document::{DerivationStep, DerivationTable};
use super::super::formula::{Decimal, DecimalUnit, Formula, Name, letter, number, rounded};
use super::super::prose::Prose;
use super::Released;
use super::amplitude::of_amplitude;
use super::names::harmonic_name;
use super::question::LindstedtQuestion;
use libration::algebra::{Polynomial, Rational};
use libration::comparison::{ExactMotion, ExactValue, ExactValueError, SeriesQuantity};
use libration::internals::progress::Watch;
use libration::oscillator::Oscillator;
use libration::perturbation::{
    Certainty, Gauge, Remainder, SeriesEvaluation, expand, pendulum_period_remainder,
};
use libration::progress::Quiet;
use libration::quantity::{Displacement, is_angle_name};

/// The order up to which the remainder is estimated.
const LONGER: usize = 31;
/// The amplitude when none is given.
const EXAMPLE: f64 = 1.0;

pub(super) fn step(
    question: &LindstedtQuestion,
    released: Option<&Released>,
    watch: &Watch<'_>,
) -> Result<Option<DerivationStep>, DerivationError> {
    let Some(oscillator) = &question.oscillator else {
        return if released.is_some() { Err(DerivationError::NoNumbers) } else { Ok(None) };
    };
    let exactly = amplitude_of(released)?;
    let amplitude = exactly.to_f64();
    if !(amplitude > 0.0 && amplitude.is_finite()) {
        return Err(DerivationError::NotAnAmplitude(amplitude));
    }
    let Some(exact) = exactly_at(question, &exactly, watch) else { return Ok(None) };
    watch.go_on()?;
    let step = DerivationStep::new("accuracy", "Accuracy")
        .say("At an amplitude of {} the terms of the period are", [as_given(question, &exactly)])
        .table(terms(question, oscillator, amplitude, &exact)?);
    let Some(released) = released else { return Ok(Some(step)) };
    let step = step
        .say("and with all of them the motion is", [])
        .table(motion(question, released, &exact)?)
        .say(
            "Where the last terms do not fall, the series has come to its end at this amplitude, and no further order helps: \
             the radius of convergence, a result of the expansion, tells where.",
            [],
        );
    Ok(Some(step))
}

/// An amplitude as given: in degrees, radians, or as a plain number.
pub fn as_given(question: &LindstedtQuestion, amplitude: &Displacement) -> Formula {
    let radians = || match is_angle(question) {
        true => Decimal::short(amplitude.to_f64(), DecimalUnit::Radian),
        false => Decimal::short(amplitude.to_f64(), DecimalUnit::One),
    };
    let degrees = amplitude.degrees().filter(|_| is_angle(question));
    Formula::Decimal(degrees.map_or_else(radians, |degrees| Decimal::short(degrees, DecimalUnit::Degree)))
}

/// The given amplitude, or the example.
pub(super) fn amplitude_of(released: Option<&Released>) -> Result<Displacement, DerivationError> {
    let given = released.map(|released| released.amplitude.clone());
    given.or_else(|| Displacement::from_f64(EXAMPLE)).ok_or(DerivationError::NotAnAmplitude(EXAMPLE))
}

pub(super) fn is_angle(question: &LindstedtQuestion) -> bool {
    is_angle_name(question.symbolic.variable())
}

/// Returns `true` if the exact period is known in closed form: for the pendulum below the upright position.
fn is_pendulum(question: &LindstedtQuestion, amplitude: f64) -> bool {
    let sine: Vec<Rational> = (1..=question.force.len()).map(sine_coefficient).collect();
    is_angle(question) && question.force == sine && amplitude < std::f64::consts::PI
}

fn sine_coefficient(n: usize) -> Rational {
    if n.is_multiple_of(2) {
        return Rational::from(0);
    }
    let factorial =
        (2..=n).fold(1_i64, |product, i| product.saturating_mul(i64::try_from(i).unwrap_or(i64::MAX)));
    Rational::new(if n % 4 == 1 { 1 } else { -1 }, factorial).unwrap_or_else(|| Rational::from(0))
}

/// The partial sums of T/T0.
fn terms(
    question: &LindstedtQuestion,
    oscillator: &Oscillator,
    amplitude: f64,
    motion: &Exactly,
) -> Result<DerivationTable, DerivationError> {
    let pendulum = is_pendulum(question, amplitude);
    let longer = expand(oscillator, LONGER, &Gauge::Fundamental, &Quiet)?.of_amplitude;
    let series = longer.map_or_else(Vec::new, |of| of.period_ratio);
    let evaluation = SeriesEvaluation::new(&series, amplitude);
    let evaluation = if pendulum {
        evaluation.with_bound(|n| pendulum_period_remainder(amplitude, n / 2))
    } else {
        evaluation
    };
    let period = exact(motion, SeriesQuantity::Period);
    let exact = period.as_ref().ok().map(|exact| exact.value);
    let rows = evaluation.steps().iter().filter(|step| step.power < question.order).map(|step| {
        let mut row = vec![
            Prose::formula(number(i64::try_from(step.power).unwrap_or(i64::MAX))),
            Prose::formula(rounded(step.term, 6, DecimalUnit::One)),
            Prose::formula(rounded(step.sum, 10, DecimalUnit::One)),
            rest(step.remainder),
        ];
        row.extend(exact.map(|exact| Prose::formula(rounded(step.sum / exact - 1.0, 2, DecimalUnit::One))));
        row
    });
    let rows = rows.collect();
    let mut head = ["power", "term", "sum", "rest"].map(Prose::text).to_vec();
    head.extend(exact.map(|_| Prose::text("error")));
    let basis = if pendulum {
        "the rest is proved to be below the bound given".to_owned()
    } else {
        format!("the rest is estimated from the terms to the power {LONGER}")
    };
    Ok(DerivationTable::numbers(head, rows, note(&basis, &period)))
}

/// The note on the basis of the remainders and the errors.
fn note(basis: &str, period: &Result<ExactValue, ExactValueError>) -> Prose {
    let exact = match period {
        Err(reason) => return Prose::text(format!("{basis}; there is no exact value: {reason}")),
        Ok(exact) => exact,
    };
    let note = Prose::text(format!("{basis}; errors are relative to the exact "))
        .and(Prose::formula(rounded(exact.value, 11, DecimalUnit::One)))
        .and(Prose::text(", right to "))
        .and(Prose::formula(rounded(exact.uncertainty, 1, DecimalUnit::One)));
    match exact.encloses {
        None => note,
        Some(equilibrium) => note
            .and(Prose::text(", of a motion that goes around another equilibrium too, at "))
            .and(Prose::formula(rounded(equilibrium, 6, DecimalUnit::One)))
            .and(Prose::text(", and is not what the series is for")),
    }
}

fn rest(remainder: Remainder) -> Prose {
    if !remainder.size.is_finite() {
        return Prose::text("no bound");
    }
    let word = if remainder.certainty == Certainty::Proven { "below " } else { "about " };
    Prose::text(word).and(Prose::formula(rounded(remainder.size, 2, DecimalUnit::One)))
}

/// ε, the frequency, the period and the harmonics at the amplitude, compared with those of the exact motion.
pub fn motion(
    question: &LindstedtQuestion,
    released: &Released,
    exact_motion: &Exactly,
) -> Result<DerivationTable, DerivationError> {
    let of = of_amplitude(question, &question.solution)?;
    let amplitude = released.amplitude.to_f64();
    let number = |c: &Polynomial| c.to_constant().map_or(f64::NAN, |c| c.to_f64());
    let value = |series: &[Polynomial], powers: usize| {
        series.iter().take(powers).rev().fold(0.0, |sum, c| sum * amplitude + number(c))
    };
    let unit = if is_angle(question) { DecimalUnit::Radian } else { DecimalUnit::One };
    let exactly = |quantity| exact(exact_motion, quantity).ok().map(|exact| exact.value);
    let ratio = value(&of.period_ratio, question.order);
    let exact_ratio = exactly(SeriesQuantity::Period);
    let mut rows = vec![
        (letter("ε"), value(&of.epsilon, question.order + 1), None, DecimalUnit::One),
        (
            letter("Δ"),
            value(&of.frequency_ratio, question.order),
            exact_ratio.map(f64::recip),
            DecimalUnit::One,
        ),
        (letter("T") / Formula::from(Name::new("T").index(0)), ratio, exact_ratio, DecimalUnit::One),
    ];
    if let Some(frequency) = released.angular_frequency {
        let small = 2.0 * std::f64::consts::PI / frequency;
        rows.push((letter("T"), ratio * small, exact_ratio.map(|ratio| ratio * small), DecimalUnit::Second));
    }
    for (k, series) in of.harmonics.iter().filter(|(k, _)| *k <= question.order) {
        let exact = exactly(SeriesQuantity::Cosine(*k));
        rows.push((harmonic_name(*k).into(), value(series, question.order + 1), exact, unit));
    }
    let cell = |value: f64, unit| Prose::formula(rounded(value, 8, unit));
    let row = |(name, value, exact, unit): (Formula, f64, Option<f64>, DecimalUnit)| {
        let exact = exact.map_or_else(|| Prose::text(""), |exact| cell(exact, unit));
        vec![Prose::formula(name), cell(value, unit), exact]
    };
    let head = ["quantity", "series", "exact"].map(Prose::text).into();
    let note = Prose::text(
        "series to the order derived; exact: by elliptic functions for the pendulum, else the equation of motion integrated in time",
    );
    Ok(DerivationTable::numbers(head, rows.into_iter().map(row).collect(), note))
}

/// The motion without the series: in closed form for the pendulum, otherwise by integration in time.
type Exactly = Result<ExactMotion, ExactValueError>;

/// The exact motion at an amplitude; `None` for an oscillator with symbols.
pub fn exactly_at(
    question: &LindstedtQuestion,
    amplitude: &Displacement,
    watch: &Watch<'_>,
) -> Option<Exactly> {
    let (oscillator, expansion) = (question.oscillator.as_ref()?, question.solution.numbers.as_ref()?);
    Some(ExactMotion::new(oscillator, expansion, amplitude, watch))
}

fn exact(motion: &Exactly, quantity: SeriesQuantity) -> Result<ExactValue, ExactValueError> {
    motion.as_ref().map_err(Clone::clone)?.value(quantity)
}
