//! The exact motion of a pendulum from its harmonics, for comparison with equations of motion.

use libration::pendulum::{Amplitude, Pendulum};
use libration::quantity::Angle;

/// The length of the pendulum in numerical checks: neither length nor frequency is 1.
pub(super) const LENGTH: f64 = 0.8;
pub(super) const GRAVITY: f64 = 9.81;

/// A state of the motion with its acceleration.
#[derive(Clone, Copy, Debug)]
pub(super) struct Instant {
    pub(super) angle: f64,
    pub(super) velocity: f64,
    pub(super) acceleration: f64,
}

impl Instant {
    /// The values of the symbols of an equation of motion.
    pub(super) fn values(&self, amplitude: f64) -> [(&'static str, f64); 7] {
        [
            ("theta", self.angle),
            ("theta'", self.velocity),
            ("theta''", self.acceleration),
            ("theta0", amplitude),
            ("omega0", (GRAVITY / LENGTH).sqrt()),
            ("g", GRAVITY),
            ("l", LENGTH),
        ]
    }
}

/// The coefficients a1, a3, a5, … of the angle in radians, down to 1e-18.
pub(super) fn harmonics(amplitude: &Angle) -> Option<Vec<f64>> {
    let motion = Pendulum::from_angular_frequency(1.0).ok()?.released_from(*amplitude).ok()?;
    Some(motion.harmonics(1e-18, 400).terms.iter().map(|term| term.angle).collect())
}

/// Ω/ω0.
pub(super) fn frequency_ratio(amplitude: &Angle) -> Option<f64> {
    Some(1.0 / Amplitude::new(*amplitude).ok()?.period_ratio())
}

/// States at `count` phases, evenly spaced over a period from the turning point
/// on, each computed as the sum of the harmonics and of their derivatives.
pub(super) fn instants(amplitude: &Angle, count: u32) -> Option<Vec<Instant>> {
    let harmonics = harmonics(amplitude)?;
    let frequency = frequency_ratio(amplitude)? * (GRAVITY / LENGTH).sqrt();
    let at = |index: u32| {
        let phase = std::f64::consts::TAU * f64::from(index) / f64::from(count);
        let mut instant = Instant { angle: 0.0, velocity: 0.0, acceleration: 0.0 };
        for (coefficient, n) in harmonics.iter().zip((1_u32..).step_by(2)) {
            let rate = f64::from(n) * frequency;
            let (sine, cosine) = libm::sincos(f64::from(n) * phase);
            instant.angle += coefficient * cosine;
            instant.velocity -= coefficient * rate * sine;
            instant.acceleration -= coefficient * rate * rate * cosine;
        }
        instant
    };
    Some((0..count).map(at).collect())
}
