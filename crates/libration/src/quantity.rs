//! Angles, and physical quantities from text.
//!
//! An [`Angle`] is kept as whole turns, an angle in the turn and its complement to the upright position, each
//! in two words, because near the top π − θ is the number that matters and θ alone has lost it.

use crate::double_double::DoubleDouble;

/// An angle from the downward vertical: whole turns, the angle in the turn within [−π, π], and the complement
/// π − |angle in the turn|.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Angle {
    turns: i64,
    in_turn: DoubleDouble,
    complement: DoubleDouble,
}

impl Angle {
    /// The angle in radians, unwrapped, as the nearest `f64`.
    #[must_use]
    pub fn radians(&self) -> f64 {
        todo!()
    }

    /// The whole turns: the angle is 2π·turns + the angle in the turn.
    #[must_use]
    pub fn turns(&self) -> i64 {
        self.turns
    }

    /// The angle in the turn, within [−π, π] radians.
    #[must_use]
    pub fn in_turn(&self) -> f64 {
        self.in_turn.to_f64()
    }

    /// π − |angle in the turn|, with full relative accuracy however small it is.
    #[must_use]
    pub fn complement(&self) -> f64 {
        self.complement.to_f64()
    }

    pub(crate) fn in_turn_words(&self) -> DoubleDouble {
        self.in_turn
    }

    pub(crate) fn complement_words(&self) -> DoubleDouble {
        self.complement
    }

    /// The angle of this many radians, exactly this `f64`.
    ///
    /// # Errors
    /// NaN, infinite, or so large (above 2⁵³ radians) that its turns cannot be counted.
    pub fn from_radians(radians: f64) -> Result<Self, QuantityError> {
        let _ = radians;
        todo!()
    }

    /// The angle of this many degrees, exactly this `f64`.
    ///
    /// # Errors
    /// As [`Angle::from_radians`].
    pub fn from_degrees(degrees: f64) -> Result<Self, QuantityError> {
        let _ = degrees;
        todo!()
    }

    /// The angle π − `complement`, exactly this `f64`; `complement` within [0, π].
    ///
    /// # Errors
    /// NaN or outside [0, π].
    pub fn from_complement(complement: f64) -> Result<Self, QuantityError> {
        let _ = complement;
        todo!()
    }
}

/// Why a text is not the quantity it should be, or a number not an angle.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum QuantityError {
    /// Not finite, or too large for its turns to be counted.
    #[error("{0} is not a usable angle: give a finite angle of at most 2^53 rad")]
    NotAnAngle(f64),
}
