//! The result of an integration.

use super::Occurrence;

/// A time and the state at it: coordinates, then velocities.
#[derive(Clone, Debug, PartialEq)]
pub struct Moment {
    /// The time.
    pub time: f64,
    /// The components named by [`System::state_names`](super::System::state_names).
    pub state: Vec<f64>,
}

/// The result of an integration.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// The states at the requested times that were reached.
    pub samples: Vec<Moment>,
    /// The events during the motion, in the order in which they happened.
    pub events: Vec<Occurrence>,
    /// The last state: at the end of the last step, or at an event that ended the integration.
    pub end: Moment,
    /// Number of steps taken.
    pub steps: usize,
}
