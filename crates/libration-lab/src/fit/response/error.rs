//! Errors of a fit of a response.

use super::ResponseModel;

/// Reasons why a response cannot be fitted; rows are counted from one.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ResponseFitError {
    /// Columns of different lengths.
    #[error("the {column} have {rows} rows, the frequencies {expected}: give one for each")]
    LengthMismatch {
        /// Name of the column.
        column: &'static str,
        /// Number of its rows.
        rows: usize,
        /// Number of rows of the frequencies.
        expected: usize,
    },
    /// A frequency or an amplitude that is not a positive finite number.
    #[error("row {row}: the {of} {value:?} is not a positive number: remove the row")]
    NotPositive {
        /// Row, counted from one.
        row: usize,
        /// Name of the quantity: frequency or amplitude.
        of: &'static str,
        /// Value as given, in SI units.
        value: f64,
    },
    /// A phase that is not a finite number.
    #[error("row {row}: the phase {phase:?} is not a finite number: remove the row")]
    Phase {
        /// Row, counted from one.
        row: usize,
        /// Phase in radians.
        phase: f64,
    },
    /// A number that is not a standard deviation.
    #[error("row {row}: the uncertainty {uncertainty:?} of the {of} is not usable: {hint}")]
    Uncertainty {
        /// Row, counted from one.
        row: usize,
        /// Name of the quantity: frequency, amplitude or phase.
        of: &'static str,
        /// Uncertainty as given.
        uncertainty: f64,
        /// Description of a usable value.
        hint: &'static str,
    },
    /// Phases whose uncertainties are given, where those of the amplitudes are not, or the other way round.
    #[error("uncertainties of the {given} are given and of the {missing} are not: give both, or neither")]
    OneUncertainty {
        /// Quantity with uncertainties.
        given: &'static str,
        /// Quantity without uncertainties.
        missing: &'static str,
    },
    /// Stated uncertainties are required, but none are given.
    #[error(
        "no uncertainties of the amplitudes are given: give a column of them, or absolute or relative errors"
    )]
    NoUncertainties,
    /// Fewer rows than needed for the parameters, and for the scatter where it is needed.
    #[error(
        "give at least {needed} rows: {rows} cannot determine the {parameters} parameters of a {model} response"
    )]
    TooFewRows {
        /// Number of rows.
        rows: usize,
        /// Number of rows that are needed.
        needed: usize,
        /// Number of parameters of the model.
        parameters: usize,
        /// The model.
        model: ResponseModel,
    },
    /// An amplitude that no swing of a pendulum has.
    #[error(
        "row {row}: the amplitude {amplitude:?} rad is not below pi, and no pendulum swings so: check the unit of the amplitudes"
    )]
    Amplitude {
        /// Row, counted from one.
        row: usize,
        /// Amplitude in radians.
        amplitude: f64,
    },
    /// Rows that do not determine a parameter.
    #[error(
        "the rows do not determine the parameters of a {0} response: measure frequencies on both sides of the resonance and close to it, or \
         phases too"
    )]
    Undetermined(ResponseModel),
    /// No parameters at which the search converges.
    #[error(
        "no {0} response close to the rows was found: the search did not converge from any of its starts"
    )]
    NoConvergence(ResponseModel),
    /// Cancellation by the caller.
    #[error("interrupted before a fit was found")]
    Interrupted,
}
