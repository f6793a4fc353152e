//! The field of fractions as a ring of coefficients.

use dashu::base::Gcd;
use dashu::integer::{IBig, UBig};

use super::{Function, Rational, Ring, product};

/// The field of all fractions.
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

    /// The rational values at rational places: those at zero, ln 1, and the roots of squares.
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

    /// Over common denominators, so that one greatest common divisor is taken for each coefficient.
    fn series_product(&self, a: &[Rational], b: &[Rational], length: usize) -> Vec<Rational> {
        let ((a, under_a), (b, under_b)) = (over_common(a, length), over_common(b, length));
        let denominator = under_a * under_b;
        let mut products = product(&a, &b);
        products.resize(length, IBig::ZERO);
        products.into_iter().map(|sum| Rational::from_parts(sum, denominator.clone())).collect()
    }
}

/// The first numerators over the least common denominator, and the latter.
fn over_common(series: &[Rational], length: usize) -> (Vec<IBig>, UBig) {
    let series = &series[..series.len().min(length)];
    let common = series.iter().fold(UBig::ONE, |common, fraction| {
        let denominator = fraction.parts().1;
        if (&common % denominator).is_zero() {
            common
        } else {
            let gcd = (&common).gcd(denominator);
            common / gcd * denominator
        }
    });
    let numerator = |fraction: &Rational| {
        let (numerator, denominator) = fraction.parts();
        numerator * IBig::from(&common / denominator)
    };
    (series.iter().map(numerator).collect(), common)
}
