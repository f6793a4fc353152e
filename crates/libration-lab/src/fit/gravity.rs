//! Gravity from T0 and the length: g = 4π² l/T0².

use super::{FitError, LawFit};
use libration::quantity::Quantity;

/// The least and the greatest gravity on the surface of the Earth, in m/s²: C. Hirt and others, Geophys. Res. Lett. 40, 4279
/// (2013), doi:10.1002/grl.50838.
pub const GRAVITY_ON_EARTH: [f64; 2] = [9.7639, 9.8337];

/// Gravity with its standard deviation, in m/s².
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gravity {
    /// g.
    pub value: f64,
    /// From the uncertainties of T0 and of the length, taken as independent.
    pub uncertainty: f64,
}

/// The gravity that a pendulum of this length in metres feels when it has the fitted T0.
///
/// # Errors
/// A length that is not positive and finite, or an uncertainty of it that is negative or not finite.
pub fn gravity(fit: &LawFit, length: Quantity) -> Result<Gravity, FitError> {
    let Quantity { value: metres, uncertainty } = length;
    let spread = uncertainty.unwrap_or(0.0);
    let usable = metres > 0.0 && metres.is_finite() && spread >= 0.0 && spread.is_finite();
    if !usable {
        return Err(FitError::Length { value: metres, uncertainty: spread });
    }
    let angular_frequency = 2.0 * std::f64::consts::PI / fit.t0;
    let value = metres * angular_frequency * angular_frequency;
    let relative = libm::hypot(spread / metres, 2.0 * fit.t0_uncertainty / fit.t0);
    Ok(Gravity { value, uncertainty: value * relative })
}
