//! Where Newton's method begins.

/// A guess of an orbit.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct OrbitGuess {
    /// A state on it: coordinates, then velocities.
    pub state: Vec<f64>,
    /// Its period.
    pub period: f64,
}
