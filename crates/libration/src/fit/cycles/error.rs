//! Why a trace has no cycles to measure.

/// Why a trace has no cycles to measure.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CyclesError {
    /// Too few rows to see a swing in.
    #[error("{0} rows are too few to see a swing in: give at least 12, from one full swing or more")]
    TooFewRows(usize),
    /// All values are the same.
    #[error("all values of the trace are {0}: nothing swings")]
    NothingSwings(f64),
    /// Less than a full cycle between passages of the centre.
    #[error(
        "the trace shows {turning_points} turning points between passages of the centre, and a full cycle needs two: \
         record for longer, or give the part where the pendulum swings freely"
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
        "{cycles} cycles of nearly the same amplitude leave beta open: record until the amplitude has fallen, or \
         begin with a larger one"
    )]
    EqualAmplitudes {
        /// How many there are.
        cycles: usize,
    },
    /// Too few extremes to tell how the amplitude falls.
    #[error("{found} turning points tell nothing about the damping: record at least {needed}")]
    TooFewHalfSwings {
        /// How many there are.
        found: usize,
        /// How many would do.
        needed: usize,
    },
}
