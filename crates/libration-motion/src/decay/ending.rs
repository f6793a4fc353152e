//! The end of the swings of a damped pendulum.

/// The reason why no turning point follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum DecayEnding {
    /// Dry friction holds the pendulum at its turning point, or stops it on its way down.
    Sticks,
    /// The damping is too strong for a swing: the pendulum creeps towards the bottom, and
    /// has not turned by ω0t = 1000 after its last turning point, or within 20 000 steps.
    Creeps,
    /// The amplitude is below 1e-100 rad.
    Vanishes,
}
