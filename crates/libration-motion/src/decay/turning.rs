//! Motion close to a turning point, where non-integer powers of the velocity have no Taylor series.

use super::Damping;
use libration_numbers::quadrature::double_exponential;

/// The duration of the motion next to a turning point, and the distance covered.
pub(super) struct TurningMotion {
    pub(super) duration: f64,
    pub(super) distance: f64,
}

/// Speed, relative to the acceleration by gravity, below which gravity counts as constant: the distance to rest is of the order of its square, and
/// gravity changes on it by 1e-10 of its value.
const SLOW: f64 = 1e-5;

/// The passage from rest to a small speed, which is returned too.
pub(super) fn departure(gravity: f64, damping: &Damping) -> (TurningMotion, f64) {
    let mut speed = SLOW * gravity;
    while damping.at(speed) > 0.5 * gravity {
        speed *= 0.5;
    }
    (passage(speed, |velocity| gravity - damping.at(velocity)), speed)
}

/// Returns `true` if a speed against gravity is so small that the rest of the motion is an [`arrival`].
pub(super) fn is_close(speed: f64, gravity: f64) -> bool {
    speed <= SLOW * gravity
}

/// The passage from a small speed to rest.
pub(super) fn arrival(speed: f64, gravity: f64, damping: &Damping) -> TurningMotion {
    passage(speed, |velocity| gravity + damping.at(velocity))
}

/// The passage by integration of dt = dv/a and dx = v dv/a.
fn passage(speed: f64, acceleration: impl Fn(f64) -> f64) -> TurningMotion {
    TurningMotion {
        duration: speed * double_exponential(|part| 1.0 / acceleration(speed * part)).value,
        distance: speed * speed * double_exponential(|part| part / acceleration(speed * part)).value,
    }
}
