//! Sine and cosine of a float.
//!
//! The nearest multiple of π/2 is subtracted, and Taylor's series is summed, in integers: in units of 2^−(precision + guard). This takes a
//! fraction of the time of the operations of a float, each of which is rounded.

use dashu_base::{BitTest, DivEuclid, RemEuclid};
use dashu_int::IBig;

use super::BigFloat;

/// Guard bits for the rounding errors of forty terms and of the conversions.
const GUARD_BITS: usize = 24;
/// Largest exponent of an angle from which π/2 is subtracted here.
const LARGEST_EXPONENT: usize = 64;
/// Bits of a difference from a multiple of π/2 that may be lost.
const LOST_BITS: usize = 32;

impl BigFloat {
    /// sin x and cos x, each relatively accurate to a few units in the last place.
    #[must_use]
    pub fn sin_cos(&self) -> (Self, Self) {
        match self.in_quarters() {
            Some((quarters, rest)) => {
                let advanced = |n| rest.sine_after(quarters + n).rounded_to(self.precision());
                (advanced(0), advanced(1))
            }
            None => (self.sin(), self.cos()),
        }
    }

    /// sin(x + nπ/2); `None` for very large angles and next to a multiple of π/2, where bits would be lost.
    pub(super) fn advanced_sine(&self, n: u8) -> Option<Self> {
        let (quarters, rest) = self.in_quarters()?;
        Some(rest.sine_after(quarters + n).rounded_to(self.precision()))
    }

    /// n modulo 4 and y with x = nπ/2 + y and |y| at most 1.
    fn in_quarters(&self) -> Option<(u8, Self)> {
        let exponent = match self.exponent().map(usize::try_from) {
            Some(Ok(exponent)) if exponent > 0 => exponent,
            _ => return Some((0, self.clone())),
        };
        if exponent > LARGEST_EXPONENT {
            return None;
        }
        // The number of quarters, below 2^exponent, times the error of π/2 is below 2^−(precision + LOST_BITS + GUARD_BITS).
        let bits = self.precision() + exponent + LOST_BITS + GUARD_BITS;
        let quarter = Self::pi(bits).halved().in_units_of(bits);
        let angle = self.in_units_of(bits);
        let quarters = ((angle.clone() << 1) + &quarter).div_euclid(quarter.clone() << 1);
        let rest = angle - &quarters * quarter;
        let is_near = rest.bit_len() + LOST_BITS < bits;
        let turned = u8::try_from(quarters.rem_euclid(IBig::from(4))).ok()?;
        (!is_near).then(|| (turned, Self::from_units(rest, bits, self.precision() + GUARD_BITS)))
    }

    /// sin(y + nπ/2) for |y| at most 1.
    fn sine_after(&self, n: u8) -> Self {
        let bits = self.precision() + GUARD_BITS;
        let square = (self.clone() * self.clone()).in_units_of(bits);
        let series = |first| Self::from_units(alternating(&square, first, bits), bits, self.precision());
        let value = if n.is_multiple_of(2) { self.clone() * series(1) } else { series(0) };
        if n % 4 < 2 { value } else { -value }
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
