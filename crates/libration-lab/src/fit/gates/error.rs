//! Why times of a photogate tell no period.

use libration::watch::Interrupted;

/// Why times of a photogate tell no period.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GatesError {
    /// Columns of different lengths.
    #[error("there are {times} times but {states} states of the gate: give one state for each time")]
    Lengths {
        /// Times.
        times: usize,
        /// States.
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
        /// That were found.
        passages: usize,
    },
    /// The passages follow each other as no pendulum does.
    #[error(
        "the passages do not follow each other as a pendulum's do: of {passages} only {accepted} begin a whole \
         period; check that the times are those of one gate, in order, and their unit"
    )]
    Irregular {
        /// That were found.
        passages: usize,
        /// That begin a whole period of one pendulum.
        accepted: usize,
    },
    /// The callback said so.
    #[error(transparent)]
    Interrupted(#[from] Interrupted),
    /// A width or an amplitude that cannot be.
    #[error("the {name} is {value}: give a finite number above zero{below}")]
    NotUsable {
        /// Which one.
        name: &'static str,
        /// What was got.
        value: f64,
        /// A limit from above, if there is one.
        below: &'static str,
    },
}
