//! Multi-precision floats as a ring, for coefficients that are not fractions.

use super::{BigFloat, Function, Growth, Rational, Ring};

/// Binary floats of a fixed precision, in bits; every operation rounds to nearest.
#[derive(Clone, Copy, Debug)]
pub struct Floats {
    /// Bits of the significand.
    pub precision: usize,
}

impl Floats {
    #[doc(hidden)]
    pub fn integer(self, value: i64) -> BigFloat {
        BigFloat::from_integer(value, self.precision)
    }

    /// Powers with integer exponents, by repeated squaring with guard bits for the rounding errors of n multiplications; `None` if the result
    /// has more binary places than [`MOST_PLACES`].
    fn whole_power(self, a: &BigFloat, exponent: &Rational) -> Option<BigFloat> {
        let n = exponent.magnitude().to_natural()?;
        if n == 0 {
            return Some(self.integer(1));
        }
        let bits = a.exponent()?.unsigned_abs().max(1).checked_mul(usize::try_from(n).ok()?)?;
        if bits > MOST_PLACES {
            return None;
        }
        let spare = usize::try_from(n.ilog2()).ok()? + 8;
        let wide = Self { precision: self.precision + spare };
        let base = a.clone() + wide.integer(0);
        let mut power = base.clone();
        for bit in (0..n.ilog2()).rev() {
            power = power.clone() * power;
            if n >> bit & 1 == 1 {
                power = power * base.clone();
            }
        }
        let power = if exponent.is_negative() { wide.integer(1) / power } else { power };
        Some(self.rounded(&power))
    }

    fn rounded(self, value: &BigFloat) -> BigFloat {
        value.rounded_to(self.precision)
    }
}

impl Ring for Floats {
    type Element = BigFloat;

    fn zero(&self) -> BigFloat {
        self.integer(0)
    }

    fn is_zero(&self, a: &BigFloat) -> bool {
        a.is_zero()
    }

    fn rational(&self, value: &Rational) -> Option<BigFloat> {
        Some(BigFloat::from_rational(value, self.precision))
    }

    fn add(&self, a: &BigFloat, b: &BigFloat) -> BigFloat {
        a.clone() + b.clone()
    }

    fn subtract(&self, a: &BigFloat, b: &BigFloat) -> BigFloat {
        a.clone() - b.clone()
    }

    fn negate(&self, a: &BigFloat) -> BigFloat {
        -a.clone()
    }

    fn multiply(&self, a: &BigFloat, b: &BigFloat) -> BigFloat {
        a.clone() * b.clone()
    }

    fn times_integer(&self, a: &BigFloat, factor: i64) -> BigFloat {
        a.clone() * self.integer(factor)
    }

    fn divide(&self, a: &BigFloat, divisor: &BigFloat) -> Option<BigFloat> {
        (!divisor.is_zero()).then(|| a.clone() / divisor.clone())
    }

    fn over_integer(&self, a: &BigFloat, divisor: u64) -> Option<BigFloat> {
        self.divide(a, &self.integer(i64::try_from(divisor).ok()?))
    }

    fn value(&self, function: Function, at: &BigFloat) -> Option<BigFloat> {
        // An exact zero has no precision.
        let at = &self.rounded(at);
        let too_large = at.exponent().is_some_and(|exponent| exponent > largest_exponent(function.growth()));
        if too_large { None } else { function.at_float(at, self.precision) }
    }

    fn power(&self, a: &BigFloat, exponent: &Rational) -> Option<BigFloat> {
        if a.is_zero() {
            let positive = !exponent.is_negative() && !exponent.is_zero();
            return positive.then(|| self.zero());
        }
        if exponent.is_integer() {
            return self.whole_power(a, exponent);
        }
        let logarithm = self.value(Function::Ln, a)?;
        self.value(Function::Exp, &(logarithm * self.rational(exponent)?))
    }

    fn pi(&self) -> Option<BigFloat> {
        Some(BigFloat::pi(self.precision))
    }
}

/// Largest number of binary places: longer numbers are too slow as fractions.
const MOST_PLACES: usize = 1 << 21;

/// Largest binary exponent of an argument: exponentials of a million take a second, of a billion minutes.
const fn largest_exponent(growth: Growth) -> isize {
    match growth {
        Growth::Exponential | Growth::Hyperbolic => 20,
        Growth::Power => isize::MAX,
        Growth::Bounded => 40,
    }
}
