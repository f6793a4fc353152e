//! Unreduced fractions, and their rounding to two words.

use dashu_base::{BitTest, Signed, UnsignedAbs};
use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

use libration_kernels::double_double::{DoubleDouble, fast_two_sum};

/// Bits of a quotient that is split into two words of 53 bits.
const QUOTIENT_BITS: usize = 160;

/// numerator/denominator with a positive denominator.
#[derive(Clone, Debug)]
pub(super) struct Fraction {
    pub(super) numerator: IBig,
    pub(super) denominator: UBig,
}

impl Fraction {
    pub(super) fn is_negative(&self) -> bool {
        !self.is_zero() && self.numerator.is_negative()
    }

    pub(super) fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }

    pub(super) fn to_rational(&self) -> RBig {
        RBig::from_parts(self.numerator.clone(), self.denominator.clone())
    }

    /// The nearest `f64`, and the one nearest to the remainder, from a quotient of [`QUOTIENT_BITS`].
    pub(super) fn to_words(&self) -> DoubleDouble {
        let magnitude = (&self.numerator).unsigned_abs();
        let shift = (QUOTIENT_BITS + self.denominator.bit_len()).saturating_sub(magnitude.bit_len());
        let quotient = (magnitude << shift) / &self.denominator;
        let hi = quotient.to_f64().value();
        if !hi.is_finite() {
            return if self.is_negative() { -DoubleDouble::from(hi) } else { hi.into() };
        }
        let whole = IBig::try_from(hi).expect("a large f64 is an integer");
        let lo = (IBig::from(quotient) - whole).to_f64().value();
        let words = fast_two_sum(halved(hi, shift), halved(lo, shift));
        if self.is_negative() { -words } else { words }
    }
}

/// x/2^n, rounded once if it is subnormal.
fn halved(x: f64, n: usize) -> f64 {
    libm::scalbn(x, i32::try_from(n).map_or(i32::MIN, |n| -n))
}

impl From<&RBig> for Fraction {
    fn from(rational: &RBig) -> Self {
        Self { numerator: rational.numerator().clone(), denominator: rational.denominator().clone() }
    }
}
