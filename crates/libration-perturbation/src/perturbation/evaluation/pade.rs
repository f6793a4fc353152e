//! Padé approximants: the quotient of polynomials that has the same first coefficients as a series.

use std::f64::consts::TAU;

use super::{PRECISION, float};
use libration_numbers::algebra::{BigFloat, Complex, Rational};
use libration_numbers::internals::algebra::univariate::{divided, trimmed};
use libration_numbers::{internals::roots::value_and_slope, roots::polynomial_roots};

/// The Padé approximant [m/n] of a power series, exact.
///
/// # Examples
/// ```
/// # extern crate libration_perturbation as libration;
/// use libration::perturbation::Pade;
/// // T/T0 of the pendulum by powers of θ0²; [0/1] is 1/(1 − θ0²/16).
/// let series = ["1", "1/16", "11/3072"].map(|text| text.parse().unwrap());
/// let pade = Pade::new(&series, 0, 1).unwrap();
/// assert_eq!(pade.denominator()[1].to_string(), "-1/16");
/// assert_eq!(pade.poles()[0].position.re, 16.0);
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pade {
    numerator: Vec<Rational>,
    denominator: Vec<Rational>,
    /// The series from which the approximant was computed, and its degrees.
    series: Vec<Rational>,
    degrees: (usize, usize),
}

/// A pole of an approximant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pole {
    /// Position in the complex plane.
    pub position: Complex,
    /// Residue: the coefficient of 1/(z − position).
    pub residue: Complex,
    /// `true` if it is probably an artefact of this approximant: the next lower one has no pole in that direction, or a
    /// zero nearly cancels it.
    pub spurious: bool,
}

impl Pade {
    /// The approximant with a numerator of degree at most m and a denominator of degree at most n that agrees with
    /// the series Σ cₖzᵏ up to z^(m + n). `None` when fewer than m + n + 1 coefficients are given, or when such a
    /// quotient does not exist.
    ///
    /// Reference: G. A. Baker and P. Graves-Morris, *Padé Approximants* (1996), section 2.4.
    #[must_use]
    pub fn new(coefficients: &[Rational], m: usize, n: usize) -> Option<Self> {
        let series = coefficients.get(..m.checked_add(n)?.checked_add(1)?)?;
        // Euclid's algorithm for z^(m+n+1) and the series: every remainder is a multiple of the series plus one of
        // the power, and the first of degree m or less is the numerator.
        let mut power = vec![Rational::from(0); series.len() + 1];
        power[series.len()] = Rational::from(1);
        let (mut before, mut factor_before) = (power, vec![]);
        let (mut remainder, mut factor) = (trimmed(series.to_vec()), vec![Rational::from(1)]);
        while remainder.len() > m + 1 {
            let (quotient, rest) = divided(&before, &remainder)?;
            let next = subtract_product(factor_before, &quotient, &factor);
            (before, factor_before) = (remainder, factor);
            // Remainders that begin with one have numerators and denominators that grow linearly, others quadratically.
            let unit = rest.last().and_then(|leading| Rational::from(1).checked_div(leading));
            (remainder, factor) = match unit {
                Some(unit) => (scaled(rest, &unit), scaled(next, &unit)),
                None => (rest, next),
            };
        }
        let unit = Rational::from(1).checked_div(factor.first()?)?;
        let (numerator, denominator) = (scaled(remainder, &unit), scaled(factor, &unit));
        Some(Self { numerator, denominator, series: series.to_vec(), degrees: (m, n) })
    }

    /// The coefficients of the numerator, constant term first; empty for zero.
    #[must_use]
    pub fn numerator(&self) -> &[Rational] {
        &self.numerator
    }

    /// The coefficients of the denominator, constant term first, which is 1.
    #[must_use]
    pub fn denominator(&self) -> &[Rational] {
        &self.denominator
    }

    /// The value at a number, which is taken as exact; infinite or NaN at a pole, NaN where z is not finite.
    ///
    /// # Accuracy
    /// Rounded once, unless 50 digits cancel in numerator or denominator.
    #[must_use]
    pub fn value_at(&self, z: f64) -> f64 {
        let value = |terms: &[Rational]| {
            terms
                .iter()
                .rev()
                .fold(float(0.0), |sum, term| sum * float(z) + BigFloat::from_rational(term, PRECISION))
        };
        let (above, below) = (value(&self.numerator), value(&self.denominator));
        if !z.is_finite() {
            return f64::NAN;
        }
        if below.is_zero() { above.to_f64() / 0.0 } else { (above / below).to_f64() }
    }

