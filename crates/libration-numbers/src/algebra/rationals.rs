//! The field of fractions as a ring of coefficients.

use dashu_base::{DivRem, Gcd};
use dashu_int::{IBig, UBig};

use super::common_denominator::{OverCommon, composition};
use super::{Function, Rational, Ring};

/// The field of all rational numbers.
#[derive(Clone, Copy, Debug)]
pub struct Rationals;

impl Ring for Rationals {
    type Element = Rational;

    fn zero(&self) -> Rational {
        Rational::from(0)
    }

    fn is_zero(&self, a: &Rational) -> bool {
        a.is_zero()
    }

    fn rational(&self, value: &Rational) -> Option<Rational> {
        Some(value.clone())
    }

    fn add(&self, a: &Rational, b: &Rational) -> Rational {
        Rational(&a.0 + &b.0)
    }

    fn subtract(&self, a: &Rational, b: &Rational) -> Rational {
        Rational(&a.0 - &b.0)
    }

    fn negate(&self, a: &Rational) -> Rational {
        Rational(-&a.0)
    }

    fn multiply(&self, a: &Rational, b: &Rational) -> Rational {
        Rational(&a.0 * &b.0)
    }

    fn times_integer(&self, a: &Rational, factor: i64) -> Rational {
        Rational(&a.0 * IBig::from(factor))
    }

    fn divide(&self, a: &Rational, divisor: &Rational) -> Option<Rational> {
        a.checked_div(divisor)
    }

    fn over_integer(&self, a: &Rational, divisor: u64) -> Option<Rational> {
        (divisor != 0).then(|| Rational(&a.0 / IBig::from(divisor)))
    }

    /// Values that are rational: those at zero, ln 1, and the roots of squares.
    fn value(&self, function: Function, at: &Rational) -> Option<Rational> {
        function.at_rational(at)
    }

    fn power(&self, a: &Rational, exponent: &Rational) -> Option<Rational> {
        let (numerator, denominator) = exponent.parts();
        let root = a.root(usize::try_from(denominator).ok()?)?;
        root.integer_power(isize::try_from(numerator).ok()?)
    }

    fn pi(&self) -> Option<Rational> {
        None
    }

    /// The convolution over a common denominator, reduced once.
    fn convolution(&self, a: &[Rational], b: &[Rational]) -> Rational {
        let (mut sum, mut denominator) = (IBig::ZERO, UBig::ONE);
        for (a, b) in a.iter().zip(b.iter().rev()).filter(|(a, b)| !a.is_zero() && !b.is_zero()) {
            let ((a, under_a), (b, under_b)) = (a.parts(), b.parts());
            let product = under_a * under_b;
            let (quotient, remainder) = (&denominator).div_rem(&product);
            if remainder.is_zero() {
                sum += a * b * IBig::from(quotient);
            } else {
                let common = (&denominator).gcd(&product);
                let (factor, others) = (&product / &common, &denominator / common);
                sum = sum * IBig::from(factor.clone()) + a * b * IBig::from(others);
                denominator *= factor;
            }
        }
        Rational::from_parts(sum, denominator)
    }

    /// The product over common denominators, with one greatest common divisor per coefficient.
    fn series_product(&self, a: &[Rational], b: &[Rational], length: usize) -> Vec<Rational> {
        let first = |series: &[Rational]| OverCommon::new(&series[..series.len().min(length)]);
        first(a).product(&first(b), length).into_fractions()
    }

    fn series_composition(
        &self,
        outer: &[Rational],
        inner: &[Rational],
        length: usize,
        go_on: &dyn Fn() -> bool,
    ) -> Option<Vec<Rational>> {
        composition(outer, inner, length, go_on)
    }
}
