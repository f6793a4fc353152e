//! Values and units as people write them.

use super::answer::FitTraceResult;
use crate::output::number::rounded;
use libration_lab::measurement::Observable;

/// The unit as people write it.
pub(super) fn unit(unit: &str) -> String {
    if unit == "1" { String::new() } else { unit.replace("^2", "²") }
}

/// A difference of two values, in degrees for angles.
pub(super) fn in_unit(answer: &FitTraceResult<'_>, difference: f64, digits: usize) -> String {
    match answer.measured.traces[0].observable() {
        Observable::Angle => format!("{}°", rounded(difference.to_degrees(), digits)),
        Observable::AngularVelocity => format!("{} rad/s", rounded(difference, digits)),
    }
}
