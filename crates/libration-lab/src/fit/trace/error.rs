//! Errors of a fit of traces.

use super::ParameterKind;

/// Reasons why traces cannot be fitted; traces and rows are counted from one.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum TraceFitError {
    /// No trace at all.
    #[error("there is no trace: give at least one")]
    NoTrace,
    /// Fewer rows than the parameters need.
    #[error("give at least {needed} rows of {name}: {rows} cannot determine {parameters} parameters")]
    TooFewRows {
        /// Name of the trace.
        name: String,
        /// Number of its rows.
        rows: usize,
        /// Number of parameters.
        parameters: usize,
        /// Number of rows that are needed.
        needed: usize,
    },
    /// Two traces with the same rows, which would count as twice as many measurements.
    #[error("{first} and {second} have the same rows: give each recording once")]
    SameRows {
        /// The name of the first trace.
        first: String,
        /// The name of the second trace.
        second: String,
    },
    /// Neither the equation of a pendulum nor a sine describes any part of the trace.
    #[error(
        "{name} does not look like a pendulum: the equation of motion holds in no part of it; check the columns and the \
         units of angle and time, and give at least one whole swing with six rows or more in each"
    )]
    NoPendulum {
        /// Name of the trace.
        name: String,
    },
    /// The angle goes to and fro by more than a turn.
    #[error("{0}")]
    BeyondATurn(#[from] crate::fit::cycles::BeyondATurn),
    /// The motion cannot be computed from the start of the search.
    #[error("the motion cannot be followed from omega0 = {omega0} rad/s: check the units of angle and time")]
    NoMotion {
        /// Angular frequency in rad/s.
        omega0: f64,
    },
    /// The best motion does not describe the data.
    #[error(
        "the best motion of the model leaves {percent:.0} % of the variance of the data unexplained: choose another \
         model, leave out whatever is not a free swing, or check the columns and the units of angle and time"
    )]
    Unexplained {
        /// Share of the variance in per cent.
        percent: f64,
    },
    /// The data do not determine a parameter.
    #[error("the data do not determine {}: choose a model without it, or measure more of the swing", .parameter.name())]
    Undetermined {
        /// The kind of the parameter.
        parameter: ParameterKind,
    },
    /// Cancellation by the caller.
    #[error("the fit was interrupted")]
    Interrupted,
}
