//! Angles as exact rational combinations a·π + b, turned into two words in one place.

use std::sync::LazyLock;

use dashu::base::{Abs, Signed};
use dashu::float::{FBig, round::mode::HalfEven};
use dashu::integer::IBig;
use dashu::rational::RBig;

use super::Angle;
use crate::double_double::{DoubleDouble, fast_two_sum};

/// Bits of π held for the conversions. A decimal of the longest text this module reads differs from a multiple
/// of π by far more than 2⁻⁹⁰⁰, so that the two words of a difference are always there.
const PI_BITS: usize = 1100;

static PI: LazyLock<RBig> = LazyLock::new(|| {
    let pi = FBig::<HalfEven, 2>::pi(PI_BITS);
    RBig::try_from(pi).expect("a finite binary number is a rational")
});

/// The angle a·π + b radians, exactly.
#[derive(Clone, Debug)]
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
        if self.is_negative() {
            return -self.negated().to_angle();
        }
        let (turns, in_turn) = self.split_turns();
        Angle::from_parts(
            i64::try_from(turns).expect("the callers bound the angle"),
            two_words(in_turn.value()),
            two_words(in_turn.complement().value()),
        )
    }

    /// As text is meant: plain radians are the nearest `f64`, everything else is exact.
    pub(super) fn to_angle_as_text_means(&self) -> Angle {
        if !self.pi_multiple.is_zero() {
            return self.to_angle();
        }
        let radians = self.rest.to_f64().value();
        Angle::from_radians(radians).unwrap_or_else(|_| Self::radians(radians).to_angle())
    }

    /// The nearest `f64`, if it is finite.
    pub(super) fn nearest(&self) -> Option<f64> {
        Some(self.value().to_f64().value()).filter(|x| x.is_finite())
    }

    /// Whether the angle in the turn or its complement is nearer zero than `distance` without being zero.
    pub(super) fn nearly_vanishes(&self, distance: &RBig) -> bool {
        let (_, in_turn) = if self.is_negative() { self.negated() } else { self.clone() }.split_turns();
        let nearly = |part: &Self| {
            let value = part.value();
            !value.is_zero() && value.abs() < *distance
        };
        nearly(&in_turn) || nearly(&in_turn.complement())
    }

    /// a·π + b with π to [`PI_BITS`]; exact when there is no π in it.
    pub(super) fn value(&self) -> RBig {
        if self.pi_multiple.is_zero() { self.rest.clone() } else { &self.pi_multiple * &*PI + &self.rest }
    }

    /// The whole turns of a positive angle and what is left; an odd multiple of π counts the fewer turns.
    fn split_turns(&self) -> (IBig, Self) {
        // Without a rest the quotient is exact, with one it is irrational: a tie is always seen.
        let half_turns = if self.rest.is_zero() { self.pi_multiple.clone() } else { self.value() / &*PI };
        let turns = ((half_turns - RBig::ONE) / RBig::from(2)).ceil();
        let pi_multiple = &self.pi_multiple - RBig::from(&turns * IBig::from(2));
        (turns, Self { pi_multiple, rest: self.rest.clone() })
    }

    /// π − |a·π + b|.
    fn complement(&self) -> Self {
        let Self { pi_multiple, rest } = if self.is_negative() { self.clone() } else { self.negated() };
        Self { pi_multiple: RBig::ONE + pi_multiple, rest }
    }

    fn is_negative(&self) -> bool {
        self.value().is_negative()
    }

    fn negated(&self) -> Self {
        Self { pi_multiple: -&self.pi_multiple, rest: -&self.rest }
    }
}

/// The value of a finite `f64`.
fn exact(x: f64) -> RBig {
    RBig::try_from(x).expect("a finite binary number is a rational")
}

/// The nearest `f64` and the nearest of what it leaves.
fn two_words(value: RBig) -> DoubleDouble {
    let hi = value.to_f64().value();
    let lo = (value - exact(hi)).to_f64().value();
    fast_two_sum(hi, lo)
}
