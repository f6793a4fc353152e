//! What a formula needs of a number, for `f64` and for floats of any precision.

use crate::algebra::{BigFloat, Rational};

/// The numbers a formula is evaluated in: `f64` when speed matters, [`BigFloat`] when its error does.
pub(super) trait Real:
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
    /// Smaller in magnitude than one unit in the last place of 1.
    fn is_negligible(&self) -> bool;
    fn sqrt(&self) -> Self;
    fn ln(&self) -> Self;
    fn ln_1p(&self) -> Self;
    fn exp(&self) -> Self;
    fn sin(&self) -> Self;

    fn square(&self) -> Self {
        self.clone() * self.clone()
    }

    /// self/other, and 1 for 0/0: the quotients here are of quantities that agree at small amplitude.
    fn over(self, other: Self) -> Self {
        if other.is_zero() { other.number(1) } else { self / other }
    }
}

/// The coefficients of a polynomial, exact and rounded.
#[derive(Clone, Debug)]
pub(super) struct Coefficients {
    exact: Vec<Rational>,
    nearest: Vec<f64>,
}

impl Coefficients {
    pub(super) fn new(exact: Vec<Rational>) -> Self {
        let nearest = exact.iter().map(Rational::to_f64).collect();
        Self { exact, nearest }
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
