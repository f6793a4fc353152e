//! Falling amplitudes, or turning points, against time or against the number of swings: damping law, coefficients, quality factor.
//!
//! # Method
//! The energy falls at its mean rate over an undamped cycle, at any amplitude of a pendulum: dA/dt = −Σ κₙ fₙ(A) with κₙ = cₙω0ⁿ⁻¹ and
//! fₙ = ∮|θ′|ⁿ⁺¹dt/(T sin A) at ω0 = 1, which for small swings is 2/π, A/2 and 4A²/3π for n = 0, 1 and 2. Against the number of swings the rate is
//! multiplied by T/T0. The κₙ follow without the period; the coefficients cₙ and Q need it. Turning points of both sides are z ± A(t), and the
//! offset z of the scale's zero is fitted. Laws with one to three kinds of damping are compared by Akaike's criterion.
//!
//! The quality factor is ω0/c for linear damping, for which A ∝ exp(−ct/2), and 2πE/ΔE of the undamped cycle at a stated amplitude for all other
//! laws.

mod comparison;
mod error;
mod fitted;
mod law;
mod period;
mod quality;
mod search;
mod sides;
mod table;
mod warning;
mod warnings;

pub use error::AmplitudesError;
pub use fitted::{AmplitudesFit, DampingCoefficient, LawOfAmplitudes};
pub use sides::Sides;
pub use table::{AmplitudeColumns, AmplitudeReading, AmplitudeTable, Position, UnstatedErrors};
pub use warning::AmplitudesWarning;

use super::DampingModel;
use comparison::LawComparison;
use libration::quantity::Quantity;

/// Known quantities and choices besides the table.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AmplitudesOptions {
    /// The damping; the simplest law that the rows do not separate from the best one if `None`.
    pub damping: Option<DampingModel>,
    /// Period of small swings, in seconds.
    pub period: Option<Quantity>,
}

/// Fits the damping laws to a table of amplitudes.
///
/// # Errors
/// Fails for too few rows, an amplitude that does not fall, equal positions, and an unusable period.
pub fn fit_amplitudes(
    table: &AmplitudeTable,
    options: &AmplitudesOptions,
) -> Result<AmplitudesFit, AmplitudesError> {
    if let Some(period) = options.period {
        let uncertainty = period.uncertainty.unwrap_or(0.0);
        if !(period.value > 0.0 && period.value.is_finite() && (0.0..f64::INFINITY).contains(&uncertainty)) {
            return Err(AmplitudesError::Period { value: period.value, uncertainty });
        }
        if table.has_period() {
            return Err(AmplitudesError::PeriodTwice);
        }
    }
    let comparison = LawComparison::new(table, options.damping)?;
    let mut fit = AmplitudesFit::new(table, options, &comparison);
    fit.warnings = warnings::warnings(table, &comparison, &fit);
    Ok(fit)
}
