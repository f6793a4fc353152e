//! What can be wrong with a quantity, as a number or as text.

/// Why a text is not the quantity it should be, or a number not an angle.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum QuantityError {
    /// Not finite, or too large for its turns to be counted.
    #[error("{0} is not a usable angle: give a finite angle of at most 2^53 rad")]
    NotAnAngle(f64),
    /// Not within [0, π].
    #[error("{0} is not the complement of an angle: give a number of radians from 0 to pi")]
    NotAComplement(f64),
    /// Text that does not follow the grammar of angles.
    #[error("cannot read `{text}` as an angle: {hint}")]
    UnreadableAngle {
        /// The text, shortened.
        text: String,
        /// What would do.
        hint: &'static str,
    },
    /// Text of an angle that is too large, or too near zero or the top without being there.
    #[error("the angle `{text}` is out of range: {hint}")]
    AngleOutOfRange {
        /// The text, shortened.
        text: String,
        /// What would do.
        hint: &'static str,
    },
}

/// The text as a message may show it: no control characters, at most 40 characters.
pub(super) fn excerpt(text: &str) -> String {
    const SHOWN: usize = 40;
    let mut shown: String = text.chars().take(SHOWN).flat_map(char::escape_debug).collect();
    if text.chars().nth(SHOWN).is_some() {
        shown.push('…');
    }
    shown
}
