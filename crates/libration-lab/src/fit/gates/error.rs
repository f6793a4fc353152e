//! Reasons why times of a photogate do not determine a period.

use libration::progress::Interrupted;

/// Reasons why times of a photogate do not determine a period.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GatesError {
    /// Columns of different lengths.
    #[error("there are {times} times but {states} states of the gate: give one state for each time")]
    Lengths {
        /// Number of times.
        times: usize,
        /// Number of states.
        states: usize,
    },
    /// A number that is not finite.
    #[error("the time {0} is not a finite number: leave the row out")]
    NotFinite(f64),
    /// Fewer passages than two full swings need.
    #[error(
        "{passages} passages of the gate are too few: a pendulum passes twice in a period, and two periods are needed"
    )]
    TooFew {
        /// Number of passages that were found.
        passages: usize,
    },
    /// The passages follow each other as no pendulum does.
    #[error(
        "the passages do not follow each other as a pendulum's do: of {passages} only {accepted} begin a whole \
         period; check that the times are those of one gate, in order, and their unit"
    )]
    Irregular {
        /// Number of passages that were found.
        passages: usize,
        /// Number of passages that begin a whole period of one pendulum.
        accepted: usize,
    },
    /// Cancellation by the caller.
    #[error(transparent)]
    Interrupted(#[from] Interrupted),
    /// An impossible width or amplitude.
    #[error("the {name} is {value}: give a finite number above zero{below}")]
    NotUsable {
        /// Name of the quantity.
        name: &'static str,
        /// The given value.
        value: f64,
        /// An upper limit, if there is one.
        below: &'static str,
    },
}
