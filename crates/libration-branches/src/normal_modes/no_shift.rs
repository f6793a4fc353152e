//! Reasons for the absence of a change of frequency with the amplitude.

use super::lindstedt::ModeObstacle;

/// Reason why the change of frequency is not computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ShiftError {
    /// A mode that does not oscillate.
    #[error("it does not oscillate with a constant amplitude")]
    NotOscillating,
    /// Several motions with the same frequency.
    #[error(
        "several motions have this frequency (1:1): the linear equations do not determine which of their combinations stay periodic at larger amplitudes"
    )]
    Degenerate,
    /// A resonance with an exchange of energy at every amplitude.
    #[error(
        "another mode has {0} times this frequency (resonance {0}:1), and the motion drives it: the two exchange energy at any amplitude, which no series in a² describes"
    )]
    Resonance(usize),
    /// A steady force without a restoring force.
    #[error("the oscillation exerts a steady force on a mode without a restoring force")]
    Drift,
    /// Damping or excitation that grows with the amplitude.
    #[error("the amplitude {} by the nonlinear terms: there is no periodic motion", if *grows { "grows" } else { "shrinks" })]
    NotPeriodic {
        /// `true` if the amplitude grows.
        grows: bool,
    },
    /// Forces without a third derivative.
    #[error("the accelerations are not smooth enough at the equilibrium")]
    NotSmooth,
}

impl From<ModeObstacle> for ShiftError {
    fn from(obstacle: ModeObstacle) -> Self {
        match obstacle {
            ModeObstacle::NoSeries => Self::NotSmooth,
            ModeObstacle::Resonance(0) => Self::Drift,
            ModeObstacle::Resonance(1) => Self::Degenerate,
            ModeObstacle::Resonance(k) => Self::Resonance(k),
        }
    }
}
