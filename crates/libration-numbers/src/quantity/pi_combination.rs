//! Exact rational combinations a·π + b.

use std::sync::LazyLock;

use dashu_float::{FBig, round::mode::HalfEven};
use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

use super::fraction::Fraction;

/// Number of binary places of π for the conversions. A decimal of the longest accepted text differs from every multiple of π by far more than
/// 2⁻⁹⁰⁰, so that both words of a difference are always determined.
pub(super) const PI_BITS: usize = 1100;

/// ⌊π·2^[`PI_BITS`]⌋.
pub(super) static PI: LazyLock<UBig> = LazyLock::new(|| {
    let pi = FBig::<HalfEven, 2>::pi(PI_BITS + 8);
    (pi << PI_BITS.cast_signed())
        .floor()
        .try_into()
        .expect("the floor of a positive number is a natural number")
});

/// Number of binary places of π that suffice for a·π in two words, if nothing is subtracted from it.
pub(super) const SHORT_PI_BITS: usize = 320;

/// ⌊π·2^[`SHORT_PI_BITS`]⌋.
pub(super) static SHORT_PI: LazyLock<IBig> = LazyLock::new(|| IBig::from(&*PI >> (PI_BITS - SHORT_PI_BITS)));

/// The angle a·π + b radians, exactly.
#[derive(Clone, Debug, PartialEq)]
pub struct PiCombination {
    /// a, in units of π.
    pub(super) pi_multiple: RBig,
    /// b, in radians.
    pub(super) rest: RBig,
}

impl PiCombination {
    /// Exactly this finite number of radians.
    pub fn radians(radians: f64) -> Self {
        Self { pi_multiple: RBig::ZERO, rest: exact(radians) }
    }

    /// The nearest `f64`, if it is finite.
    pub(super) fn nearest(&self) -> Option<f64> {
        Some(self.value().to_rational().to_f64().value()).filter(|x| x.is_finite())
    }

    /// Returns `true` if the angle is an exact multiple of π, which requires b = 0.
    pub(super) fn is_multiple_of_pi(&self) -> bool {
        self.rest.is_zero() && self.pi_multiple.is_int()
    }

    /// a·π + b with π to [`PI_BITS`] places; exact if a = 0.
    pub(super) fn value(&self) -> Fraction {
        let (a, b) = (Fraction::from(&self.pi_multiple), Fraction::from(&self.rest));
        if a.is_zero() {
            return b;
        }
        let turning = a.numerator * IBig::from(PI.clone()) * &b.denominator;
        let resting = (b.numerator * &a.denominator) << PI_BITS;
        Fraction { numerator: turning + resting, denominator: (a.denominator * b.denominator) << PI_BITS }
    }

    pub(super) fn negated(&self) -> Self {
        Self { pi_multiple: -&self.pi_multiple, rest: -&self.rest }
    }
}

/// The exact value of a finite `f64`.
pub(super) fn exact(x: f64) -> RBig {
    RBig::try_from(x).expect("a finite binary number is a rational")
}
