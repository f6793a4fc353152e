//! The initial guess of Newton's method.

/// A guess of an orbit.
#[derive(Clone, Debug, PartialEq)]
pub struct OrbitGuess {
    /// A state on the orbit: coordinates, then velocities.
    pub state: Vec<f64>,
    /// The period.
    pub period: f64,
}
