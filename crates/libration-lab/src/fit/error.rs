//! Errors of a fit.

use super::budget::BudgetError;

/// Reasons why a table cannot be fitted; rows are counted from one.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FitError {
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
    /// An amplitude that no libration has.
    #[error("row {row}: the amplitude {amplitude:?} rad is not below pi: check the unit of the amplitudes")]
    Amplitude {
        /// Row, counted from one.
        row: usize,
        /// Amplitude in radians.
        amplitude: f64,
    },
    /// A period that is not a positive finite number.
    #[error("row {row}: the period {period:?} s is not a positive number: remove the row")]
    Period {
        /// Row, counted from one.
        row: usize,
        /// Period in seconds.
        period: f64,
    },
    /// A number that is not a standard deviation.
    #[error("row {row}: the uncertainty {uncertainty:?} of the {of} is not usable: {hint}")]
    Uncertainty {
        /// Row, counted from one.
        row: usize,
        /// Name of the quantity: amplitude or period.
        of: &'static str,
        /// Uncertainty as given.
        uncertainty: f64,
        /// Description of a usable value.
        hint: &'static str,
    },
    /// Fewer rows than needed for the parameters, and for the scatter where it is needed.
    #[error("give at least {needed} rows: {rows} cannot determine {parameters} and its uncertainty")]
    TooFewRows {
        /// Number of rows.
        rows: usize,
        /// Number of rows that are needed.
        needed: usize,
        /// Parameters that are to be determined.
        parameters: &'static str,
    },
    /// All amplitudes have the same period ratio.
    #[error("all amplitudes are the same, which does not determine beta: measure at different amplitudes")]
    EqualAmplitudes,
    /// A law that has no positive finite value at a measured amplitude.
    #[error("the law `{key}` has no value at the amplitude {amplitude:?} rad: leave out the law or the row")]
    LawUndefined {
        /// Key of the law.
        key: String,
        /// Amplitude in radians.
        amplitude: f64,
    },
    /// The weights did not settle.
    #[error(
        "the iteration of the weights of {0} did not converge: check the uncertainties of the amplitudes"
    )]
    NoConvergence(&'static str),
    /// A number that is not a length, or not its uncertainty.
    #[error(
        "a length of {value:?} ± {uncertainty:?} m is not usable: give a positive length and an uncertainty of at least zero"
    )]
    Length {
        /// Length in metres.
        value: f64,
        /// Standard uncertainty in metres.
        uncertainty: f64,
    },
    /// The only negative length of a table of a simple pendulum.
    #[error(
        "row {row}: the length {length:?} m is negative, and the periods are those of a simple pendulum with {positive:?} m: correct the sign, or fit a bar turned \
         about both sides"
    )]
    SignOfLength {
        /// Row, counted from one.
        row: usize,
        /// Length in metres.
        length: f64,
        /// The absolute value.
        positive: f64,
    },
    /// A length in a table that is not a positive finite number.
    #[error(
        "row {row}: the length {length:?} m is not a positive number: remove the row, or fit a bar turned about both sides"
    )]
    LengthOfRow {
        /// Row, counted from one.
        row: usize,
        /// Length in metres.
        length: f64,
    },
    /// A number that is not an uncertainty of the clock.
    #[error("a relative uncertainty of the clock of {0} is not usable: give a finite number of zero or more")]
    Clock(f64),
    /// Lengths that do not separate g from their offset.
    #[error(
        "the lengths are all the same, which does not determine their offset: measure with different lengths"
    )]
    EqualLengths,
    /// A reversible pendulum with other than two knife edges.
    #[error(
        "a reversible pendulum has two distances from the centre of mass to the knife edges, and the table has {count}: give each row one of two"
    )]
    KnifeEdges {
        /// Number of different distances.
        count: usize,
    },
    /// A reversible pendulum whose periods have no uncertainties.
    #[error("the periods of a reversible pendulum have no scatter about a law: give their uncertainties")]
    KnifeEdgePeriods,
    /// Distances of both knife edges that are too nearly equal.
    #[error(
        "the distances from the centre of mass to the knife edges differ by {difference:.4} ± {uncertainty:.4} m, and Bessel's formula divides by that: measure the centre of mass better, or move the edges further from equal distances"
    )]
    CentreOfMass {
        /// Difference of the distances, in metres.
        difference: f64,
        /// Its standard uncertainty, in metres.
        uncertainty: f64,
    },
    /// A bar whose positions do not determine the law.
    #[error(
        "the periods do not follow T²h = 4π²(k² + h²)/g at distances h from a centre of mass: check the positions, and give more of them"
    )]
    NoBar,
    /// Periods that do not rise with the lengths as those of one kind of pendulum do.
    #[error(
        "the periods do not follow the lengths as T² = 4π²(L + δ)/g: a rod that is turned about points on both sides of its centre is not a simple \
         pendulum of these lengths"
    )]
    PeriodsWithoutLength,
    /// A bob that reaches the pivot where the lengths, with their offset, are shortest.
    #[error(
        "a bob of radius {radius:?} m reaches the pivot of the shortest pendulum, whose centre the periods put at most \
         {distance:.4} m below it: check the radius and the unit of the lengths"
    )]
    BobTooLarge {
        /// Radius in metres.
        radius: f64,
        /// Largest distance from the pivot to the centre of the bob, in metres.
        distance: f64,
    },
    /// A bob with which the periods do not determine the offset: no value of it agrees with them, or several do.
    #[error(
        "with a bob of radius {radius:?} m, which nearly reaches the pivot, the periods do not determine the offset of the lengths: \
         check the radius"
    )]
    BobRadius {
        /// Radius in metres.
        radius: f64,
    },
    /// Corrections of g that are impossible, or lack an input.
    #[error(transparent)]
    Corrections(#[from] BudgetError),
    /// Corrections with which a row has no pendulum.
    #[error(
        "a pendulum of the table is too short or too fast for these corrections: check the stiffness of the support, and the units"
    )]
    CorrectionsOfRow,
    /// Corrections that change the law so much that the rounds do not settle g.
    #[error(
        "the corrections change the law of the table so much that g does not settle: check their sizes and units, such as that of the knife edge"
    )]
    CorrectionsTooLarge,
}
