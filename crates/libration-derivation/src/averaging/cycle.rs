//! Limit cycles: the amplitude at which the slow flow is stationary, its frequency, and the rate of approach of neighbours.

use super::super::check::{AveragedClaim, CheckedEquation, CycleQuantity, DerivationError};
use super::super::document::DerivationStep;
use super::super::formula::{Formula, Name, Statement, letter, order, polynomial, sqrt};
use super::super::phase::PiNumber;
use super::flow::Flow;
use super::orders::averaged;
use super::question::AveragingQuestion;
use libration::algebra::Rational;
use libration::perturbation::{SlowFlow, SlowLimitCycle};

/// A power series in the small parameter.
type CycleSeries = Vec<Rational>;

/// The limit cycle of an odd self-excited oscillator with a linear spring, by powers of the parameter.
struct AveragedCycle {
    /// A², with one power less than the others.
    square: CycleSeries,
    frequency: CycleSeries,
    exponent: CycleSeries,
}

/// The step; `None` if the slow flow has no limit cycle, or one that is not expanded in fractions.
pub(super) fn step(
    question: &AveragingQuestion,
    flow: &Flow,
    library: &SlowFlow,
) -> Result<Option<DerivationStep>, DerivationError> {
    let powers = library.whole_powers;
    if powers == 0 || question.flow.kinked || !question.is_odd() {
        return Ok(None);
    }
    let Some(cycle) = AveragedCycle::new(flow, powers) else { return Ok(None) };
    let same = |cycle: &AveragedCycle, other: &SlowLimitCycle| {
        // The other method computes in `f64`.
        let near = |a: &CycleSeries, b: &[f64]| {
            a.len() == b.len()
                && a.iter().zip(b).all(|(a, b)| (a.to_f64() - b).abs() < 1e-9 * b.abs().max(1.0))
        };
        let square = squared(&other.amplitude);
        near(&cycle.square, &square)
            && near(&cycle.frequency, &other.frequency)
            && near(&cycle.exponent, &other.exponent)
    };
    if !library.limit_cycles().iter().any(|other| same(&cycle, other)) {
        return Err(DerivationError::Disagreement { what: "two computations of the limit cycle" });
    }
    Ok(Some(written(question, &cycle, powers)))
}

fn written(question: &AveragingQuestion, cycle: &AveragedCycle, powers: usize) -> DerivationStep {
    let c = || question.small();
    let series = |series: &CycleSeries| {
        let next = i64::try_from(series.len()).unwrap_or(i64::MAX);
        let power = if next == 1 { c() } else { c().pow(next) };
        polynomial(series, &c()) + order(power)
    };
    let show = |left: Formula, right: &CycleSeries, quantity: CycleQuantity| -> CheckedEquation {
        let claim = AveragedClaim::Cycle { parameter: question.parameter.clone(), quantity };
        averaged(question, Statement::equal(left, series(right)), claim)
    };
    let rate = || Formula::from(Name::new("A").prime());
    let step = DerivationStep::new("limit-cycle", "The limit cycle")
        .say(
            "Where {} vanishes the amplitude stays, and the motion repeats itself. With a series in {} for the square of that amplitude, put into the law above, each power of {} \
             gives the next coefficient:",
            [rate(), c(), c()],
        )
        .show(show(question.amplitude().squared(), &cycle.square, CycleQuantity::SquaredAmplitude))
        .say("It begins with the amplitude {}, and is the largest displacement, as the gauge says. The frequency there is", [
            match cycle.square.first().and_then(Rational::square_root) {
                Some(root) => root.into(),
                None => sqrt(cycle.square.first().cloned().unwrap_or_else(|| 0.into())),
            },
        ])
        .show(show(Name::new("ψ").prime().into(), &cycle.frequency, CycleQuantity::Frequency))
        .say("A small distance from it changes at the rate that is the derivative of {} with respect to {},", [
            rate(),
            question.amplitude(),
        ])
        .show(show(letter("λ"), &cycle.exponent, CycleQuantity::Exponent));
    let first = cycle.exponent.iter().find(|coefficient| !coefficient.is_zero());
    let step = match first.is_some_and(Rational::is_negative) {
        true => step.say("so that for small positive {} all neighbours come nearer: the cycle is stable.", [c()]),
        false => step.say("so that for small positive {} neighbours go away: the cycle is unstable, and stable where {} is negative.", [c(), c()]),
    };
    step.say(
        "The series go up to the requested power of the amplitude: to {}, and one power less for the amplitude.",
        [if powers == 1 { c() } else { c().pow(i64::try_from(powers).unwrap_or(i64::MAX)) }],
    )
}

