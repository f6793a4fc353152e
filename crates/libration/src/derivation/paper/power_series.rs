//! The ring of power series in one variable, kept to a number of terms, over any ring of coefficients.

use crate::algebra::{Function, Rational, Rationals, Ring};
use crate::series::truncated::{product, reciprocal};

/// Series are their first coefficients, the constant term first. A quotient in which powers cancel keeps fewer.
#[derive(Clone, Copy, Debug)]
pub(super) struct PowerSeries<R> {
    pub(super) coefficients: R,
    /// How many coefficients are kept.
    pub(super) terms: usize,
}

impl PowerSeries<Rationals> {
    /// Series with rational coefficients.
    pub(super) fn rational(terms: usize) -> Self {
        Self { coefficients: Rationals, terms }
    }
}

impl<R: Ring> PowerSeries<R> {
    /// The variable itself.
    pub(super) fn variable(&self) -> Option<Vec<R::Element>> {
        let coefficient = |n: usize| self.coefficients.rational(&Rational::from(i64::from(n == 1)));
        (0..self.terms).map(coefficient).collect()
    }

    /// Σ factor(k)·aₖ·b_{n−k} over 1 ≤ k ≤ n.
    fn weighted(
        &self,
        a: &[R::Element],
        b: &[R::Element],
        n: usize,
        factor: impl Fn(usize) -> Option<Rational>,
    ) -> Option<R::Element> {
        let ring = &self.coefficients;
        let term =
            |k: usize| Some(ring.multiply(&ring.rational(&factor(k)?)?, &ring.multiply(&a[k], &b[n - k])));
        (1..=n).try_fold(ring.zero(), |sum, k| Some(ring.add(&sum, &term(k)?)))
    }

    /// The solution of b′ = a′·c and c′ = sign·a′·b that begins with these values.
    fn pair(&self, a: &[R::Element], first: [Function; 2], sign: i64) -> Option<[Vec<R::Element>; 2]> {
        let ring = &self.coefficients;
        let start = |function| ring.value(function, a.first()?);
        let (mut sine, mut cosine) = (vec![start(first[0])?], vec![start(first[1])?]);
        for n in 1..a.len() {
            let integral = |other: &[R::Element]| {
                ring.over_integer(&self.weighted(a, other, n, whole)?, u64::try_from(n).ok()?)
            };
            let (s, c) = (integral(&cosine)?, integral(&sine)?);
            sine.push(s);
            cosine.push(ring.times_integer(&c, sign));
        }
        Some([sine, cosine])
    }
}

fn whole(n: usize) -> Option<Rational> {
    i64::try_from(n).ok().map(Rational::from)
}

impl<R: Ring> Ring for PowerSeries<R> {
    type Element = Vec<R::Element>;

    fn zero(&self) -> Self::Element {
        vec![self.coefficients.zero(); self.terms]
    }

    fn is_zero(&self, a: &Self::Element) -> bool {
        a.iter().all(|coefficient| self.coefficients.is_zero(coefficient))
    }

    fn rational(&self, value: &Rational) -> Option<Self::Element> {
        let mut constant = self.zero();
        *constant.first_mut()? = self.coefficients.rational(value)?;
        Some(constant)
    }

    fn add(&self, a: &Self::Element, b: &Self::Element) -> Self::Element {
        a.iter().zip(b).map(|(a, b)| self.coefficients.add(a, b)).collect()
    }

    fn subtract(&self, a: &Self::Element, b: &Self::Element) -> Self::Element {
        a.iter().zip(b).map(|(a, b)| self.coefficients.subtract(a, b)).collect()
    }

    fn negate(&self, a: &Self::Element) -> Self::Element {
        a.iter().map(|a| self.coefficients.negate(a)).collect()
    }

    fn multiply(&self, a: &Self::Element, b: &Self::Element) -> Self::Element {
        product(&self.coefficients, a, b, a.len().min(b.len()))
    }

    fn times_integer(&self, a: &Self::Element, factor: i64) -> Self::Element {
        a.iter().map(|a| self.coefficients.times_integer(a, factor)).collect()
    }

    fn divide(&self, a: &Self::Element, divisor: &Self::Element) -> Option<Self::Element> {
        let ring = &self.coefficients;
        let shift = divisor.iter().position(|coefficient| !ring.is_zero(coefficient))?;
        if a.iter().take(shift).any(|coefficient| !ring.is_zero(coefficient)) {
            return None;
        }
        let quotient = self.multiply(&a.get(shift..)?.to_vec(), &reciprocal(ring, &divisor[shift..])?);
        Some(quotient)
    }

    fn over_integer(&self, a: &Self::Element, divisor: u64) -> Option<Self::Element> {
        a.iter().map(|a| self.coefficients.over_integer(a, divisor)).collect()
    }

    /// Where the coefficients stay in their ring.
    fn value(&self, function: Function, at: &Self::Element) -> Option<Self::Element> {
        let circular = || self.pair(at, [Function::Sin, Function::Cos], -1);
        let hyperbolic = || self.pair(at, [Function::Sinh, Function::Cosh], 1);
        match function {
            Function::Sqrt => self.power(at, &Rational::new(1, 2)?),
            Function::Sin => circular().map(|[sine, _]| sine),
            Function::Cos => circular().map(|[_, cosine]| cosine),
            Function::Sinh => hyperbolic().map(|[sine, _]| sine),
            Function::Cosh => hyperbolic().map(|[_, cosine]| cosine),
            Function::Exp => hyperbolic().map(|[sine, cosine]| self.add(&sine, &cosine)),
            _ => None,
        }
    }

    /// b = aᵖ from n·a₀·bₙ = Σ (p·k − (n − k))·aₖ·b_{n−k}.
    fn power(&self, a: &Self::Element, exponent: &Rational) -> Option<Self::Element> {
        let ring = &self.coefficients;
        let mut b = vec![ring.power(a.first()?, exponent)?];
        for n in 1..a.len() {
            let factor = |k: usize| Some(exponent.clone() * whole(k)? - whole(n - k)?);
            let sum = self.weighted(a, &b, n, factor)?;
            b.push(ring.divide(&ring.over_integer(&sum, u64::try_from(n).ok()?)?, a.first()?)?);
        }
        Some(b)
    }

    fn pi(&self) -> Option<Self::Element> {
        None
    }
}
