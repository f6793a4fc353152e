//! Substitution of the whole flow into the equation of motion by differentiation along it, and comparison with the library's flow.

use std::collections::BTreeMap;

use super::super::check::{DerivationError, FlowTerms};
use super::super::phase::{PhaseFunction, PiNumber, Wave};
use super::flow::{Flow, PowerPair};
use super::question::AveragingQuestion;
use libration::algebra::{PiSum, Rational};
use libration::internals::progress::Watch;
use libration::perturbation::{Gauge, PhaseTerm, SlowFlow, slow_flow};

/// A function of amplitude, parameter and phase.
pub(crate) type PhaseSeries = BTreeMap<PowerPair, PhaseFunction>;

/// Amplitude and phase in time, with the powers at which products are truncated.
pub(crate) struct Along<'a> {
    pub(crate) growth: &'a BTreeMap<PowerPair, PiNumber>,
    pub(crate) frequency: &'a BTreeMap<PowerPair, PiNumber>,
    /// The highest power of the amplitude; includes the power of the parameter if `lift` is one.
    pub(crate) level: usize,
    pub(crate) parameter_order: usize,
    pub(crate) lift: usize,
}

impl Along<'_> {
    /// The time derivative: ψ′ ∂/∂ψ + A′ ∂/∂A.
    pub(crate) fn rate(&self, function: &PhaseSeries) -> PhaseSeries {
        let mut rate = PhaseSeries::new();
        for ((m, i), part) in function {
            for ((n, j), frequency) in self.frequency {
                self.add(&mut rate, (n + m, j + i), &part.slope().scaled(frequency));
            }
            for ((n, j), growth) in self.growth.iter().filter(|_| *m > 0) {
                let degree = Rational::from(i64::try_from(*m).unwrap_or(i64::MAX));
                self.add(&mut rate, (n + m - 1, j + i), &part.scaled(&growth.scaled(&degree)));
            }
        }
        rate
    }

    pub(crate) fn times(&self, a: &PhaseSeries, b: &PhaseSeries) -> PhaseSeries {
        let mut product = PhaseSeries::new();
        for ((n, j), left) in a {
            for ((m, i), right) in b.iter().filter(|((m, i), _)| self.counts((n + m, j + i))) {
                self.add(&mut product, (n + m, j + i), &left.times(right));
            }
        }
        product
    }

    fn counts(&self, (n, j): PowerPair) -> bool {
        n + self.lift * j <= self.level && j <= self.parameter_order
    }

    fn add(&self, sum: &mut PhaseSeries, powers: PowerPair, part: &PhaseFunction) {
        if self.counts(powers) {
            let entry = sum.entry(powers).or_default();
            *entry = entry.plus(part);
        }
    }

    /// Σ factor·xⁱ·vᵏ·cʲ.
    fn force(&self, flow: &FlowTerms, x: &PhaseSeries, v: &PhaseSeries) -> PhaseSeries {
        let mut sum = PhaseSeries::new();
        for term in &flow.terms {
            let factor = PhaseFunction::constant(term.factor.clone().into());
            let start = PhaseSeries::from([((0, term.parameter), factor)]);
            let factors = std::iter::repeat_n(x, term.position).chain(std::iter::repeat_n(v, term.velocity));
            let product = factors.fold(start, |product, series| self.times(&product, series));
            product.iter().for_each(|(powers, part)| self.add(&mut sum, *powers, part));
        }
        sum
    }
}

