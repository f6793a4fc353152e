//! Oscillators whose force has one power series above the equilibrium and another below, as in x″ + x + x|x| = 0.
//!
//! On either side the motion is that of a potential: with V = ½ω0²ρ² it is x = xₑ ± X±(ρ cos χ), −π/2 ≤ χ ≤ π/2, and ω0·dt = X±′ dχ. The
//! period follows by the mean of X±′, to which odd powers of the cosine give 1/π; the harmonics are integrals over χ of X±·cos kθ with the phase
//! θ = Ω∫dt, a series in ρ whose coefficients are polynomials in χ and harmonics. So everything is exact, in fractions and powers of π, by powers
//! of ρ and then of any other variable; and it is found in digits, at the places of a quadrature.
//!
//! # Method
//! The integrals are taken exactly in the ring of the half swing up to order 15 and, as a check and for higher orders, by Gauss's quadrature of
//! series. There are harmonics of every order; those up to the order of the expansion are given, and the result says so.

mod digits;
mod phase;
mod with_pi;

use super::approximate::{Approximated, agreed};
use super::conservative::displacement;
use super::expansion::{Certificate, Expansion, ExpansionVariable, Heading, Precision};
use super::gauge::Gauge;
use super::half_turns::BothTurns;
use super::lindstedt::{Family, Wave};
use super::series_set::{SeriesSet, composed, half_swing};
use super::shape::{Shape, shape_of};
use libration_motion::oscillator::Oscillator;
use libration_numbers::internals::progress::Watch;
use libration_numbers::internals::series::truncated::{powers, powers_of_inverse, reciprocal};
use libration_numbers::progress::Stage;
use libration_numbers::{
    algebra::{BigFloat, Floats, LaurentPolynomial, LaurentPolynomials, Rational, Rationals, Ring},
    internals::algebra::{HarmonicPair, PiPolynomial, PiPowers},
};
use libration_numbers::{
    expression::Symbol,
    internals::expression::{Jet, Tape},
};

/// Highest order with exact coefficients; a coefficient has about order³/12 terms in the computation, a product the square of that.
pub(crate) const MAX_PI_ORDER: usize = 15;

/// A force with two sides, and the expansion requested.
#[derive(Debug)]
pub(crate) struct TwoSided<'a> {
    /// Force as a function of the distance from the equilibrium.
    above: Tape,
    below: Tape,
    equilibrium: &'a Rational,
    omega0_squared: &'a Rational,
    gauge: &'a Gauge,
    shape: Shape,
    order: usize,
}

/// Computes the integrals over a side: from the coefficients of X and Ω/ω0, those of (1/π)∫ X·cos kθ dθ for each k of the list.
type Integrals<'a, R> =
    &'a dyn Fn(&Side<'_, <R as Ring>::Element>, &[usize]) -> Option<Vec<Vec<<R as Ring>::Element>>>;

/// A family with both its turning points, which are not sums of its known harmonics.
type FamilyWithTurns<E> = (Family<E>, BothTurns<E>);

/// X by powers of ρ, and Ω/ω0.
pub(super) struct Side<'a, E> {
    displacement: &'a [E],
    frequency: &'a [E],
}

impl<'a> TwoSided<'a> {
    /// Creates the family; `None` unless the oscillator has two sides and fractions as equilibrium and ω0².
    pub(crate) fn new(oscillator: &'a Oscillator, order: usize, gauge: &'a Gauge) -> Option<Self> {
        let sides = oscillator.sides()?;
        let x = Symbol::plain(oscillator.variable());
        let tape = |side| Tape::new(&[side], std::slice::from_ref(&x)).ok();
        Some(Self {
            above: tape(&sides.above)?,
            below: tape(&sides.below)?,
            equilibrium: oscillator.equilibrium().exact()?,
            omega0_squared: oscillator.omega0_squared().exact()?,
            gauge,
            shape: shape_of(oscillator.kind(), oscillator.is_odd()),
            order,
        })
    }

