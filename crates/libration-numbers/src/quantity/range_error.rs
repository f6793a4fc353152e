//! Errors in the text of a range.

use super::QuantityError;

/// Largest number of elements, which fits into memory.
pub(super) const MOST_ELEMENTS: u64 = 10_000_000;

/// Reason why a text is not a range.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RangeError {
    /// A text without three parts.
    #[error("cannot read `{0}` as a range: write START:STOP:STEP, as in {1}")]
    NotThreeParts(String, &'static str),
    /// Bare numbers together with those with a unit.
    #[error(
        "`{0}` mixes numbers with a unit and without: write the unit of each, as in 1deg:179deg:1deg or 1rad,2rad, and decimals with a point"
    )]
    MixedUnits(String),
    /// A step of zero.
    #[error("the step of the range `{0}` is zero: give one that leads from start to stop")]
    ZeroStep(String),
    /// A step that leads away from the stop.
    #[error("the step of the range `{0}` leads away from its stop: change its sign")]
    WrongSign(String),
    /// More elements than allowed.
    #[error("the range `{0}` has more than {MOST_ELEMENTS} elements: give a larger step")]
    TooMany(String),
    /// An error in one of the parts, or in an element of a list.
    #[error(transparent)]
    Part(#[from] QuantityError),
}
