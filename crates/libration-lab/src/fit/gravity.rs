//! Plausible values of gravity.

use super::significance::{SIGNIFICANT, limit_of_chance};
use super::uncertain::Uncertain;

/// The least and the greatest gravity on the surface of the Earth, in m/s²: C. Hirt and others, Geophys. Res. Lett. 40, 4279
/// (2013), doi:10.1002/grl.50838.
pub const GRAVITY_ON_EARTH: [f64; 2] = [9.7639, 9.8337];

/// Returns `true` if gravity is outside [`GRAVITY_ON_EARTH`] by more than three of its standard uncertainties, or by an equally improbable distance
/// in Student's distribution with their degrees of freedom; for a right value the probability is below 1/700.
#[must_use]
pub fn is_nowhere_on_earth(gravity: Uncertain, degrees_of_freedom: f64) -> bool {
    let [least, greatest] = GRAVITY_ON_EARTH;
    let margin = limit_of_chance(SIGNIFICANT, degrees_of_freedom) * gravity.uncertainty;
    gravity.value < least - margin || gravity.value > greatest + margin
}