    /// The series as decimal numbers; `None` if two precisions do not agree, or it is cancelled.
    pub(crate) fn in_digits(&self, watch: &Watch<'_>) -> Option<Approximated> {
        let series_at = |precision: usize| {
            watch.begin(Stage::Floats { bits: precision }, Some(self.order));
            let floats = Floats { precision };
            let integrals = |side: &Side<'_, BigFloat>, harmonics: &[usize]| {
                digits::integrals(floats, side, harmonics, watch)
            };
            let set = self.series(&floats, &integrals)?;
            Some((set, floats.rational(self.omega0_squared)?, floats.rational(self.equilibrium)?))
        };
        agreed(&series_at, watch)
    }

    /// The series with powers of the letter π; `None` when a number is not in the ring.
    pub(crate) fn with_pi(&self) -> Option<SeriesSet<LaurentPolynomial>> {
        let set = self.series(&PiPowers { numbers: Rationals }, &with_pi::integrals)?;
        set.with_numbers(set.numbers().iter().map(laurent_polynomial))
    }

    /// The result with these series.
    pub(crate) fn expansion(
        &self,
        set: SeriesSet<LaurentPolynomial>,
        certificate: Certificate,
    ) -> Expansion<LaurentPolynomial> {
        let ring = letters();
        let number = |value: &Rational| ring.rational(value).unwrap_or_else(|| ring.zero());
        let heading = Heading {
            order: set.order(),
            variable: ExpansionVariable::Epsilon(self.gauge.clone()),
            phase_origin: self.shape.into(),
            has_all_harmonics: false,
            precision: Precision::Exact,
            equilibrium: number(self.equilibrium),
            omega0_squared: number(self.omega0_squared),
            unit_squared: number(&Rational::from(1)),
        };
        Expansion::new(&ring, heading, set, certificate)
    }

    /// All series over a ring.
    fn series<R: Ring>(&self, ring: &R, integrals: Integrals<'_, R>) -> Option<SeriesSet<R::Element>> {
        let above = self.displacement(ring, &self.above)?;
        let below = self.displacement(ring, &self.below)?;
        let frequency = reciprocal(ring, &period_ratio(ring, [&above, &below])?)?;
        let harmonics = self.harmonics(ring, [&above, &below], &frequency, integrals)?;
        let x_min = below.iter().map(|c| ring.negate(c)).collect();
        let (family, turning_points) =
            self.in_gauge(ring, Family { frequency, harmonics }, (above, x_min))?;
        SeriesSet::with_turning_points(ring, family, turning_points, self.shape)
    }

    /// X by powers of ρ.
    fn displacement<R: Ring>(&self, ring: &R, side: &Tape) -> Option<Vec<R::Element>> {
        let values = Jet::new(ring, side, &[ring.zero()]).ok()?.values().cloned().collect();
        displacement(ring, side, values, &ring.rational(self.omega0_squared)?, self.order)
    }

    /// The harmonics up to the order: aₖ is the sum of both sides' integrals, which have opposite signs where k is even.
    fn harmonics<R: Ring>(
        &self,
        ring: &R,
        [above, below]: [&[R::Element]; 2],
        frequency: &[R::Element],
        integrals: Integrals<'_, R>,
    ) -> Option<Vec<Vec<HarmonicPair<R::Element>>>> {
        let is_odd = self.shape == Shape::Odd;
        let present: Vec<usize> = (0..=self.order).filter(|k| !is_odd || k % 2 == 1).collect();
        let above = integrals(&Side { displacement: above, frequency }, &present)?;
        let below = if is_odd {
            above.clone()
        } else {
            integrals(&Side { displacement: below, frequency }, &present)?
        };
        let mut harmonics =
            vec![vec![Wave::Cosine.pair(ring.zero(), ring.zero()); self.order + 1]; self.order + 1];
        for (&k, (above, below)) in present.iter().zip(above.iter().zip(&below)) {
            for (power, (above, below)) in above.iter().zip(below).enumerate() {
                let sum = if k % 2 == 1 { ring.add(above, below) } else { ring.subtract(above, below) };
                harmonics[k][power] = Wave::Cosine.pair(sum, ring.zero());
            }
        }
        Some(harmonics)
    }

    /// The family with the variable of the gauge in place of ρ.
    fn in_gauge<R: Ring>(
        &self,
        ring: &R,
        family: Family<R::Element>,
        turning_points: BothTurns<R::Element>,
    ) -> Option<FamilyWithTurns<R::Element>> {
        let fundamental: Vec<R::Element> =
            family.harmonics.get(1)?.iter().map(|pair| pair.cosine.clone()).collect();
        let rho = match self.gauge {
            Gauge::Energy | Gauge::Nome => return Some((family, turning_points)),
            Gauge::XMax => powers_of_inverse(ring, &turning_points.0)?,
            Gauge::HalfSwing => powers_of_inverse(ring, &half_swing(ring, &turning_points)?)?,
            Gauge::Fundamental => powers_of_inverse(ring, &fundamental)?,
            Gauge::Coefficients(list) => {
                let mut given = vec![ring.zero(); self.order + 1];
                for (a, coefficient) in given.iter_mut().skip(1).zip(list) {
                    *a = ring.rational(coefficient)?;
                }
                let of_fundamental = powers_of_inverse(ring, &fundamental)?.first();
                powers(ring, &powers(ring, &given)?.composed(ring, &of_fundamental))?
            }
        };
        let (x_max, x_min) = turning_points;
        let turning_points = (rho.composed(ring, &x_max), rho.composed(ring, &x_min));
        Some((composed(ring, &family, &rho), turning_points))
    }
}

