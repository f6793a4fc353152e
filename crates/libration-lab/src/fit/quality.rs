//! The quality factor of a damped pendulum.

use std::f64::consts::PI;

use super::uncertain::Uncertain;
use libration::decay::DampingKind;
use libration::decay::cycle_integral;
use libration::pendulum::Amplitude;
use libration::quantity::Angle;

/// A quality factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quality {
    /// Q, with its uncertainty.
    pub factor: Uncertain,
    /// Amplitude of the cycle for which Q is 2πE/ΔE, in radians or in the unit of displacements; `None` for linear damping, where Q is ω0/c at every
    /// amplitude.
    pub amplitude: Option<f64>,
}

impl Quality {
    /// The logarithmic decrement π/√(Q² − ¼) of linear damping; `None` for other laws, and for an overdamped pendulum.
    #[must_use]
    pub fn log_decrement(&self) -> Option<Uncertain> {
        let (q, square) = (self.factor.value, self.factor.value * self.factor.value - 0.25);
        (self.amplitude.is_none() && square > 0.0).then(|| {
            let value = PI / square.sqrt();
            Uncertain { value, uncertainty: value * q / square * self.factor.uncertainty }
        })
    }
}

/// ΔE/(2πE) of a cycle of this amplitude, in radians, under damping with a coefficient of one at ω0 = 1.
pub(super) fn loss(term: DampingKind, amplitude: f64) -> f64 {
    let angle = Angle::from_radians(amplitude).ok().and_then(|angle| Amplitude::new(angle).ok());
    let sine = libm::sin(0.5 * amplitude);
    angle.map_or(f64::NAN, |angle| cycle_integral(term.exponent(), &angle) / (4.0 * PI * sine * sine))
}
