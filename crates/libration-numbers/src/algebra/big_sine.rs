//! Sine and cosine of a small float, computed together.
//!
//! Taylor's series is summed in integers, in units of 2^−(precision + guard). For small angles this costs a fraction of two reductions to a
//! quadrant.

use dashu_int::IBig;

use super::BigFloat;

/// Guard bits for the rounding errors of forty terms and of the conversions.
const GUARD_BITS: usize = 24;

impl BigFloat {
    /// sin x and cos x, each relatively accurate to a few units in the last place except next to its far zero.
    #[must_use]
    pub fn sin_cos(&self) -> (Self, Self) {
        if self.exponent().is_some_and(|exponent| exponent > 0) {
            return (self.sin(), self.cos());
        }
        let (precision, bits) = (self.precision(), self.precision() + GUARD_BITS);
        let square = (self.clone() * self.clone()).in_units_of(bits);
        let [sine_over_x, cosine] = [1, 0].map(|first| alternating(&square, first, bits));
        (
            self.clone() * Self::from_units(sine_over_x, bits, precision),
            Self::from_units(cosine, bits, precision),
        )
    }
}

/// 1 − y/(a + 1)(a + 2) + y²/(a + 1)…(a + 4) − …, with y and the sum in these units.
fn alternating(square: &IBig, first: u32, bits: usize) -> IBig {
    let mut term = IBig::ONE << bits;
    let mut sum = term.clone();
    let mut n = first;
    loop {
        term = -((term * square) >> bits) / IBig::from((n + 1) * (n + 2));
        n += 2;
        if term.is_zero() {
            return sum;
        }
        sum += &term;
    }
}