/// T/T0 by powers of ρ: the mean of both sides' Σ j·cⱼ·ρʲ⁻¹·⟨sinʲ⁻¹⟩, where the means over half a turn are 1, 2/π, 1/2, 4/(3π), ….
fn period_ratio<R: Ring>(ring: &R, [above, below]: [&[R::Element]; 2]) -> Option<Vec<R::Element>> {
    let mut means = [ring.rational(&1.into())?, ring.divide(&ring.rational(&2.into())?, &ring.pi()?)?];
    let mut ratio = vec![];
    for (j, (above, below)) in above.iter().zip(below).enumerate().skip(1) {
        let both = ring.times_integer(&ring.add(above, below), i64::try_from(j).ok()?);
        ratio.push(ring.over_integer(&ring.multiply(&both, &means[0]), 2)?);
        let power = u64::try_from(j).ok()?;
        let next = ring.over_integer(&ring.times_integer(&means[0], i64::try_from(j).ok()?), power + 1)?;
        means = [means[1].clone(), next];
    }
    Some(ratio)
}

/// Bits in which exact coefficients are compared with digits.
pub(crate) const AGREEING_PRECISION: usize = 400;

/// Returns `true` if coefficients with constants, for these values, equal those in digits, to 30 digits, relative for numbers above one and
/// absolute for others.
pub(crate) fn agree(exact: &[LaurentPolynomial], constants: &[BigFloat], in_digits: &[Rational]) -> bool {
    const AGREEING_BITS: isize = 100;
    let floats = Floats { precision: AGREEING_PRECISION };
    let term = |powers: &[i64], factor: &Rational| {
        let term = BigFloat::from_rational(factor, AGREEING_PRECISION);
        powers.iter().zip(constants).filter(|(half_power, _)| **half_power != 0).try_fold(
            term,
            |term, (half_power, constant)| {
                let power = floats.power(constant, &Rational::new(*half_power, 2)?)?;
                Some(floats.multiply(&term, &power))
            },
        )
    };
    let value = |number: &LaurentPolynomial| {
        number
            .half_powers()
            .try_fold(floats.zero(), |sum, (powers, factor)| Some(floats.add(&sum, &term(powers, factor)?)))
    };
    let same = |(number, digits): (&LaurentPolynomial, &Rational)| {
        let digits = BigFloat::from_rational(digits, AGREEING_PRECISION);
        let size = digits.exponent().unwrap_or(0).max(0);
        let gap = value(number).map(|value| floats.subtract(&value, &digits));
        gap.is_some_and(|gap| gap.exponent().is_none_or(|gap| gap < size - AGREEING_BITS))
    };
    exact.len() == in_digits.len() && exact.iter().zip(in_digits).all(same)
}

fn letters() -> LaurentPolynomials {
    LaurentPolynomials::new(vec!["pi".to_owned()])
}

/// The sum as a polynomial with π as a symbol.
fn laurent_polynomial(sum: &PiPolynomial<Rational>) -> LaurentPolynomial {
    let ring = letters();
    sum.terms().fold(ring.zero(), |total, (power, factor)| {
        ring.add(&total, &ring.term(Box::new([2 * i64::from(power)]), factor.clone()))
    })
}
