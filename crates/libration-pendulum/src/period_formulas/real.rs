//! Operations that formulas need, for `f64`, for two words and for floats of any precision.

use libration_kernels::double_double::DoubleDouble;
use libration_kernels::elementary::two_word;
use libration_numbers::algebra::{BigFloat, Rational};

/// The numbers in which a formula is evaluated: `f64` for speed, [`BigFloat`] for the error, two words for errors that are large enough.
pub trait Real:
    Clone
    + PartialOrd
    + std::ops::Add<Output = Self>
    + std::ops::Sub<Output = Self>
    + std::ops::Mul<Output = Self>
    + std::ops::Div<Output = Self>
    + std::ops::Neg<Output = Self>
{
    /// An integer in this number's precision.
    fn number(&self, integer: i16) -> Self;
    /// π in this number's precision.
    fn pi(&self) -> Self;
    /// Σ coefficientₙ·selfⁿ.
    fn polynomial(&self, coefficients: &Coefficients) -> Self;
    fn is_zero(&self) -> bool;
    /// Returns `true` if the magnitude is below one unit in the last place of 1.
    fn is_negligible(&self) -> bool;
    fn sqrt(&self) -> Self;
    fn ln(&self) -> Self;
    fn ln_1p(&self) -> Self;
    fn exp(&self) -> Self;
    fn sin(&self) -> Self;

    fn square(&self) -> Self {
        self.clone() * self.clone()
    }

    /// self/other, and 1 for 0/0: the quotients in formulas are of quantities that agree at small amplitude.
    fn over(self, other: Self) -> Self {
        if other.is_zero() { other.number(1) } else { self / other }
    }
}

/// The coefficients of a polynomial, exact and rounded.
#[derive(Clone, Debug)]
pub struct Coefficients {
    exact: Vec<Rational>,
    nearest: Vec<f64>,
    two_words: Vec<DoubleDouble>,
}

impl Coefficients {
    pub(super) fn new(exact: Vec<Rational>) -> Self {
        let nearest: Vec<f64> = exact.iter().map(Rational::to_f64).collect();
        let two_words = exact.iter().map(in_two_words).collect();
        Self { exact, nearest, two_words }
    }
}

impl Real for f64 {
    fn number(&self, integer: i16) -> Self {
        Self::from(integer)
    }

    fn pi(&self) -> Self {
        std::f64::consts::PI
    }

    fn polynomial(&self, coefficients: &Coefficients) -> Self {
        coefficients.nearest.iter().rev().fold(0.0, |sum, c| sum * self + c)
    }

    fn is_zero(&self) -> bool {
        *self == 0.0
    }

    fn is_negligible(&self) -> bool {
        self.abs() < Self::EPSILON
    }

    fn sqrt(&self) -> Self {
        Self::sqrt(*self)
    }

    fn ln(&self) -> Self {
        libm::log(*self)
    }

    fn ln_1p(&self) -> Self {
        libm::log1p(*self)
    }

    fn exp(&self) -> Self {
        libm::exp(*self)
    }

    fn sin(&self) -> Self {
        libm::sin(*self)
    }
}

fn in_two_words(exact: &Rational) -> DoubleDouble {
    const BITS: usize = 160;
    let float = BigFloat::from_rational(exact, BITS);
    let hi = float.to_f64();
    let rest = float - BigFloat::from_words(DoubleDouble::from(hi), BITS);
    DoubleDouble::new(hi, rest.to_f64())
}

impl Real for DoubleDouble {
    fn number(&self, integer: i16) -> Self {
        Self::from(f64::from(integer))
    }

    fn pi(&self) -> Self {
        Self::PI
    }

    fn polynomial(&self, coefficients: &Coefficients) -> Self {
        coefficients.two_words.iter().rev().fold(Self::ZERO, |sum, c| sum * *self + *c)
    }

    fn is_zero(&self) -> bool {
        self.hi == 0.0
    }

    fn is_negligible(&self) -> bool {
        self.hi.abs() < f64::EPSILON * f64::EPSILON
    }

    fn sqrt(&self) -> Self {
        Self::sqrt(*self)
    }

    fn ln(&self) -> Self {
        two_word::ln(*self)
    }

    /// ln(1 + x), with an absolute error of 2⁻¹⁰⁰.
    fn ln_1p(&self) -> Self {
        two_word::ln(*self + 1.0)
    }

    fn exp(&self) -> Self {
        two_word::exp(*self)
    }

    /// The sine, for 0 ≤ x ≤ π.
    fn sin(&self) -> Self {
        let acute = if self.hi > std::f64::consts::FRAC_PI_2 { Self::PI - *self } else { *self };
        two_word::sin_cos(acute).0
    }

    fn square(&self) -> Self {
        *self * *self
    }
}

impl Real for BigFloat {
    fn number(&self, integer: i16) -> Self {
        Self::from_integer(i64::from(integer), self.precision())
    }

    fn pi(&self) -> Self {
        Self::pi(self.precision())
    }

    fn polynomial(&self, coefficients: &Coefficients) -> Self {
        let precision = self.precision();
        let rounded = coefficients.exact.iter().rev().map(|c| Self::from_rational(c, precision));
        rounded.fold(self.number(0), |sum, c| sum * self.clone() + c)
    }

    fn is_zero(&self) -> bool {
        Self::is_zero(self)
    }

    fn is_negligible(&self) -> bool {
        let bits = isize::try_from(self.precision()).unwrap_or(isize::MAX);
        self.exponent().is_none_or(|exponent| exponent < -bits)
    }

    fn sqrt(&self) -> Self {
        Self::sqrt(self)
    }

    fn ln(&self) -> Self {
        Self::ln(self)
    }

    fn ln_1p(&self) -> Self {
        Self::ln_1p(self)
    }

    fn exp(&self) -> Self {
        Self::exp(self)
    }

    fn sin(&self) -> Self {
        Self::sin(self)
    }
}
