//! How good the series are at an amplitude.

use super::super::check::DerivationError;
use super::super::document::{Prose, Step, Table};
use super::super::formula::{Decimal, Formula, Name, Unit, letter, number, rounded};
use super::Released;
use super::amplitude::of_amplitude;
use super::ansatz::harmonic_name;
use super::question::Question;
use crate::algebra::Rational;
use crate::oscillator::PeriodicMotion;
use crate::pendulum::period_ratio;
use crate::perturbation::{Certainty, Evaluation, Gauge, Remainder, expand, pendulum_period_remainder};
use crate::quantity::is_angle_name;

/// The order to which what is missing is estimated.
const LONGER: usize = 31;
/// The amplitude when none is given.
pub(super) const EXAMPLE: f64 = 1.0;

pub(super) fn step(question: &Question, released: Option<&Released>) -> Result<Step, DerivationError> {
    let amplitude = released.map_or(EXAMPLE, |released| released.amplitude);
    if !(amplitude > 0.0 && amplitude.is_finite()) {
        return Err(DerivationError::NotAnAmplitude(amplitude));
    }
    let unit = if is_angle(question) { Unit::Radian } else { Unit::One };
    let step = Step::new("How good it is")
        .say(
            "At an amplitude of {} the terms of the period are",
            [Formula::Decimal(Decimal::short(amplitude, unit))],
        )
        .table(terms(question, amplitude)?);
    let Some(released) = released else { return Ok(step) };
    Ok(step
        .say("and with all of them the motion is", [])
        .table(motion(question, released)?)
        .say(
            "Where the last terms do not fall, the series has come to its end at this amplitude, and no further order helps: \
             the command libration expand tells where it stops converging.",
            [],
        ))
}

pub(super) fn is_angle(question: &Question) -> bool {
    is_angle_name(question.oscillator.variable())
}

/// Whether the exact period is known: the pendulum below the upright position.
fn is_pendulum(question: &Question, amplitude: f64) -> bool {
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
fn terms(question: &Question, amplitude: f64) -> Result<Table, DerivationError> {
    let pendulum = is_pendulum(question, amplitude);
    let longer = expand(&question.oscillator, LONGER, &Gauge::Fundamental)?.of_amplitude;
    let series = longer.map_or_else(Vec::new, |of| of.period_ratio);
    let evaluation = Evaluation::new(&series, amplitude);
    let evaluation = if pendulum {
        evaluation.with_bound(|n| pendulum_period_remainder(amplitude, n / 2))
    } else {
        evaluation
    };
    let exact = Exact::new(question, amplitude).map(|exact| exact.ratio);
    let rows = evaluation.steps().iter().filter(|step| step.power < question.order).map(|step| {
        let mut row = vec![
            Prose::formula(number(i64::try_from(step.power).unwrap_or(i64::MAX))),
            Prose::formula(rounded(step.term, 6, Unit::One)),
            Prose::formula(rounded(step.sum, 10, Unit::One)),
            rest(step.remainder),
        ];
        row.extend(exact.map(|exact| Prose::formula(rounded(step.sum / exact - 1.0, 2, Unit::One))));
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
    let note = match exact {
        Some(exact) => Prose::text(format!("{basis}; errors are relative to the exact "))
            .and(Prose::formula(rounded(exact, 11, Unit::One))),
        None => Prose::text(format!("{basis}; there is no oscillation about this place at this amplitude")),
    };
    Ok(Table { head, rows, note })
}

fn rest(remainder: Remainder) -> Prose {
    if !remainder.size.is_finite() {
        return Prose::text("no end in sight");
    }
    let word = if remainder.certainty == Certainty::Proven { "below " } else { "about " };
    Prose::text(word).and(Prose::formula(rounded(remainder.size, 2, Unit::One)))
}

/// ε, the frequency, the period and the harmonics at the amplitude, beside those of the motion in numbers.
pub(super) fn motion(question: &Question, released: &Released) -> Result<Table, DerivationError> {
    let of = of_amplitude(question, &question.solution)?;
    let value = |series: &[Rational], powers: usize| {
        series.iter().take(powers).rev().fold(0.0, |sum, c| sum * released.amplitude + c.to_f64())
    };
    let unit = if is_angle(question) { Unit::Radian } else { Unit::One };
    let exact = Exact::new(question, released.amplitude);
    let ratio = value(&of.period_ratio, question.order);
    let exact_ratio = exact.as_ref().map(|exact| exact.ratio);
    let mut rows = vec![
        (letter("ε"), value(&of.epsilon, question.order + 1), None, Unit::One),
        (letter("Δ"), value(&of.frequency_ratio, question.order), exact_ratio.map(f64::recip), Unit::One),
        (letter("T") / Formula::from(Name::new("T").index(0)), ratio, exact_ratio, Unit::One),
    ];
    if let Some(frequency) = released.angular_frequency {
        let small = 2.0 * std::f64::consts::PI / frequency;
        rows.push((letter("T"), ratio * small, exact_ratio.map(|ratio| ratio * small), Unit::Second));
    }
    for (k, series) in of.harmonics.iter().filter(|(k, _)| *k <= question.order) {
        let exact = exact.as_ref().map(|exact| exact.motion.cosine(*k));
        rows.push((harmonic_name(*k).into(), value(series, question.order + 1), exact, unit));
    }
    let cell = |value: f64, unit| Prose::formula(rounded(value, 8, unit));
    let row = |(name, value, exact, unit): (Formula, f64, Option<f64>, Unit)| {
        let exact = exact.map_or_else(|| Prose::text(""), |exact| cell(exact, unit));
        vec![Prose::formula(name), cell(value, unit), exact]
    };
    let head = ["quantity", "series", "exact"].map(Prose::text).into();
    let note = Prose::text("series to the order derived; exact: the equation of motion integrated in time");
    Ok(Table { head, rows: rows.into_iter().map(row).collect(), note })
}

/// The motion in numbers: in closed form the pendulum's period, integrated in time all else.
struct Exact {
    ratio: f64,
    motion: PeriodicMotion,
}

impl Exact {
    /// None where the oscillator does not swing at this amplitude.
    fn new(question: &Question, amplitude: f64) -> Option<Self> {
        let motion = PeriodicMotion::from_turning_point(&question.oscillator, amplitude).ok()?;
        let small = 2.0 * std::f64::consts::PI / question.omega0_squared.to_f64().sqrt();
        let pendulum = is_pendulum(question, amplitude);
        let ratio = if pendulum { period_ratio(amplitude) } else { motion.period() / small };
        Some(Self { ratio, motion })
    }
}
