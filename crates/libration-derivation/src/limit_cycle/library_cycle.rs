//! Limit cycle from other algorithms: in fractions if the library expands it, otherwise numerically from its slow flow.

use super::super::averaging::AveragingQuestion;
use super::super::check::DerivationError;
use super::cycle::Cycle;
use libration::algebra::Rational;
use libration::internals::progress::Watch;
use libration::oscillator::{Kind, Oscillator};
use libration::perturbation::{Expansion, Gauge, SlowLimitCycle, expand, slow_flow};

/// Largest denominator that is tried for a numerical amplitude.
const DENOMINATORS: i64 = 1000;

pub(super) enum LibraryCycle {
    Fractions(Box<Expansion>),
    Digits(SlowLimitCycle),
}

impl LibraryCycle {
    pub(super) fn new(
        question: &AveragingQuestion,
        order: usize,
        watch: &Watch<'_>,
    ) -> Result<Self, DerivationError> {
        if let Some(oscillator) = Oscillator::new(&question.equation).ok().filter(is_limit_cycle) {
            let expansion = expand(&oscillator, order, &Gauge::Fundamental, watch)?;
            return Ok(Self::Fractions(Box::new(expansion)));
        }
        let degree = question.flow.terms.iter().map(|term| term.position + term.velocity).max().unwrap_or(1);
        let name = Some(question.force.parameter.as_str());
        let powers = 1 + order * degree.saturating_sub(1);
        let flow = slow_flow(&question.equation, name, powers, order, &Gauge::Fundamental, watch)?;
        flow.limit_cycles().into_iter().next().map(Self::Digits).ok_or(DerivationError::NoExcitation)
    }

    /// The amplitude without excitation, if it is a fraction.
    pub(super) fn beginning(&self) -> Result<Rational, DerivationError> {
        let amplitude = match self {
            Self::Fractions(expansion) => {
                let is_plain = expansion.unit_squared == Rational::from(1);
                expansion.harmonic(1).filter(|_| is_plain).and_then(|harmonic| harmonic.cos.first().cloned())
            }
            Self::Digits(digits) => digits.amplitude.first().copied().and_then(fraction),
        };
        amplitude.ok_or(DerivationError::NoCycle)
    }

    /// Returns `true` if a limit cycle equals this one.
    pub(super) fn is(&self, question: &AveragingQuestion, cycle: &Cycle) -> bool {
        let decimals = match self {
            Self::Fractions(expansion) => return cycle.is(question, expansion),
            Self::Digits(digits) => digits,
        };
        // The digits known are those of an `f64`, after sums of some dozen terms.
        let near = |a: Rational, b: &f64| (a.to_f64() - b).abs() <= 1e-9 * b.abs().max(1.0);
        let amplitudes = cycle.orders.iter().zip(&decimals.amplitude);
        let frequencies = decimals.frequency.iter().enumerate();
        decimals.amplitude.len() == cycle.orders.len()
            && amplitudes.into_iter().all(|(order, expected)| near(order.amplitude_below.clone(), expected))
            && frequencies.into_iter().all(|(n, expected)| near(cycle.frequency(question, n), expected))
    }
}

fn is_limit_cycle(oscillator: &Oscillator) -> bool {
    matches!(oscillator.kind(), Kind::LimitCycle { .. })
}

/// A fraction with a small denominator next to a number; it is checked exactly elsewhere.
fn fraction(value: f64) -> Option<Rational> {
    let near = |below: i64| {
        let above = Rational::new(1, below)?.to_f64();
        let digits = format!("{:.0}", value / above);
        let candidate = Rational::new(digits.parse().ok()?, below)?;
        // Fractions with such denominators are at least 1e-6 apart.
        ((candidate.to_f64() - value).abs() < 1e-9).then_some(candidate)
    };
    (1..=DENOMINATORS).find_map(near)
}
