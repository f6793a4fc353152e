//! Accuracy of the series at an amplitude.

use super::super::check::DerivationError;
use super::super::document::{DerivationStep, DerivationTable};
use super::super::formula::{Decimal, DecimalUnit, Formula, number, rounded};
use super::super::phase::PiNumber;
use super::super::prose::Prose;
use super::subject::TwoSidedSubject;
use libration::comparison::{ExactMotion, SeriesQuantity};
use libration::internals::progress::Watch;
use libration::perturbation::{Gauge, expand};
use libration::quantity::Displacement;

/// The partial sums of T/T0, compared with the period found by integration.
pub(super) fn step(
    subject: &TwoSidedSubject,
    amplitude: &Displacement,
    watch: &Watch<'_>,
) -> Result<DerivationStep, DerivationError> {
    let at = amplitude.to_f64();
    if !(at > 0.0 && at.is_finite()) {
        return Err(DerivationError::NotAnAmplitude(at));
    }
    let expansion = expand(&subject.oscillator, 2, &Gauge::XMax, watch)?;
    let motion = ExactMotion::new(&subject.oscillator, &expansion, amplitude, watch);
    let exact = motion.and_then(|motion| motion.value(SeriesQuantity::Period));
    let shown = |value: f64, digits: usize| Prose::formula(rounded(value, digits, DecimalUnit::One));
    let (mut sum, mut power, mut rows) = (0.0, 1.0, vec![]);
    for (n, coefficient) in subject.period_ratio().iter().enumerate() {
        let term = coefficient.to_f64() * power;
        (sum, power) = (sum + term, power * at);
        if coefficient.is_zero() {
            continue;
        }
        let mut row = vec![
            Prose::formula(number(i64::try_from(n).unwrap_or(i64::MAX))),
            shown(term, 6),
            shown(sum, 10),
        ];
        row.extend(exact.as_ref().ok().map(|exact| shown(sum / exact.value - 1.0, 2)));
        rows.push(row);
    }
    let mut head = ["power", "term", "sum"].map(Prose::text).to_vec();
    head.extend(exact.as_ref().ok().map(|_| Prose::text("error")));
    let note = match &exact {
        Err(reason) => Prose::text(format!("there is no exact value: {reason}")),
        Ok(exact) => Prose::text("errors are relative to ")
            .and(shown(exact.value, 11))
            .and(Prose::text(", by integration in time")),
    };
    let at = Formula::Decimal(Decimal::short(at, DecimalUnit::One));
    Ok(DerivationStep::new("accuracy", "Accuracy")
        .say("At an amplitude of {} the terms of the period are", [at])
        .table(DerivationTable::numbers(head, rows, note)))
}

impl PiNumber {
    fn to_f64(&self) -> f64 {
        let power = |exponent: i32| libm::pow(std::f64::consts::PI, f64::from(exponent));
        self.terms().map(|(exponent, factor)| factor.to_f64() * power(exponent)).sum()
    }
}
