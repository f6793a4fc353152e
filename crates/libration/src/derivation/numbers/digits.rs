//! Real numbers to so many binary digits.

use super::quadrature;
use crate::algebra::{BigFloat, Function, Rational, Ring};
use crate::derivation::evaluate::{Analysis, NoValue};

/// Bits of every number: 77 decimal digits.
pub(in crate::derivation) const PRECISION: usize = 256;

/// Floats of [`PRECISION`] bits.
#[derive(Clone, Copy, Debug)]
pub(in crate::derivation) struct Digits;

impl Digits {
    fn integer(self, value: i64) -> BigFloat {
        BigFloat::from_integer(value, PRECISION)
    }
}

impl Ring for Digits {
    type Element = BigFloat;

    fn zero(&self) -> BigFloat {
        self.integer(0)
    }

    fn is_zero(&self, a: &BigFloat) -> bool {
        a.is_zero()
    }

    fn rational(&self, value: &Rational) -> Option<BigFloat> {
        Some(BigFloat::from_rational(value, PRECISION))
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
        let (zero, one) = (self.zero(), self.integer(1));
        let within_one = *at >= -one.clone() && *at <= one;
        match function {
            Function::Sqrt => (*at >= zero).then(|| at.sqrt()),
            Function::Sin => Some(at.sin()),
            Function::Cos => Some(at.cos()),
            Function::Tan => self.divide(&at.sin(), &at.cos()),
            Function::Asin => within_one.then(|| at.asin()),
            Function::Acos => within_one.then(|| self.integer(0) + BigFloat::pi(PRECISION).halved() - at.asin()),
            Function::Atan => Some(at.atan()),
            Function::Sinh => Some((at.exp() - (-at.clone()).exp()).halved()),
            Function::Cosh => Some((at.exp() + (-at.clone()).exp()).halved()),
            Function::Tanh => self.divide(&self.value(Function::Sinh, at)?, &self.value(Function::Cosh, at)?),
            Function::Exp => Some(at.exp()),
            Function::Ln => (*at > zero).then(|| at.ln()),
            Function::Abs => Some(if *at < zero { -at.clone() } else { at.clone() }),
        }
    }

    fn power(&self, a: &BigFloat, exponent: &Rational) -> Option<BigFloat> {
        if exponent.denominator() == "1" {
            let exponent: i64 = exponent.numerator().parse().ok()?;
            let size = integer_power(a, exponent.unsigned_abs(), self.integer(1));
            return if exponent < 0 { self.divide(&self.integer(1), &size) } else { Some(size) };
        }
        let logarithm = self.value(Function::Ln, a)?;
        Some((logarithm * BigFloat::from_rational(exponent, PRECISION)).exp())
    }

    fn pi(&self) -> Option<BigFloat> {
        Some(BigFloat::pi(PRECISION))
    }
}

/// Repeated squaring.
fn integer_power(base: &BigFloat, exponent: u64, one: BigFloat) -> BigFloat {
    let (mut result, mut square, mut rest) = (one, base.clone(), exponent);
    while rest > 0 {
        if rest % 2 == 1 {
            result = result * square.clone();
        }
        square = square.clone() * square;
        rest /= 2;
    }
    result
}

impl Analysis for Digits {
    fn is_negligible(&self, term: &BigFloat, sum: &BigFloat) -> bool {
        let bits = isize::try_from(PRECISION).unwrap_or(isize::MAX);
        match (term.exponent(), sum.exponent()) {
            (None, _) => true,
            (Some(term), Some(sum)) => sum - term > bits,
            (Some(_), None) => false,
        }
    }

    fn most_terms(&self) -> usize {
        4000
    }

    fn integral(
        &self,
        from: &BigFloat,
        to: &BigFloat,
        integrand: &mut dyn FnMut(BigFloat) -> Result<BigFloat, NoValue>,
    ) -> Result<BigFloat, NoValue> {
        quadrature::integral(from, to, integrand)
    }

    /// The central difference, whose error is of the order of the square of its step, 2 to minus a third of the
    /// digits: two thirds of them are good.
    fn slope(
        &self,
        function: &mut dyn FnMut(BigFloat) -> Result<BigFloat, NoValue>,
    ) -> Result<BigFloat, NoValue> {
        let third = i64::try_from(PRECISION / 3).unwrap_or(i64::MAX);
        let step = integer_power(&self.integer(1).halved(), third.unsigned_abs(), self.integer(1));
        let difference = function(step.clone())? - function(-step.clone())?;
        Ok((difference / step).halved())
    }

    fn agm(&self, a: &BigFloat, b: &BigFloat) -> Option<BigFloat> {
        let zero = self.zero();
        (*a > zero && *b > zero).then(|| a.agm(b))
    }

    fn left_out(&self, _order: &BigFloat) -> Result<BigFloat, NoValue> {
        Err(NoValue::NotInRing("the sum of the terms left out"))
    }
}
