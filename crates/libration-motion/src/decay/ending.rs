//! The end of the swings of a damped pendulum.

/// The reason why no turning point follows.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum DecayEnding {
    /// Dry friction holds the pendulum at its turning point.
    Sticks,
    /// Dry friction stops the pendulum on its way down from its last turning point.
    StopsOnTheWay {
        /// The time at which it comes to rest, in seconds after the release.
        time: f64,
        /// Its distance from the bottom then, in radians, on the side of the last turning point.
        angle: f64,
    },
    /// The damping is too strong for a swing: the pendulum creeps towards the bottom, and
    /// has not turned by ω0t = 1000 after its last turning point, or within 20 000 steps.
    Creeps,
    /// The amplitude is below 1e-100 rad.
    Vanishes,
}
