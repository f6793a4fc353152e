//! Errors of truncated systems.

use super::TruncatedSystem;
use libration_numbers::progress::Interrupted;

/// The reason why a truncated system cannot be set up or solved.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum TruncatedSystemError {
    /// g₁ ≤ 0.
    #[error("the force has no linear term that pulls back to the equilibrium")]
    NotRestoring,
    /// An even power in the force.
    #[error("the force has a term in x^{power}; odd harmonics alone need an odd force")]
    EvenTerm {
        /// The exponent.
        power: usize,
    },
    /// Only the linear term.
    #[error("up to x^{degree} the force is linear; keep at least its next term")]
    Linear {
        /// Degree at which the force was cut off.
        degree: usize,
    },
    /// No harmonic, or too many solutions.
    #[error(
        "{harmonics} harmonics and a force of degree {degree} have too many solutions: give at least one harmonic, and \
         few enough that the number of solutions, 1 + {degree} + {degree}^2 + ... with a term for each, is at most {}",
        TruncatedSystem::MAX_SOLUTIONS
    )]
    Size {
        /// Number of harmonics.
        harmonics: u32,
        /// The degree of the force.
        degree: usize,
    },
    /// Not a positive finite number.
    #[error("the amplitude is {amplitude:?}; it must be positive and finite")]
    Amplitude {
        /// The amplitude that was given.
        amplitude: f64,
    },
    /// Some solutions were not found.
    #[error(
        "{found} of the {expected} solutions were found; if some coincide, try a slightly different amplitude"
    )]
    Missing {
        /// Number of solutions found.
        found: usize,
        /// Number of solutions that exist.
        expected: usize,
    },
    /// Cancellation by the caller.
    #[error(transparent)]
    Interrupted(#[from] Interrupted),
}
