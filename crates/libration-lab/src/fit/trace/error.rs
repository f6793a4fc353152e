//! What can be wrong with a fit of traces.

/// Why traces cannot be fitted; traces and rows are counted from one.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TraceFitError {
    /// No trace at all.
    #[error("there is no trace: give at least one")]
    NoTrace,
    /// Fewer rows than the parameters ask for.
    #[error("give at least {needed} rows of {name}: {rows} cannot determine {parameters} parameters")]
    TooFewRows {
        /// Whose.
        name: String,
        /// How many there are.
        rows: usize,
        /// How many are to be found.
        parameters: usize,
        /// How many rows would do.
        needed: usize,
    },
    /// Two traces with the same rows, which would count as twice as many measurements.
    #[error("{first} and {second} have the same rows: give each recording once")]
    SameRows {
        /// The name of one.
        first: String,
        /// The name of the other.
        second: String,
    },
    /// No window of the trace obeys the equation of a pendulum.
    #[error(
        "{name} does not look like a pendulum: the equation of motion holds in no part of it; check the columns and the \
         units of angle and time, and give at least one whole swing with six rows or more in each"
    )]
    NoPendulum {
        /// Whose.
        name: String,
    },
    /// The angle goes to and fro by more than a turn.
    #[error("{0}")]
    BeyondATurn(#[from] crate::fit::cycles::BeyondATurn),
    /// The motion cannot be computed from where the search began.
    #[error("the motion cannot be followed from omega0 = {omega0} rad/s: check the units of angle and time")]
    NoMotion {
        /// In rad/s.
        omega0: f64,
    },
    /// The best motion is not what was seen.
    #[error(
        "the best motion of the model leaves {percent:.0} % of the variance of the data unexplained: choose another \
         model, leave out whatever is not a free swing, or check the columns and the units of angle and time"
    )]
    Unexplained {
        /// Of the variance.
        percent: f64,
    },
    /// The data say nothing about a parameter.
    #[error("the data do not determine {parameter}: choose a model without it, or measure more of the swing")]
    Undetermined {
        /// Its name.
        parameter: &'static str,
    },
    /// The callback said so.
    #[error("the fit was interrupted")]
    Interrupted,
}
