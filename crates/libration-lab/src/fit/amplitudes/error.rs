//! Errors of a fit of amplitudes.

use crate::fit::damping_model::DampingModel;

/// Reasons why a table of amplitudes cannot be fitted; rows are counted from one.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum AmplitudesError {
    /// Columns of different lengths.
    #[error("the {column} have {rows} rows, the amplitudes {expected}: give one for each")]
    LengthMismatch {
        /// Name of the column.
        column: &'static str,
        /// Number of its rows.
        rows: usize,
        /// Number of rows of the amplitudes.
        expected: usize,
    },
    /// A value that is not a finite number.
    #[error("row {row}: the {of} {value:?} is not a finite number: remove the row")]
    NotFinite {
        /// Row, counted from one.
        row: usize,
        /// Name of the quantity.
        of: &'static str,
        /// Value as given.
        value: f64,
    },
    /// An amplitude that no swing has.
    #[error("row {row}: the angle {value:?} rad is not between -pi and pi: check the unit of the amplitudes")]
    Angle {
        /// Row, counted from one.
        row: usize,
        /// Angle in radians.
        value: f64,
    },
    /// A displacement larger than the length.
    #[error(
        "row {row}: a displacement of {value:?} m is not below the length {length:?} m: check the units of both"
    )]
    Displacement {
        /// Row, counted from one.
        row: usize,
        /// Displacement in metres.
        value: f64,
        /// Length of the pendulum in metres.
        length: f64,
    },
    /// A number that is not a standard deviation.
    #[error("row {row}: the uncertainty {uncertainty:?} of the {of} is not usable: {hint}")]
    Uncertainty {
        /// Row, counted from one.
        row: usize,
        /// Name of the quantity.
        of: &'static str,
        /// Uncertainty as given.
        uncertainty: f64,
        /// Description of a usable value.
        hint: &'static str,
    },
    /// Relative errors of values that are zero or are counted from an unknown zero.
    #[error(
        "relative errors need amplitudes above zero, and not turning points of both sides: use absolute errors"
    )]
    RelativeErrors,
    /// A length that is not positive.
    #[error("a length of {0:?} m is not usable: give a positive length")]
    Length(f64),
    /// A period that is not positive, or an unusable uncertainty of it.
    #[error(
        "a period of {value:?} ± {uncertainty:?} s is not usable: give a positive period and an uncertainty of at least zero"
    )]
    Period {
        /// Period in seconds.
        value: f64,
        /// Standard uncertainty in seconds.
        uncertainty: f64,
    },
    /// A period in the table that is not positive.
    #[error("row {row}: the period {value:?} s is not a positive number: remove the row")]
    PeriodOfRow {
        /// Row, counted from one.
        row: usize,
        /// Period in seconds.
        value: f64,
    },
    /// A period where the table determines it.
    #[error(
        "the table determines the period: leave out the period, or the column of periods or numbers of swings"
    )]
    PeriodTwice,
    /// Fewer rows than needed for the parameters, and for the scatter where it is needed.
    #[error("give at least {needed} rows: {rows} cannot determine the damping and its uncertainty")]
    TooFewRows {
        /// Number of rows.
        rows: usize,
        /// Number of rows that are needed.
        needed: usize,
    },
    /// Turning points that are all on one side.
    #[error("the values are all on one side: turning points of both sides are needed for the scale's zero")]
    OneSide,
    /// Rows of one time.
    #[error("all rows have the same {0}: measure the amplitude at different ones")]
    EqualPositions(&'static str),
    /// An amplitude that does not fall.
    #[error(
        "the amplitude does not fall as by any damping: check the columns, and that turning points of both sides alternate"
    )]
    NotFalling,
    /// A law that the rows do not determine, or in which a coefficient is negative.
    #[error("the rows do not fit {0} damping with coefficients of zero or more: leave out the law")]
    Law(DampingModel),
}