    /// The poles by ascending distance.
    ///
    /// # Accuracy From coefficients rounded to `f64`: the poles nearest to 0 have many correct digits, distant
    /// ones fewer.
    #[must_use]
    pub fn poles(&self) -> Vec<Pole> {
        let of_numerator = zeros(&self.numerator);
        let directions = self.next_lower().map(|lower| zeros(&lower.denominator));
        let pole = |position: Complex| {
            // A pole with a zero next to it: the approximant has more terms than the digits of the series determine.
            let cancelled = of_numerator.iter().any(|zero| (*zero - position).abs() < 1e-4 * position.abs());
            let alone = directions
                .as_ref()
                .is_some_and(|lower_zeros| !lower_zeros.iter().any(|z| same_direction(*z, position)));
            Pole { position, residue: self.residue(position), spurious: cancelled || alone }
        };
        zeros(&self.denominator).into_iter().map(pole).collect()
    }

    /// [m−1/n−1], or [m−1/n] where that has no poles.
    fn next_lower(&self) -> Option<Self> {
        let (m, n) = self.degrees;
        Self::new(&self.series, m.checked_sub(1)?, if n > 1 { n - 1 } else { n })
    }

    /// Numerator over the slope of the denominator.
    fn residue(&self, at: Complex) -> Complex {
        let numbers = |terms: &[Rational]| terms.iter().map(Rational::to_f64).collect::<Vec<_>>();
        let (above, below) = (numbers(&self.numerator), numbers(&self.denominator));
        let (value, _) = value_and_slope(above.iter().rev(), at);
        let (_, slope) = value_and_slope(below.iter().rev(), at);
        value / slope
    }
}

/// Returns `true` if two points are seen from 0 within a twentieth of a turn.
fn same_direction(a: Complex, b: Complex) -> bool {
    let quotient = a / b;
    libm::atan2(quotient.im, quotient.re).abs() < 0.05 * TAU
}

/// The roots of a polynomial that are not zero, by ascending magnitude.
fn zeros(terms: &[Rational]) -> Vec<Complex> {
    let from = terms.iter().position(|term| !term.is_zero()).unwrap_or(terms.len());
    let terms = &terms[from..];
    let Some(scale) = scale_of_roots(terms) else { return vec![] };
    let powers = std::iter::successors(Some(Rational::from(1)), |power| Some(power.clone() * scale.clone()));
    let scaled =
        terms.iter().zip(powers).filter_map(|(term, power)| (term.clone() * power).checked_div(&terms[0]));
    let scaled: Vec<f64> = scaled.map(|term| term.to_f64()).collect();
    let roots = polynomial_roots(&scaled).unwrap_or_default().into_iter();
    roots.map(|root| root.value.scaled(scale.to_f64())).collect()
}

/// A power of two near the geometric mean of the roots; `None` for a constant.
fn scale_of_roots(terms: &[Rational]) -> Option<Rational> {
    let degree = isize::try_from(terms.len().checked_sub(1)?).ok().filter(|degree| *degree > 0)?;
    let product = terms.first()?.checked_div(terms.last()?)?;
    let exponent = BigFloat::from_rational(&product, 64).exponent()?;
    Rational::from(2).integer_power(exponent / degree)
}

/// a − b·c.
fn subtract_product(mut a: Vec<Rational>, b: &[Rational], c: &[Rational]) -> Vec<Rational> {
    a.resize(a.len().max(b.len() + c.len()), Rational::from(0));
    for (i, x) in b.iter().enumerate() {
        for (target, y) in a[i..].iter_mut().zip(c) {
            *target = target.clone() - x.clone() * y.clone();
        }
    }
    trimmed(a)
}

fn scaled(terms: Vec<Rational>, by: &Rational) -> Vec<Rational> {
    terms.into_iter().map(|term| term * by.clone()).collect()
}
