//! Errors of following a nonlinear mode.

use libration_motion::orbit::OrbitError;
use libration_numbers::progress::Interrupted;

/// Reason why a mode cannot be followed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum NonlinearModeError {
    /// The number of a mode that does not exist.
    #[error("there is no mode {wanted}: give 1 to {modes}")]
    NoMode {
        /// The requested number, from 1.
        wanted: usize,
        /// The number of modes.
        modes: usize,
    },
    /// A mode that does not oscillate, or that shares its frequency with another one.
    #[error("mode {0} does not oscillate, or shares its frequency with another one: choose another mode")]
    NotOscillating(usize),
    /// A coordinate that stays at rest in the mode.
    #[error(
        "the coordinate `{0}` stays at rest in this mode: its amplitude must be that of another coordinate"
    )]
    AtRest(String),
    /// Amplitudes that are not positive or not ascending.
    #[error("the amplitude {0:?} is not positive or not in order: give positive numbers in ascending order")]
    Amplitudes(f64),
    /// Cancellation by the caller.
    #[error(transparent)]
    Interrupted(#[from] Interrupted),
}

/// Loss of a mode on the way to larger amplitudes.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("the mode could not be continued beyond the amplitude {reached}: {reason}")]
pub struct LostMode {
    /// The largest amplitude that was reached.
    pub reached: f64,
    /// Reason why the next orbit was not found.
    pub reason: Reason,
}

/// Reason why the next orbit was not found.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Reason {
    /// The search failed.
    #[error(transparent)]
    NoOrbit(#[from] OrbitError),
    /// The orbit found belongs to another family.
    #[error("the orbits found are not close to the previous ones")]
    Jump,
    /// The period is not determined because of rounding errors.
    #[error(
        "the period found, {period:.4}, has an error of up to {uncertainty:.1e}, as next to an unstable equilibrium, where it grows without \
         bound: give a smaller amplitude"
    )]
    Unsure {
        /// The period of the orbit.
        period: f64,
        /// The error of the period; NaN if the orbit does not determine it.
        uncertainty: f64,
    },
    /// A turning point that is not the farthest position of the coordinate.
    #[error(
        "released from {amplitude} the coordinate comes to {displacement} on the same side, so that this is not its amplitude: give a smaller one"
    )]
    Farther {
        /// The displacement at the release.
        amplitude: f64,
        /// The largest displacement on the same side.
        displacement: f64,
    },
    /// Several repetitions of a shorter orbit.
    #[error("the orbit found consists of {0} turns of a shorter one: give a smaller amplitude")]
    Repetition(u32),
}

impl Reason {
    /// Returns `true` if the reason is more specific than a failed search.
    pub(super) const fn is_telling(&self) -> bool {
        !matches!(self, Self::Jump | Self::NoOrbit(OrbitError::NoConvergence { .. } | OrbitError::Period(_)))
    }
}
