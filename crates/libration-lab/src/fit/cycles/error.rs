//! Reasons why a trace has no cycles to measure.

use libration::progress::Interrupted;

/// Reasons why a trace has no cycles to measure.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CyclesError {
    /// Too few rows to see a swing in.
    #[error("{0} rows are too few to detect a swing: give at least 12, from one full swing or more")]
    TooFewRows(usize),
    /// All values are the same.
    #[error("all values of the trace are {0}: nothing swings")]
    NothingSwings(f64),
    /// Less than a full cycle between passages of the centre.
    #[error(
        "the trace shows {} between passages of the centre, {}: \
         record for longer, or give the part where the pendulum swings freely",
        counted(*turning_points, "turning point"),
        if *turning_points < 2 { "but a full cycle takes two" } else { "but no full cycle that can be measured" }
    )]
    TooShort {
        /// Turning points that have a passage of the centre before and after them.
        turning_points: usize,
    },
    /// Passages and turning points too thinly sampled to be placed.
    #[error(
        "about {rows_per_period:.1} rows in a period are too few to place passages and turning points: \
         sample at least 8 times in a period"
    )]
    TooCoarse {
        /// Rows in a period.
        rows_per_period: f64,
    },
    /// The pendulum goes over the top all the time.
    #[error(
        "the pendulum goes over the top all the time: cycles to and fro are needed, give a later part of the trace"
    )]
    OnlyRotations,
    /// Cycles whose amplitudes are all the same, or fewer than three of them.
    #[error(
        "{} of nearly the same amplitude do not determine beta: record until the amplitude has fallen, or \
         begin with a larger one",
        counted(*cycles, "cycle")
    )]
    EqualAmplitudes {
        /// Number of cycles.
        cycles: usize,
    },
    /// Amplitudes whose noise is so large compared with their change that β would be drawn towards 0.
    #[error(
        "the amplitudes change by too little compared with their noise, which is {:.0} % of the variance of T/T0, and would draw \
         beta towards 0: record until the amplitude has fallen, or begin with a larger one",
        100.0 * noise_part.min(1.0)
    )]
    NoisyAmplitudes {
        /// Fraction of the variance of T/T0 that is noise of the amplitudes.
        noise_part: f64,
    },
    /// Cancellation by the caller.
    #[error(transparent)]
    Interrupted(#[from] Interrupted),
    /// Too few extremes to determine the fall of the amplitude.
    #[error("{} are too few to determine the damping: record at least {needed}", counted(*count, "turning point"))]
    TooFewHalfSwings {
        /// Number of extremes that were found.
        count: usize,
        /// Number of extremes that are needed.
        needed: usize,
    },
}

/// `1 cycle`, `2 cycles`.
pub(super) fn counted(count: usize, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}
