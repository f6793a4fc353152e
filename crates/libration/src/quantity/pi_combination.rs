//! Angles as exact rational combinations a·π + b, turned into two words in one place.

use std::sync::LazyLock;

use dashu::base::{DivEuclid, Signed};
use dashu::float::{FBig, round::mode::HalfEven};
use dashu::integer::{IBig, UBig};
use dashu::rational::RBig;

use super::Angle;
use super::fraction::Fraction;

/// Bits of π after the point held for the conversions. A decimal of the longest text this module reads differs
/// from a multiple of π by far more than 2⁻⁹⁰⁰, so that the two words of a difference are always there.
const PI_BITS: usize = 1100;

/// ⌊π·2^[`PI_BITS`]⌋.
static PI: LazyLock<UBig> = LazyLock::new(|| {
    let pi = FBig::<HalfEven, 2>::pi(PI_BITS + 8);
    (pi << PI_BITS.cast_signed())
        .floor()
        .try_into()
        .expect("the floor of a positive number is a natural number")
});

/// Bits of π that give a·π in two words, where nothing is taken from it.
const SHORT_PI_BITS: usize = 320;

/// ⌊π·2^[`SHORT_PI_BITS`]⌋.
static SHORT_PI: LazyLock<IBig> = LazyLock::new(|| IBig::from(&*PI >> (PI_BITS - SHORT_PI_BITS)));

/// The angle a·π + b radians, exactly.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct PiCombination {
    /// a, in units of π.
    pub(super) pi_multiple: RBig,
    /// b, in radians.
    pub(super) rest: RBig,
}

impl PiCombination {
    /// Exactly this finite number of radians.
    pub(super) fn radians(radians: f64) -> Self {
        Self { pi_multiple: RBig::ZERO, rest: exact(radians) }
    }

    /// Exactly this finite number of degrees.
    pub(super) fn degrees(degrees: f64) -> Self {
        Self::from_degrees(exact(degrees))
    }

    /// Exactly this many degrees.
    pub(super) fn from_degrees(degrees: RBig) -> Self {
        Self { pi_multiple: degrees / RBig::from(180), rest: RBig::ZERO }
    }

    /// The nearest angle in two words; the caller keeps the turns within an `i64`.
    pub(super) fn to_angle(&self) -> Angle {
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

    /// The angle a·π with 0 ≤ a ≤ 1, which has no turns and whose complement (1 − a)·π is as plain.
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

    /// As text is meant: plain radians are the nearest `f64`, everything else is exact.
    pub(super) fn to_angle_as_text_means(&self) -> Angle {
        if !self.pi_multiple.is_zero() {
            return self.to_angle();
        }
        let radians = self.value().to_words().to_f64();
        Angle::from_radians(radians).unwrap_or_else(|_| self.to_angle())
    }

    /// The nearest `f64`, if it is finite.
    pub(super) fn nearest(&self) -> Option<f64> {
        Some(self.value().to_rational().to_f64().value()).filter(|x| x.is_finite())
    }

    /// Whether the angle is an exact multiple of π, which only one without a rest can be.
    pub(super) fn is_multiple_of_pi(&self) -> bool {
        self.rest.is_zero() && self.pi_multiple.is_int()
    }

    /// a·π + b with π to [`PI_BITS`]; exact when there is no π in it.
    pub(super) fn value(&self) -> Fraction {
        let (a, b) = (Fraction::from(&self.pi_multiple), Fraction::from(&self.rest));
        if a.is_zero() {
            return b;
        }
        let turning = a.numerator * IBig::from(PI.clone()) * &b.denominator;
        let resting = (b.numerator * &a.denominator) << PI_BITS;
        Fraction { numerator: turning + resting, denominator: (a.denominator * b.denominator) << PI_BITS }
    }

    /// ⌈(angle/π − 1)/2⌉ of a positive angle: an odd multiple of π counts the fewer turns.
    fn whole_turns(&self, value: &Fraction) -> IBig {
        // Without a rest the quotient is exact, with one it is irrational: a tie is always seen.
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

    /// π − |a·π + b|, given a·π + b.
    fn complement(&self, value: &Fraction) -> Fraction {
        let Self { pi_multiple, rest } = if value.is_negative() { self.clone() } else { self.negated() };
        Self { pi_multiple: RBig::ONE + pi_multiple, rest }.value()
    }

    fn negated(&self) -> Self {
        Self { pi_multiple: -&self.pi_multiple, rest: -&self.rest }
    }
}

/// The value of a finite `f64`.
fn exact(x: f64) -> RBig {
    RBig::try_from(x).expect("a finite binary number is a rational")
}
