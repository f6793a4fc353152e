//! What can be wrong with a fit of a response.

use super::ResponseModel;

/// Why a response cannot be fitted; rows are counted from one.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ResponseFitError {
    /// Columns of different lengths.
    #[error("the {column} have {found} rows, the frequencies {expected}: give one for each")]
    LengthMismatch {
        /// Which column.
        column: &'static str,
        /// Its rows.
        found: usize,
        /// The rows of the frequencies.
        expected: usize,
    },
    /// A frequency or an amplitude that is not a positive finite number.
    #[error("row {row}: the {of} {value:?} is not a positive number: remove the row")]
    NotPositive {
        /// Counted from one.
        row: usize,
        /// Frequency or amplitude.
        of: &'static str,
        /// As given, in SI units.
        value: f64,
    },
    /// A phase that is no finite number.
    #[error("row {row}: the phase {phase:?} is not a finite number: remove the row")]
    Phase {
        /// Counted from one.
        row: usize,
        /// In radians.
        phase: f64,
    },
    /// A standard deviation that is none.
    #[error("row {row}: the uncertainty {uncertainty:?} of the {of} is not usable: {hint}")]
    Uncertainty {
        /// Counted from one.
        row: usize,
        /// Of the frequency, the amplitude or the phase.
        of: &'static str,
        /// As given.
        uncertainty: f64,
        /// What would do.
        hint: &'static str,
    },
    /// Phases whose uncertainties are given, where those of the amplitudes are not, or the other way.
    #[error("uncertainties of the {given} are given and of the {missing} are not: give both, or neither")]
    OneUncertainty {
        /// What has them.
        given: &'static str,
        /// What has not.
        missing: &'static str,
    },
    /// Stated uncertainties are asked for, and none are given.
    #[error(
        "no uncertainties of the amplitudes are given: give a column of them, or absolute or relative errors"
    )]
    NoUncertainties,
    /// Fewer rows than the parameters, and the scatter where it is needed, ask for.
    #[error(
        "give at least {needed} rows: {found} cannot determine the {parameters} parameters of a {model} response"
    )]
    TooFewRows {
        /// Rows.
        found: usize,
        /// Rows that would do.
        needed: usize,
        /// Of the model.
        parameters: usize,
        /// Which one.
        model: ResponseModel,
    },
    /// An amplitude that no swing of a pendulum has.
    #[error(
        "row {row}: the amplitude {amplitude:?} rad is not below pi, and no pendulum swings so: check the unit of the amplitudes"
    )]
    Amplitude {
        /// Counted from one.
        row: usize,
        /// In radians.
        amplitude: f64,
    },
    /// Rows that leave a parameter open.
    #[error(
        "the rows leave the parameters of a {0} response open: measure frequencies on both sides of the resonance and close to it, or \
         phases too"
    )]
    Undetermined(ResponseModel),
    /// No parameters with which the search ends.
    #[error(
        "no {0} response was found that comes close to the rows: the search ended nowhere from any of its starts"
    )]
    NoConvergence(ResponseModel),
    /// It was stopped.
    #[error("interrupted before a fit was found")]
    Interrupted,
}
