//! Amplitudes in degrees, and the amplitude at which a continuous function takes a value.

use libration::quantity::Angle;
use libration::roots::{Tolerance, bisect};

/// The amplitude between two others (in radians) at which `f` changes its sign, by
/// bisection to the spacing of `f64`; `None` if it does not, or has no value in between.
pub(super) fn amplitude_where_zero(low: f64, high: f64, f: &dyn Fn(&Angle) -> Option<f64>) -> Option<f64> {
    let at = |radians: f64| f(&Angle::from_radians(radians).ok()?);
    let sign_at_low = at(low)?.signum();
    if at(high)?.signum().to_bits() == sign_at_low.to_bits() {
        return None;
    }
    let mut has_values = true;
    let [_, high] = bisect([low, high], Tolerance::LAST_BIT, |radians| {
        let value = at(radians);
        has_values &= value.is_some();
        value.is_some_and(|value| value.signum().to_bits() == sign_at_low.to_bits())
    });
    has_values.then_some(high)
}

/// The amplitude of a number of degrees.
pub(super) fn at_degrees(degrees: f64) -> Option<Angle> {
    Angle::from_degrees(degrees).ok()
}

/// Formats like `129.4408075768 degrees`.
pub(super) fn in_degrees(radians: f64) -> String {
    format!("{:.10} degrees", radians.to_degrees())
}