/// Differentiates the motion twice along the flow and compares the result with the force.
pub fn check(question: &AveragingQuestion, flow: &Flow) -> Result<(), DerivationError> {
    let along = along(question, flow);
    let velocity = along.rate(&flow.motion);
    let mut rest = along.rate(&velocity);
    let square = PiNumber::from(question.omega0().clone() * question.omega0().clone());
    flow.motion.iter().for_each(|(powers, part)| along.add(&mut rest, *powers, &part.scaled(&square)));
    let force = along.force(&question.flow, &flow.motion, &velocity);
    force.iter().for_each(|(powers, part)| along.add(&mut rest, *powers, part));
    let begins =
        |powers: &PowerPair| flow.motion.get(powers).map(PhaseFunction::at_start).unwrap_or_default();
    let is_turn = |powers: &PowerPair, part: &PhaseFunction| {
        part.at_start().is_zero() && (begins(powers).is_zero() || *powers == (1, 0))
    };
    let turns = velocity.iter().all(|(powers, part)| is_turn(powers, part));
    let velocity_at = |powers: &PowerPair| velocity.get(powers).cloned().unwrap_or_default();
    let same = flow.velocity.iter().all(|(powers, part)| velocity_at(powers) == *part);
    let (opposite, half_turns) = match question.half_turns() {
        1 => (Rational::from(-1), 1),
        _ => (Rational::from(1), 2),
    };
    let goes_on = flow
        .motion
        .values()
        .chain(velocity.values())
        .all(|part| part.at_half_turns(half_turns) == part.at_start().scaled(&opposite));
    let is_solved = rest.values().all(PhaseFunction::is_zero);
    match is_solved && turns && same && goes_on {
        true => Ok(()),
        false => Err(DerivationError::Disagreement { what: "the motion and the equation of motion" }),
    }
}

pub(crate) fn along<'a>(question: &AveragingQuestion, flow: &'a Flow) -> Along<'a> {
    let lift = question.flow.lift;
    Along {
        growth: &flow.growth,
        frequency: &flow.frequency,
        level: question.order,
        parameter_order: question.parameter_order,
        lift,
    }
}

/// Compares every coefficient with the library's, which come from another algorithm.
pub fn agrees_with_library(
    question: &AveragingQuestion,
    flow: &Flow,
    watch: &Watch<'_>,
) -> Result<SlowFlow, DerivationError> {
    let (equation, name) = (&question.equation, question.force.parameter.as_str());
    let library =
        slow_flow(equation, Some(name), question.order, question.parameter_order, &Gauge::XMax, watch)?;
    let is = |coefficients: &BTreeMap<PowerPair, PiNumber>, powers: PowerPair, other: &PiSum| {
        coefficients.get(&powers).cloned().unwrap_or_default().is(other)
    };
    // A coefficient of the phase is determined together with the next power of the amplitude.
    let same = |coefficients: &BTreeMap<PowerPair, PiNumber>, series: &Vec<Vec<PiSum>>, found_with: usize| {
        let rows = series.iter().enumerate();
        rows.flat_map(|(j, row)| row.iter().enumerate().map(move |(n, value)| ((n, j), value)))
            .filter(|((n, j), _)| question.asks_for((n + found_with, *j)))
            .all(|(powers, value)| is(coefficients, powers, value))
    };
    let rates =
        same(&flow.growth, &library.amplitude_rate, 0) && same(&flow.frequency, &library.phase_rate, 1);
    match rates && has_the_motion(question, flow, &library.motion) {
        true => Ok(library),
        false => Err(DerivationError::Disagreement { what: "two computations of the slow flow" }),
    }
}

fn has_the_motion(question: &AveragingQuestion, flow: &Flow, terms: &[PhaseTerm]) -> bool {
    let shown = |powers: &PowerPair| question.asks_for(*powers);
    let mut terms_of_flow: BTreeMap<(PowerPair, usize, usize, Wave), PiNumber> = BTreeMap::new();
    for (powers, part) in flow.motion.iter().filter(|(powers, _)| shown(powers)) {
        for ((power, k, wave), value) in part.terms() {
            terms_of_flow.insert((*powers, power, k, wave), value.clone());
        }
    }
    for term in terms {
        for (wave, series) in [(Wave::Cosine, &term.cos), (Wave::Sine, &term.sin)] {
            for (j, row) in series.iter().enumerate() {
                for (n, other) in row.iter().enumerate().filter(|(n, _)| question.asks_for((*n, j))) {
                    let value = terms_of_flow.remove(&((n, j), term.power, term.k, wave)).unwrap_or_default();
                    if !value.is(other) {
                        return false;
                    }
                }
            }
        }
    }
    terms_of_flow.is_empty()
}
