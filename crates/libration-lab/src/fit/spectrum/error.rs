//! Reasons why a trace has no measurable harmonics.

use crate::fit::cycles::{BeyondATurn, CyclesError};
use libration::progress::Interrupted;

/// Reasons why a trace has no measurable harmonics.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SpectrumError {
    /// No cycles, by which the phase is counted.
    #[error(transparent)]
    Cycles(#[from] CyclesError),
    /// The angle goes to and fro by more than a turn.
    #[error(transparent)]
    BeyondATurn(#[from] BeyondATurn),
    /// A trace shorter than a window of swings.
    #[error("{swings:.1} swings are too few to separate harmonics from noise: give at least {needed}")]
    TooShort {
        /// Number of swings in the trace.
        swings: f64,
        /// Number of swings that are needed.
        needed: usize,
    },
    /// Windows of fewer swings than separate harmonics from noise.
    #[error(
        "windows of {0} swings are too short to separate harmonics from noise: give {FEWEST_SWINGS} or more"
    )]
    ShortWindows(usize),
    /// A request for no harmonics.
    #[error("no harmonics are requested: give one or more")]
    NoHarmonics,
    /// No part of the trace is sampled well enough, or has swings far enough above the noise.
    #[error(
        "none of {windows} windows of swings can be used: rows are missing, or the swing is lost in noise; give a part of \
         the trace with clear swings, or fewer harmonics"
    )]
    NoWindow {
        /// Number of windows.
        windows: usize,
    },
    /// Cancellation by the caller.
    #[error(transparent)]
    Interrupted(#[from] Interrupted),
}

/// Fewest swings in a window that separate harmonics from the noise between them.
pub(super) const FEWEST_SWINGS: usize = 3;
