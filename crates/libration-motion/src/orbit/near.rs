//! The starting point of Newton's method.

/// A guess of an orbit.
#[derive(Clone, Debug, PartialEq)]
pub struct OrbitGuess {
    /// A state on it: coordinates, then velocities.
    pub state: Vec<f64>,
    /// Its period.
    pub period: f64,
}
