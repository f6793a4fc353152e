//! The same law from the loss of energy, derived independently of the conditions.

use std::collections::BTreeMap;

use super::super::check::{AveragedClaim, CheckedEquation, DerivationError, ForceTerm};
use super::super::document::DerivationStep;
use super::super::formula::{
    Formula, Name, Statement, apply, integral, letter, number, order, polynomial, scaled, sum,
};
use super::super::phase::{PhaseFunction, PiNumber, term_with};
use super::flow::{Flow, PowerPair};
use super::orders::averaged;
use super::put_back::{Along, PhaseSeries};
use super::question::AveragingQuestion;
use libration::algebra::Rational;

pub(super) fn step(
    question: &AveragingQuestion,
    flow: &Flow,
) -> Result<Option<DerivationStep>, DerivationError> {
    let highest = question.order + 1 - question.flow.lift;
    let loss = loss(question, flow, highest);
    let growth = |n: usize| flow.growth.get(&(n, 1)).cloned().unwrap_or_default();
    let force = force(question, highest);
    // F(A)·a₁(A) = −loss, power by power.
    for n in 0..=highest {
        let product = (0..=n).fold(PiNumber::default(), |sum, k| sum.plus(&growth(n - k).scaled(&force[k])));
        let lost = loss.get(n).cloned().unwrap_or_default();
        if !product.plus(&lost).is_zero() {
            return Err(DerivationError::Disagreement { what: "the conditions and the energy" });
        }
    }
    if loss.iter().all(PiNumber::is_zero) {
        return Ok(None);
    }
    let amplitude = || question.amplitude();
    let (name, mean) = (|| letter("P"), mean(question));
    let next = i64::try_from(highest + 1).unwrap_or(i64::MAX);
    let series = in_amplitude(&loss, &amplitude()) + order(amplitude().pow(next));
    let restoring = polynomial(&force, &amplitude());
    let restoring = match question.is_whole {
        true => restoring,
        false => restoring + order(amplitude().pow(i64::try_from(question.order + 1).unwrap_or(i64::MAX))),
    };
    let law = in_amplitude(&(0..=question.order).map(growth).collect::<Vec<_>>(), &amplitude());
    let quotient = Statement::equal(-(name() / apply("F", [amplitude()])), law);
    let step = DerivationStep::new("energy", "The same from the energy")
        .say(
            "The rate of the amplitude to first order in {} follows without any condition from the energy. Without the weak force the energy stays the \
             same, and at the turning point, where all of it is potential, its derivative with respect to {} is the restoring force there,",
            [question.small(), amplitude()],
        )
        .show(CheckedEquation::definition(Statement::defined(apply("F", [amplitude()]), restoring)))
        .say("The weak force takes from it, on the average over a swing of the undamped motion and for each unit of {},", [question.small()])
        .show(averaged(question, Statement::equal(name(), mean).and_equal(series), AveragedClaim::Loss { highest }))
        .say(
            "Here {} is the velocity of the undamped motion, from the powers without {}. What is lost is lost at the turning point, so that the amplitude goes as",
            [letter("v"), question.small()],
        )
        .show(averaged(question, quotient, AveragedClaim::FirstLaw))
        .say("the same as the conditions gave, to all powers of the amplitude.", []);
    Ok(Some(step))
}

fn mean(question: &AveragingQuestion) -> Formula {
    let end = match question.half_turns() {
        1 => Formula::Pi,
        _ => 2 * Formula::Pi,
    };
    let raised = |name: Name, n: usize| match n {
        0 => None,
        1 => Some(Formula::from(name)),
        n => Some(Formula::from(name).pow(i64::try_from(n).unwrap_or(i64::MAX))),
    };
    let term = |term: &ForceTerm| {
        let factors =
            [raised(question.displacement.clone(), term.position), raised(Name::new("v"), term.velocity + 1)];
        let product = factors.into_iter().flatten().reduce(|product, factor| product * factor);
        scaled(&term.factor, product.unwrap_or_else(|| number(1)))
    };
    let power = sum(question.weak_terms().map(term).collect());
    number(1) / end.clone() * integral("ψ", 0, end, power)
}

/// The restoring force at a displacement, by powers.
fn force(question: &AveragingQuestion, highest: usize) -> Vec<Rational> {
    let mut force = vec![Rational::from(0); highest + 1];
    let square = question.omega0().clone() * question.omega0().clone();
    let linear = [(1, square)].into_iter();
    for (n, factor) in
        linear.chain(question.restoring_terms().map(|term| (term.position, term.factor.clone())))
    {
        if let Some(coefficient) = force.get_mut(n) {
            *coefficient = coefficient.clone() + factor;
        }
    }
    force
}

/// The entries without the small parameter.
fn undamped<V: Clone>(all: &BTreeMap<PowerPair, V>) -> BTreeMap<PowerPair, V> {
    let mut undamped = BTreeMap::new();
    for (powers, value) in all.iter().filter(|((_, j), _)| *j == 0) {
        undamped.insert(*powers, value.clone());
    }
    undamped
}

/// The mean of f·v over the undamped motion, by powers of the amplitude.
fn loss(question: &AveragingQuestion, flow: &Flow, highest: usize) -> Vec<PiNumber> {
    let (motion, frequency) = (undamped(&flow.motion), undamped(&flow.frequency));
    let growth = BTreeMap::new();
    let along = Along { growth: &growth, frequency: &frequency, level: highest, parameter_order: 0, lift: 0 };
    let velocity = along.rate(&motion);
    let mut sum = vec![PiNumber::default(); highest + 1];
    for term in question.weak_terms() {
        let factor = PhaseFunction::constant(term.factor.clone().into());
        let factors = std::iter::repeat_n(&motion, term.position);
        let factors = factors.chain(std::iter::repeat_n(&velocity, term.velocity + 1));
        let product = factors
            .fold(PhaseSeries::from([((0, 0), factor)]), |product, series| along.times(&product, series));
        for ((n, _), part) in product {
            let half_turns = question.half_turns();
            let whole = part.integral().at_half_turns(half_turns).times_power_of_pi(-1);
            let share = Rational::new(1, i64::try_from(half_turns).unwrap_or(1)).unwrap_or_else(|| 1.into());
            sum[n] = sum[n].plus(&whole.scaled(&share));
        }
    }
    sum
}

fn in_amplitude(coefficients: &[PiNumber], amplitude: &Formula) -> Formula {
    let terms = coefficients.iter().enumerate().flat_map(|(n, value)| {
        let power = match n {
            0 => vec![],
            1 => vec![amplitude.clone()],
            n => vec![amplitude.clone().pow(i64::try_from(n).unwrap_or(i64::MAX))],
        };
        value.terms().map(|(pi, coefficient)| term_with(coefficient, pi, power.clone())).collect::<Vec<_>>()
    });
    let terms: Vec<Formula> = terms.collect();
    if terms.is_empty() { number(0) } else { sum(terms) }
}
