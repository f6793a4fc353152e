//! Angles with full relative accuracy at the bottom and at the top.

use std::fmt;
use std::ops::Neg;

use super::QuantityError;
use libration_kernels::double_double::{DoubleDouble, two_sum};

/// Largest angle in radians: beyond it, turns could not be counted by an `f64`.
pub(super) const LARGEST_RADIANS: f64 = 9_007_199_254_740_992.0;
const TWO_PI: DoubleDouble = DoubleDouble::new(2.0 * DoubleDouble::PI.hi, 2.0 * DoubleDouble::PI.lo);
const DEGREES_PER_RADIAN: DoubleDouble = DoubleDouble::new(57.29577951308232, -1.9878495670576283e-15);
/// Complement below which an angle is printed as `pi-δ`.
const SHOWN_AS_COMPLEMENT: f64 = 1e-3;

/// An angle from the downward vertical: whole turns, the angle in the turn within [−π, π], and the complement π − |angle in the turn|.
///
/// The angle in the turn and the complement each have a relative error of about 1e-31. For an odd multiple of π the smaller number of turns
/// counts: 180° is π after no turn, 540° is π after one.
///
/// # Examples
/// ```
/// # extern crate libration_numbers as libration;
/// use libration::quantity::Angle;
///
/// let nearly_upright: Angle = "pi-1e-300".parse()?;
/// assert_eq!(nearly_upright.complement(), 1e-300);
/// let past_the_top: Angle = "540.5deg".parse()?;
/// assert_eq!(past_the_top.turns(), 2);
/// # Ok::<(), libration::quantity::QuantityError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Angle {
    turns: i64,
    in_turn: DoubleDouble,
    complement: DoubleDouble,
}

impl Angle {
    /// The angle π − `complement`, where `complement` is exactly this `f64`, within [0, π] radians.
    ///
    /// # Errors
    /// NaN or outside [0, π].
    pub fn from_complement(complement: f64) -> Result<Self, QuantityError> {
        if (0.0..=DoubleDouble::PI.hi).contains(&complement) {
            return Ok(Self::from_complement_words(complement.into()));
        }
        Err(QuantityError::NotAComplement(complement))
    }

    /// The angle π − `complement`; the caller ensures that the complement is within [0, π].
    #[doc(hidden)]
    pub fn from_complement_words(complement: DoubleDouble) -> Self {
        let in_turn = two_sum(DoubleDouble::PI.hi, -complement.hi) + (DoubleDouble::PI_TAIL - complement.lo);
        Self { turns: 0, in_turn, complement }
    }

    /// An angle from its parts; the caller ensures that they are consistent.
    #[doc(hidden)]
    pub fn from_parts(turns: i64, in_turn: DoubleDouble, complement: DoubleDouble) -> Self {
        Self { turns, in_turn, complement }
    }

    /// The angle in radians, unwrapped, as the nearest `f64`.
    #[must_use]
    pub fn radians(&self) -> f64 {
        self.unwrapped().to_f64()
    }

    /// The angle in degrees, unwrapped, to within one rounding of the nearest `f64`.
    #[must_use]
    pub fn degrees(&self) -> f64 {
        (self.unwrapped() * DEGREES_PER_RADIAN).to_f64()
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

    /// The absolute value of the angle.
    #[must_use]
    pub fn abs(self) -> Self {
        if self.radians() < 0.0 { -self } else { self }
    }

    /// The angle in the turn as an unevaluated sum of two numbers, high word first, with about 106 bits.
    #[must_use]
    pub fn in_turn_in_two_words(&self) -> [f64; 2] {
        [self.in_turn.hi, self.in_turn.lo]
    }

    #[doc(hidden)]
    pub fn in_turn_words(&self) -> DoubleDouble {
        self.in_turn
    }

    #[doc(hidden)]
    pub fn complement_words(&self) -> DoubleDouble {
        self.complement
    }

    fn unwrapped(&self) -> DoubleDouble {
        if self.turns == 0 {
            return self.in_turn;
        }
        #[expect(clippy::cast_precision_loss, reason = "the turns of at most 2^53 rad are below 2^51")]
        let turns = self.turns as f64;
        TWO_PI * turns + self.in_turn
    }
}

/// The angle with the opposite sign.
impl Neg for Angle {
    type Output = Self;
    fn neg(self) -> Self {
        Self { turns: -self.turns, in_turn: -self.in_turn, complement: self.complement }
    }
}

/// Radians in the shortest form that is read as the same `f64`; within a thousandth of the top `pi-δ` (`-pi+δ` on the other side), with δ in the
/// same form.
impl fmt::Display for Angle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let complement = self.complement();
        if self.turns != 0 || complement > SHOWN_AS_COMPLEMENT {
            return write!(f, "{}", self.radians());
        }
        let (top, towards_the_bottom) = if self.in_turn.hi < 0.0 { ("-pi", '+') } else { ("pi", '-') };
        if complement <= 0.0 {
            return f.write_str(top);
        }
        write!(f, "{top}{towards_the_bottom}{complement:e}")
    }
}
