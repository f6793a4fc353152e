//! The ring of power series in one variable, truncated to a number of terms, over any ring of coefficients.

use super::recurrences::{Both, weighted_integral, weighted_integral_of_quotient, weighted_power};
use super::truncated::{product, reciprocal};
use crate::algebra::{Divisor, Function, Pair, Rational, Rationals, Ring, Rule, Slope};

/// Truncated power series as elements of a ring: lists of their first coefficients, the constant term first. Operations give as many
/// coefficients as their operands determine; a quotient in which powers of the variable cancel has fewer.
///
/// ```
/// # extern crate libration_numbers as libration;
/// use libration::algebra::{Function, Ring};
/// use libration::series::PowerSeries;
///
/// // tan x = x + x³/3 + 2x⁵/15 + …
/// let series = PowerSeries::rational(6);
/// let x = series.variable().ok_or("no variable")?;
/// let tangent = series.value(Function::Tan, &x).ok_or("no series")?;
/// assert_eq!(tangent[5].to_string(), "2/15");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct PowerSeries<R> {
    /// The ring of the coefficients.
    pub coefficients: R,
    /// Number of coefficients that are kept.
    pub terms: usize,
}

impl PowerSeries<Rationals> {
    /// Series with rational coefficients.
    #[must_use]
    pub const fn rational(terms: usize) -> Self {
        Self { coefficients: Rationals, terms }
    }
}

impl<R: Ring> PowerSeries<R> {
    /// The variable itself; `None` if the ring of coefficients has no one.
    #[must_use]
    pub fn variable(&self) -> Option<Vec<R::Element>> {
        let coefficient = |n: usize| self.coefficients.rational(&Rational::from(i64::from(n == 1)));
        (0..self.terms).map(coefficient).collect()
    }

    /// A constant with as many coefficients as another series.
    fn constant(&self, value: R::Element, like: &[R::Element]) -> Vec<R::Element> {
        let rest = like.iter().skip(1).map(|_| self.coefficients.zero());
        std::iter::once(value).chain(rest).take(like.len()).collect()
    }

    /// n·aₙ.
    fn weighted(&self, a: &[R::Element]) -> Vec<R::Element> {
        let weight = |(n, a)| Some(self.coefficients.times_integer(a, i64::try_from(n).ok()?));
        a.iter().enumerate().map_while(weight).collect()
    }

