//! The quality factor of a damping law.

use std::f64::consts::PI;

use super::law::DecayLaw;
use super::search::DecayLawFit;
use crate::fit::damping_model::DampingModel;
use crate::fit::quality;
use crate::fit::quality::Quality;
use crate::fit::uncertain::Uncertain;
use libration::decay::DampingKind;
use libration::decay::small_cycle_integral;

/// Q of a law at an amplitude; of linear damping alone at every one. `None` without damping. `scale` is the factor of the covariance.
pub(super) fn quality(
    law: &DecayLaw<'_>,
    fit: &DecayLawFit,
    phase: Uncertain,
    amplitude: f64,
    scale: f64,
) -> Option<Quality> {
    if fit.terms == DampingModel::only(DampingKind::Linear) {
        return Some(Quality { factor: of_losses(fit, phase, &[1.0], scale)?, amplitude: None });
    }
    let factor = at_amplitude(law, fit, phase, amplitude, scale)?;
    Some(Quality { factor, amplitude: Some(amplitude) })
}

/// 2πE/ΔE of the undamped cycle at this amplitude.
pub(super) fn at_amplitude(
    law: &DecayLaw<'_>,
    fit: &DecayLawFit,
    phase: Uncertain,
    amplitude: f64,
    scale: f64,
) -> Option<Uncertain> {
    let losses: Vec<f64> = fit.terms.iter().map(|term| loss(law, term, amplitude)).collect();
    of_losses(fit, phase, &losses, scale)
}

/// 1/Q = Σ κₙgₙ over the phase.
fn of_losses(fit: &DecayLawFit, phase: Uncertain, losses: &[f64], scale: f64) -> Option<Uncertain> {
    let sum: f64 = losses.iter().zip(&fit.parameters[1..]).map(|(loss, rate)| loss * rate).sum();
    let pairs = losses.iter().enumerate().flat_map(|(i, one)| {
        losses.iter().enumerate().map(move |(j, other)| one * other * fit.covariance[(i + 1, j + 1)])
    });
    let variance: f64 = pairs.sum();
    let value = phase.value / sum;
    let relative = libm::hypot((scale * variance).sqrt() / sum, phase.relative());
    (sum > 0.0 && value.is_finite()).then_some(Uncertain { value, uncertainty: value * relative })
}

/// gₙ = ΔE/(2πE) for a unit coefficient at ω0 = 1.
fn loss(law: &DecayLaw<'_>, term: DampingKind, amplitude: f64) -> f64 {
    if !law.table.reading.is_of_angles() {
        return small_cycle_integral(term.exponent(), amplitude) / (PI * amplitude * amplitude);
    }
    quality::loss(term, amplitude)
}
