//! Angles from exact numbers, rounded once to two words.

use dashu_base::{DivEuclid, Signed};
use dashu_int::IBig;
use dashu_ratio::RBig;

use super::angle::LARGEST_RADIANS;
use super::fraction::Fraction;
use super::pi_combination::{PI, PI_BITS, PiCombination, SHORT_PI, SHORT_PI_BITS, exact};
use super::unit::DEGREE;
use super::{Angle, QuantityError};
use libration_kernels::double_double::{DoubleDouble, two_sum};

impl Angle {
    /// The angle with exactly this `f64` in radians.
    ///
    /// # Errors
    /// A number that is NaN, infinite, or so large (above 2⁵³ radians) that its turns cannot be counted.
    pub fn from_radians(radians: f64) -> Result<Self, QuantityError> {
        if radians.abs() <= DoubleDouble::PI.hi {
            // π in three words: the first difference is exact, and its remainder does not cancel again.
            let complement = two_sum(DoubleDouble::PI.hi, -radians.abs()) + DoubleDouble::PI_TAIL;
            return Ok(Self::from_parts(0, radians.into(), complement));
        }
        if radians.abs() <= LARGEST_RADIANS {
            return Ok(PiCombination::radians(radians).to_angle());
        }
        Err(QuantityError::NotAnAngle(radians))
    }

    /// The angle with exactly this `f64` in degrees.
    ///
    /// # Errors
    /// As [`Angle::from_radians`].
    pub fn from_degrees(degrees: f64) -> Result<Self, QuantityError> {
        if degrees.abs() <= LARGEST_RADIANS {
            return Ok(DEGREE.times(exact(degrees)).to_angle());
        }
        Err(QuantityError::NotAnAngle(degrees))
    }
}

impl PiCombination {
    /// The nearest angle in two words; the caller ensures that the turns are within an `i64`.
    pub fn to_angle(&self) -> Angle {
        if let Some(angle) = self.to_angle_within_half_turn() {
            return angle;
        }
        let value = self.value();
        if value.is_negative() {
            return -self.negated().to_angle();
        }
        let turns = self.whole_turns(&value);
        let in_turn = self.turned_back(&turns);
        let value = in_turn.value();
        Angle::from_parts(
            i64::try_from(turns).expect("the callers bound the angle"),
            value.to_words(),
            in_turn.complement(&value).to_words(),
        )
    }

    /// The angle a·π with 0 ≤ a ≤ 1, which has no turns and a complement of the same form, (1 − a)·π.
    fn to_angle_within_half_turn(&self) -> Option<Angle> {
        let Fraction { numerator, denominator } = Fraction::from(&self.pi_multiple);
        let complement = IBig::from(denominator.clone()) - &numerator;
        let within = self.rest.is_zero() && !numerator.is_negative() && !complement.is_negative();
        let denominator = denominator << SHORT_PI_BITS;
        let words = |numerator: IBig| {
            Fraction { numerator: numerator * &*SHORT_PI, denominator: denominator.clone() }.to_words()
        };
        within.then(|| Angle::from_parts(0, words(numerator), words(complement)))
    }

    /// The angle of a text: plain radians are the nearest `f64`, every other angle is exact.
    pub(super) fn to_angle_as_text_means(&self) -> Angle {
        if !self.pi_multiple.is_zero() {
            return self.to_angle();
        }
        let radians = self.value().to_words().to_f64();
        Angle::from_radians(radians).unwrap_or_else(|_| self.to_angle())
    }

    /// ⌈(angle/π − 1)/2⌉ for a positive angle: for an odd multiple of π the smaller number of turns counts.
    fn whole_turns(&self, value: &Fraction) -> IBig {
        // Without a rest the quotient is exact, with a rest it is irrational: a tie is always recognised.
        let half_turns = if self.rest.is_zero() {
            Fraction::from(&self.pi_multiple)
        } else {
            Fraction { numerator: &value.numerator << PI_BITS, denominator: &value.denominator * &*PI }
        };
        let one = IBig::from(half_turns.denominator);
        let to_go: IBig = &one - half_turns.numerator;
        -to_go.div_euclid(one * IBig::from(2))
    }

    fn turned_back(&self, turns: &IBig) -> Self {
        Self { pi_multiple: &self.pi_multiple - RBig::from(turns * IBig::from(2)), rest: self.rest.clone() }
    }

    /// π − |a·π + b|, from a·π + b.
    fn complement(&self, value: &Fraction) -> Fraction {
        let Self { pi_multiple, rest } = if value.is_negative() { self.clone() } else { self.negated() };
        Self { pi_multiple: RBig::ONE + pi_multiple, rest }.value()
    }
}