    /// The series with this constant term whose n·cₙ follow from c₀ … cₙ₋₁ and the weighted c₀ … (n − 1)cₙ₋₁.
    fn solve(
        &self,
        first: R::Element,
        length: usize,
        next: impl Fn(usize, Both<'_, R::Element>) -> Option<R::Element>,
    ) -> Option<Vec<R::Element>> {
        let ring = &self.coefficients;
        let (mut plain, mut weighted) = (vec![first], vec![ring.zero()]);
        for n in 1..length {
            let coefficient = next(n, Both { plain: &plain, weighted: &weighted })?;
            plain.push(ring.over_integer(&coefficient, u64::try_from(n).ok()?)?);
            weighted.push(coefficient);
        }
        Some(plain)
    }

    /// The solution of s′ = a′·c and c′ = sign·a′·s that begins with the values of the two functions of a pair.
    fn pair(
        &self,
        a: &[R::Element],
        Pair { functions: [sine, cosine], slope }: Pair,
    ) -> Option<[Vec<R::Element>; 2]> {
        let ring = &self.coefficients;
        let weighted = self.weighted(a);
        let mut sines = vec![ring.value(sine, a.first()?)?];
        let mut cosines = vec![ring.value(cosine, a.first()?)?];
        for n in 1..a.len() {
            let integral = |other: &[R::Element]| {
                let sum = weighted_integral(ring, &weighted[1..=n], other);
                ring.over_integer(&sum, u64::try_from(n).ok()?)
            };
            let (s, c) = (integral(&cosines)?, integral(&sines)?);
            sines.push(s);
            cosines.push(if slope == Slope::Plus { c } else { ring.negate(&c) });
        }
        Some([sines, cosines])
    }

    fn divisor(&self, divisor: Divisor, a: &[R::Element]) -> Option<Vec<R::Element>> {
        match divisor {
            Divisor::Argument => Some(a.to_vec()),
            Divisor::OneAndSquare => self.one_and_square(1, a),
            Divisor::RootOfOneLessSquare => self.value(Function::Sqrt, &self.one_and_square(-1, a)?),
        }
    }

    /// The c with c′ = a′/r.
    fn integral_of_quotient(
        &self,
        first: R::Element,
        a: &[R::Element],
        r: &[R::Element],
    ) -> Option<Vec<R::Element>> {
        let weighted = self.weighted(a);
        self.solve(first, a.len().min(r.len()), |n, c| {
            weighted_integral_of_quotient(&self.coefficients, &weighted[n], &c.weighted[1..], &r[..n])
        })
    }

    /// 1 + sign·a².
    fn one_and_square(&self, sign: i64, a: &[R::Element]) -> Option<Vec<R::Element>> {
        let one = self.constant(self.coefficients.rational(&Rational::from(1))?, a);
        let square = product(&self.coefficients, a, a, a.len());
        Some(self.add(&one, &self.times_integer(&square, sign)))
    }
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

    /// First divides both operands by the lowest power of the variable in the divisor, which costs that many coefficients.
    fn divide(&self, a: &Self::Element, divisor: &Self::Element) -> Option<Self::Element> {
        let ring = &self.coefficients;
        let shift = divisor.iter().position(|coefficient| !ring.is_zero(coefficient))?;
        if a.iter().take(shift).any(|coefficient| !ring.is_zero(coefficient)) {
            return None;
        }
        let inverse = reciprocal(ring, &divisor[shift..])?;
        Some(self.multiply(&a.get(shift..)?.to_vec(), &inverse))
    }

    fn over_integer(&self, a: &Self::Element, divisor: u64) -> Option<Self::Element> {
        a.iter().map(|a| self.coefficients.over_integer(a, divisor)).collect()
    }

    /// The series of a function, if the function is analytic and its value at the constant term is in the ring of coefficients.
    fn value(&self, function: Function, at: &Self::Element) -> Option<Self::Element> {
        let ring = &self.coefficients;
        let first = at.first()?;
        match function.rule() {
            Rule::Root => self.power(at, &Rational::new(1, 2)?),
            Rule::Paired(pair) => {
                let [sine, cosine] = self.pair(at, pair)?;
                Some(if function == pair.functions[0] { sine } else { cosine })
            }
            Rule::Quotient(pair) => {
                let [sine, cosine] = self.pair(at, pair)?;
                self.divide(&sine, &cosine)
            }
            Rule::Itself => {
                let weighted = self.weighted(at);
                let next =
                    |n: usize, c: Both<'_, _>| Some(weighted_integral(ring, &weighted[1..=n], c.plain));
                self.solve(ring.value(function, first)?, at.len(), next)
            }
            Rule::Inverse(slope, divisor) => {
                let divisor = self.divisor(divisor, at)?;
                let divisor = if slope == Slope::Plus { divisor } else { self.negate(&divisor) };
                self.integral_of_quotient(ring.value(function, first)?, at, &divisor)
            }
            Rule::Modulus | Rule::Step if ring.is_zero(first) => None,
            Rule::Modulus => {
                let sign = self.constant(ring.value(Function::Sign, first)?, at);
                Some(self.multiply(&sign, at))
            }
            Rule::Step => Some(self.constant(ring.value(function, first)?, at)),
        }
    }

    /// aᵖ, if the constant term of the result is in the ring of coefficients and not zero.
    fn power(&self, a: &Self::Element, exponent: &Rational) -> Option<Self::Element> {
        let ring = &self.coefficients;
        let first = a.first()?;
        let value = ring.power(first, exponent)?;
        let exponent = ring.rational(exponent)?;
        let weighted = self.weighted(a);
        self.solve(value, a.len(), |n, c| {
            let a = Both { plain: &a[..=n], weighted: &weighted[..=n] };
            ring.divide(&weighted_power(ring, &exponent, a, c), first)
        })
    }

    fn pi(&self) -> Option<Self::Element> {
        let mut constant = self.zero();
        *constant.first_mut()? = self.coefficients.pi()?;
        Some(constant)
    }
}
