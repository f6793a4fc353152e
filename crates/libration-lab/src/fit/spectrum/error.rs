//! Why a trace has no harmonics to tell.

use crate::fit::cycles::{BeyondATurn, CyclesError};
use libration::watch::Interrupted;

/// Why a trace has no harmonics to tell.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SpectrumError {
    /// It shows no cycles, by which the phase is counted.
    #[error(transparent)]
    Cycles(#[from] CyclesError),
    /// The angle goes to and fro by more than a turn.
    #[error(transparent)]
    BeyondATurn(#[from] BeyondATurn),
    /// Less than a window of swings.
    #[error("{swings:.1} swings are too few to tell harmonics from noise: give at least {needed}")]
    TooShort {
        /// How many the trace has.
        swings: f64,
        /// How many would do.
        needed: usize,
    },
    /// Windows of fewer swings than can be told from noise.
    #[error(
        "windows of {0} swings are too short to tell harmonics from noise: ask for {FEWEST_SWINGS} or more"
    )]
    ShortWindows(usize),
    /// No harmonics asked for.
    #[error("no harmonics are asked for: ask for one or more")]
    NoHarmonics,
    /// No part of the trace that is sampled well enough, or swings far enough above the noise.
    #[error(
        "no window of swings can be used, of {windows} tried: rows are missing, or what swings is lost in noise; give a part of \
         the trace with clear swings, or fewer harmonics"
    )]
    NoWindow {
        /// How many there are.
        windows: usize,
    },
    /// The callback said so.
    #[error(transparent)]
    Interrupted(#[from] Interrupted),
}

/// Harmonics are told from the noise between them, for which windows need so many swings.
pub(super) const FEWEST_SWINGS: usize = 3;
