//! Errors of quantities, as numbers or as text.

use super::Dimension;

/// Reason why a text is not the required quantity, or a number is not an angle.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum QuantityError {
    /// An angle that is not finite, or too large for its turns to be counted.
    #[error("{0:?} is not a usable angle: give a finite angle of at most 2^53 rad")]
    NotAnAngle(f64),
    /// A complement outside [0, π].
    #[error("{0:?} is not the complement of an angle: give a number of radians from 0 to pi")]
    NotAComplement(f64),
    /// Text that does not follow the grammar of angles.
    #[error("cannot read `{text}` as an angle: {hint}")]
    UnreadableAngle {
        /// The text, shortened.
        text: String,
        /// The remedy.
        hint: &'static str,
    },
    /// Text of an angle that is too large, or too close to zero or the top without being there.
    #[error("the angle `{text}` is out of range: {hint}")]
    AngleOutOfRange {
        /// The text, shortened.
        text: String,
        /// The remedy.
        hint: &'static str,
    },
    /// Text that is not a number with a unit.
    #[error("cannot read `{text}` as {dimension}: write {}", .dimension.examples())]
    UnreadableQuantity {
        /// The text, shortened.
        text: String,
        /// The expected dimension.
        dimension: Dimension,
    },
    /// An unknown unit.
    #[error("`{unit}` in `{text}` is not a unit of {dimension}: write {}", .dimension.examples())]
    UnknownUnit {
        /// The text, shortened.
        text: String,
        /// The unit, shortened.
        unit: String,
        /// The expected dimension.
        dimension: Dimension,
    },
    /// A decimal comma.
    #[error("`{text}` has a comma: write it with a decimal point, {with_point}")]
    DecimalComma {
        /// The text, shortened.
        text: String,
        /// The text with a decimal point.
        with_point: String,
    },
    /// A known unit of another dimension.
    #[error("`{text}` is {found}, not {dimension}: write {}", .dimension.examples())]
    WrongDimension {
        /// The text, shortened.
        text: String,
        /// The dimension of the unit.
        found: Dimension,
        /// The expected dimension.
        dimension: Dimension,
    },
    /// A value or an uncertainty beyond the range of `f64`, or a negative uncertainty.
    #[error("`{text}` is out of range for {dimension}: write {}", .dimension.examples())]
    QuantityOutOfRange {
        /// The text, shortened.
        text: String,
        /// The expected dimension.
        dimension: Dimension,
    },
}
