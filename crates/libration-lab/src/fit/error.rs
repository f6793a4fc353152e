//! What can be wrong with a fit.

/// Why a table cannot be fitted; rows are counted from one.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FitError {
    /// Columns of different lengths.
    #[error("the {column} have {found} rows, the amplitudes {expected}: give one for each")]
    LengthMismatch {
        /// Which column.
        column: &'static str,
        /// Its rows.
        found: usize,
        /// The rows of the amplitudes.
        expected: usize,
    },
    /// An amplitude that no libration has.
    #[error("row {row}: the amplitude {amplitude:?} rad is not below pi: check the unit of the amplitudes")]
    Amplitude {
        /// Counted from one.
        row: usize,
        /// In radians.
        amplitude: f64,
    },
    /// A period that is not a positive finite number.
    #[error("row {row}: the period {period:?} s is not a positive number: remove the row")]
    Period {
        /// Counted from one.
        row: usize,
        /// In seconds.
        period: f64,
    },
    /// A standard deviation that is none.
    #[error("row {row}: the uncertainty {uncertainty:?} of the {of} is not usable: {hint}")]
    Uncertainty {
        /// Counted from one.
        row: usize,
        /// Of the amplitude or of the period.
        of: &'static str,
        /// As given.
        uncertainty: f64,
        /// What would do.
        hint: &'static str,
    },
    /// Fewer rows than the parameters, and the scatter where it is needed, ask for.
    #[error("give at least {needed} rows: {found} cannot determine {parameters} and its uncertainty")]
    TooFewRows {
        /// Rows.
        found: usize,
        /// Rows that would do.
        needed: usize,
        /// What is to be determined.
        parameters: &'static str,
    },
    /// All amplitudes have the same period ratio.
    #[error("all amplitudes are the same, which does not determine beta: measure at different amplitudes")]
    EqualAmplitudes,
    /// A law that has no positive finite value at a measured amplitude.
    #[error("the law `{key}` has no value at the amplitude {amplitude:?} rad: leave out the law or the row")]
    LawUndefined {
        /// Of the law.
        key: String,
        /// In radians.
        amplitude: f64,
    },
    /// The weights did not settle.
    #[error(
        "the iteration of the weights of {0} did not converge: check the uncertainties of the amplitudes"
    )]
    NoConvergence(&'static str),
    /// A length or its uncertainty that is none.
    #[error(
        "a length of {value:?} ± {uncertainty:?} m is not usable: give a positive length and an uncertainty of at least zero"
    )]
    Length {
        /// In metres.
        value: f64,
        /// In metres.
        uncertainty: f64,
    },
    /// A length in a table that is not a positive finite number.
    #[error("row {row}: the length {length:?} m is not a positive number: remove the row")]
    LengthOfRow {
        /// Counted from one.
        row: usize,
        /// In metres.
        length: f64,
    },
    /// An uncertainty of the clock that is none.
    #[error("a relative uncertainty of the clock of {0} is not usable: give a finite number of zero or more")]
    Clock(f64),
    /// Lengths that do not tell g from their offset.
    #[error(
        "the lengths are all the same, which does not determine their offset: measure with different lengths"
    )]
    EqualLengths,
    /// Periods that do not rise with the lengths as those of one kind of pendulum do.
    #[error(
        "the periods do not follow the lengths as T² = 4π²(L + δ)/g: a rod that is turned about points on both sides of its centre is no simple \
         pendulum of these lengths"
    )]
    PeriodsWithoutLength,
    /// A bob that reaches to the pivot where the lengths, with their offset, are shortest.
    #[error(
        "a bob of radius {radius:?} m reaches the pivot of the shortest pendulum, whose centre the periods put at most \
         {distance:.4} m below it: check the radius and the unit of the lengths"
    )]
    BobTooLarge {
        /// In metres.
        radius: f64,
        /// From the pivot to the centre of the bob at most, in metres.
        distance: f64,
    },
    /// A bob with which the periods leave the offset open: none or several go with them.
    #[error(
        "with a bob of radius {radius:?} m, which nearly reaches the pivot, the periods do not determine the offset of the lengths: \
         check the radius"
    )]
    BobRadius {
        /// In metres.
        radius: f64,
    },
}