impl AveragedCycle {
    /// Computes the cycle from the laws as polynomials in A², by powers of the parameter.
    fn new(flow: &Flow, powers: usize) -> Option<Self> {
        let rows = |map: &std::collections::BTreeMap<(usize, usize), PiNumber>, shift: usize| {
            let mut rows = vec![CycleSeries::new(); powers + 1];
            for ((n, j), value) in map.iter().filter(|((_, j), _)| *j <= powers) {
                let power = n.checked_sub(shift).filter(|n| n.is_multiple_of(2))? / 2;
                let row = &mut rows[*j];
                row.resize(row.len().max(power + 1), Rational::from(0));
                row[power] = value.to_rational()?;
            }
            Some(rows)
        };
        let (rates, phases) = (rows(&flow.growth, 1)?, rows(&flow.frequency, 0)?);
        let first = positive_root(rates.get(1)?)?;
        let slope = value(&derivative(&rates[1]), std::slice::from_ref(&first), 1).remove(0);
        let mut square = vec![first];
        for n in 1..powers {
            square.push(Rational::from(0));
            let missed = along(&rates, &square, n + 1)[n + 1].clone();
            square[n] = -missed.checked_div(&slope)?;
        }
        let slopes: Vec<CycleSeries> = rates.iter().map(|row| derivative(row)).collect();
        let frequency = along(&phases, &square, powers);
        let twice: CycleSeries =
            square.iter().map(|coefficient| coefficient.clone() * Rational::from(2)).collect();
        let exponent = product(&along(&slopes, &square, powers), &twice, powers + 1);
        Some(Self { square, frequency, exponent })
    }
}

/// The only positive root of a polynomial of first or second degree, if it is a fraction.
fn positive_root(row: &[Rational]) -> Option<Rational> {
    let zero = || Rational::from(0);
    match row {
        [a, b] => Some(-a.checked_div(b)?).filter(|root| !root.is_negative() && *root != zero()),
        [a, b, c] => {
            let four = Rational::from(4);
            let below = b.clone() * b.clone() - four * a.clone() * c.clone();
            let root = below.square_root()?;
            let twice = Rational::from(2) * c.clone();
            let both = [root.clone(), -root].map(|root| (root - b.clone()).checked_div(&twice));
            both.into_iter().flatten().find(|root| !root.is_negative() && *root != zero())
        }
        _ => None,
    }
}

fn derivative(row: &[Rational]) -> CycleSeries {
    let term = |(n, coefficient): (usize, &Rational)| {
        coefficient.clone() * Rational::from(i64::try_from(n).unwrap_or(i64::MAX))
    };
    row.iter().enumerate().skip(1).map(term).collect()
}

/// Σ εᵏ pₖ(B(ε)) up to a power of ε.
fn along(rows: &[CycleSeries], square: &[Rational], last: usize) -> CycleSeries {
    let mut whole = vec![Rational::from(0); last + 1];
    for (k, row) in rows.iter().enumerate().take(last + 1) {
        for (sum, term) in whole[k..].iter_mut().zip(value(row, square, last + 1 - k)) {
            *sum = sum.clone() + term;
        }
    }
    whole
}

/// The value of a polynomial at a series.
fn value(row: &[Rational], of: &[Rational], length: usize) -> CycleSeries {
    let zero = vec![Rational::from(0); length];
    row.iter().rev().fold(zero, |sum, coefficient| {
        let mut next = product(&sum, of, length);
        next[0] = next[0].clone() + coefficient.clone();
        next
    })
}

fn product(a: &[Rational], b: &[Rational], length: usize) -> CycleSeries {
    let term = |n: usize| {
        let pairs = (0..=n).filter_map(|i| Some(a.get(n - i)?.clone() * b.get(i)?.clone()));
        pairs.fold(Rational::from(0), |sum, term| sum + term)
    };
    (0..length).map(term).collect()
}

/// The square of a series in floating-point numbers.
fn squared(a: &[f64]) -> Vec<f64> {
    (0..a.len()).map(|n| (0..=n).map(|i| a[i] * a[n - i]).sum()).collect()
}
