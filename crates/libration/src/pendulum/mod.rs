//! STUB of the public interface of the pendulum module (bodies follow).
#![allow(missing_docs, clippy::todo, unused_variables, clippy::missing_errors_doc, reason = "stub")]
mod approximate_motion;

pub use approximate_motion::{ApproximateMotion, ApproximateMotionError};

use crate::quantity::Angle;

mod period;
pub use period::{period_excess, period_excesses, period_ratio, period_ratio_near_top, period_ratios, period_ratios_near_top};

/// What belongs to an amplitude in libration: everything dimensionless about the period. Made by `Amplitude::new`.
#[derive(Clone, Copy, Debug)]
pub struct Amplitude { angle: Angle }
impl Amplitude {
    /// From an angle; its absolute value counts. Error at or beyond π.
    pub fn new(angle: Angle) -> Result<Self, PendulumError> { todo!() }
    pub fn radians(&self) -> f64 { todo!() }
    pub fn complement(&self) -> f64 { todo!() }
    pub fn period_ratio(&self) -> f64 { todo!() }
    pub fn period_excess(&self) -> f64 { todo!() }
    pub fn nome(&self) -> f64 { todo!() }
    /// (θ0/T)·dT/dθ0.
    pub fn condition(&self) -> f64 { todo!() }
    /// The amplitude whose T/T0 is `ratio` (≥ 1).
    pub fn from_period_ratio(ratio: f64) -> Result<Self, PendulumError> { todo!() }
}

#[derive(Clone, Copy, Debug)]
pub struct Pendulum {}
impl Pendulum {
    pub fn new(length: f64, gravity: f64) -> Result<Self, PendulumError> { todo!() }
    pub fn from_angular_frequency(omega0: f64) -> Result<Self, PendulumError> { todo!() }
    pub fn length(&self) -> Option<f64> { todo!() }
    pub fn gravity(&self) -> Option<f64> { todo!() }
    /// ω0 = √(g/l).
    pub fn angular_frequency(&self) -> f64 { todo!() }
    pub fn small_angle_period(&self) -> f64 { todo!() }
    /// Released at rest from this angle at t = 0.
    pub fn released_from(&self, angle: Angle) -> Result<Motion, PendulumError> { todo!() }
    /// At this angle with this velocity (rad/s) at t = 0.
    pub fn launched(&self, angle: Angle, velocity: f64) -> Result<Motion, PendulumError> { todo!() }
    /// With energy E/(2mgl) (1 on the separatrix), passing the bottom with positive velocity at t = 0.
    pub fn with_energy_ratio(&self, energy_ratio: f64) -> Result<Motion, PendulumError> { todo!() }
    /// On the separatrix exactly, passing the bottom with positive velocity at t = 0.
    pub fn on_separatrix(&self) -> Motion { todo!() }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Regime { RestStable, RestUpright, Libration, Separatrix, Rotation }

/// A motion: a pendulum and its initial state, prepared.
#[derive(Clone, Debug)]
pub struct Motion {}
impl Motion {
    pub fn regime(&self) -> Regime { todo!() }
    /// Full period in libration, time of a turn in rotation, infinite on the separatrix, NaN at rest upright,
    /// the small-angle period at stable rest.
    pub fn period(&self) -> f64 { todo!() }
    /// E/(2mgl): 1 on the separatrix.
    pub fn energy_ratio(&self) -> f64 { todo!() }
    /// The amplitude (turning point), in libration.
    pub fn amplitude(&self) -> Option<Amplitude> { todo!() }
    /// Action per m·l², rad²/s.
    pub fn action(&self) -> f64 { todo!() }
    pub fn state_at(&self, time: f64) -> State { todo!() }
    pub fn states_at(&self, times: &[f64], angles: &mut [f64], velocities: &mut [f64]) -> Result<(), LengthMismatch> { todo!() }
    /// Fundamental angular frequency, mean velocity and harmonics down to `tolerance` (rad), at most `limit` of them.
    pub fn harmonics(&self, tolerance: f64, limit: usize) -> Harmonics { todo!() }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    pub turns: i64,
    pub angle_in_turn: f64,
    pub complement: f64,
    /// Unwrapped.
    pub angle: f64,
    pub velocity: f64,
}

/// θ(t) = mean·t + Σ angle_n·cos(nΩτ) in libration (τ from the positive turning point), sin in rotation (τ from the bottom).
#[derive(Clone, Debug)]
pub struct Harmonics {
    pub fundamental: f64,
    pub mean_velocity: f64,
    pub terms: Vec<Harmonic>,
}
#[derive(Clone, Copy, Debug)]
pub struct Harmonic { pub n: usize, pub angle: f64, pub velocity: f64 }

#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the slices have different lengths: {expected} and {found}")]
pub struct LengthMismatch { pub expected: usize, pub found: usize }

#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PendulumError {
    #[error("placeholder")]
    Placeholder,
}

impl LengthMismatch {
    fn check(input: &[f64], output: &[f64]) -> Result<(), Self> {
        if input.len() == output.len() { Ok(()) } else { Err(Self { expected: input.len(), found: output.len() }) }
    }
}
