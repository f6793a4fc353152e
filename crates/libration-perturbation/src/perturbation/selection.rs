//! The amplitude that a weak self-excitation selects: where the first-order force does no work over a cycle.

use super::limit_cycle::first_sine;
use super::model::Selected;
use libration_numbers::internals::expression::Tape;
use libration_numbers::{
    algebra::{Rational, Rationals, Ring},
    internals::algebra::HarmonicSums,
};

/// The condition M(a) = Σ mⱼa²ʲ⁺¹ that the amplitude a = √s of a limit cycle at μ = 0 obeys: the sine of the
/// first-order acceleration, for x = a cos τ. Where its slope is positive the limit cycle attracts for μ > 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct SelectionCondition {
    /// m₀, m₁, …: a polynomial in s = a².
    coefficients: Vec<Rational>,
    degree: usize,
    symmetric: bool,
}

impl SelectionCondition {
    /// The selection from the exact values that a polynomial of this degree in x and x′ needs; `None` when one is not rational.
    pub(crate) fn new(tape: &Tape, omega0: &Rational, degree: usize, symmetric: bool) -> Option<Self> {
        let ring = HarmonicSums { numbers: Rationals };
        let amplitudes: Vec<Rational> =
            (1..=i64::try_from(degree.div_ceil(2)).ok()?).map(Rational::from).collect();
        let value = |a: &Rational| first_sine(&ring, tape, omega0, a)?.checked_div(a);
        let values = amplitudes.iter().map(value).collect::<Option<Vec<_>>>()?;
        let squares: Vec<Rational> = amplitudes.iter().map(|a| Rationals.multiply(a, a)).collect();
        Some(Self { coefficients: interpolated(&Rationals, &squares, &values)?, degree, symmetric })
    }

    /// The value of M(√s)/√s.
    fn at(&self, s: &Rational) -> Rational {
        self.coefficients
            .iter()
            .rev()
            .fold(Rational::from(0), |sum, m| Rationals.add(&Rationals.multiply(&sum, s), m))
    }

    /// M′(√s) = Σ (2j + 1)·mⱼsʲ.
    fn slope(&self, s: &Rational) -> Rational {
        let terms = self.coefficients.iter().enumerate().rev();
        terms.fold(Rational::from(0), |sum, (j, m)| {
            let weighted = Rationals.times_integer(m, i64::try_from(2 * j + 1).unwrap_or(i64::MAX));
            Rationals.add(&Rationals.multiply(&sum, s), &weighted)
        })
    }

    /// The attracting limit cycle of smallest amplitude.
    pub(crate) fn attracting(&self) -> Attracting {
        let changes = self.sign_changes();
        for (low, high) in &changes {
            match self.rational_root(low, high) {
                Some(root) => {
                    let slope = self.slope(&root);
                    if !slope.is_negative() && !slope.is_zero() {
                        return Attracting::At(root);
                    }
                }
                None if self.at(low).is_negative() => return Attracting::Irrational,
                None => {}
            }
        }
        Attracting::None { repelling: changes.len() }
    }

    /// The limit cycle with this squared amplitude.
    pub(crate) fn selected(&self, s: &Rational) -> Selected<Rational> {
        let (amplitude, unit_squared) = match s.square_root() {
            Some(root) => (root, Rational::from(1)),
            None => (Rational::from(1), s.clone()),
        };
        let (slope, degree, symmetric) = (self.slope(s), self.degree, self.symmetric);
        Selected { amplitude, unit_squared, slope, degree, symmetric }
    }

    /// Intervals of s, each with a change of sign, or a root for both ends, found on a grid between Cauchy's bounds for the roots.
    fn sign_changes(&self) -> Vec<(Rational, Rational)> {
        let Some((lowest, highest)) = self.bounds() else { return vec![] };
        let ratio = Rational::new(65, 64).expect("64 is not zero");
        let mut changes = vec![];
        let (mut s, mut before) = (lowest.clone(), self.at(&lowest));
        while s < highest && changes.len() < self.coefficients.len() {
            let next = Rationals.multiply(&s, &ratio).coarsened();
            let value = self.at(&next);
            if value.is_zero() {
                changes.push((next.clone(), next.clone()));
            } else if !before.is_zero() && before.is_negative() != value.is_negative() {
                changes.push((s.clone(), next.clone()));
            }
            (s, before) = (next, value);
        }
        changes
    }

    /// No positive root is below the first or above the second.
    fn bounds(&self) -> Option<(Rational, Rational)> {
        let present: Vec<&Rational> = self.coefficients.iter().filter(|m| !m.is_zero()).collect();
        let (first, last) = (present.first()?.magnitude(), present.last()?.magnitude());
        if present.len() < 2 {
            return None;
        }
        let largest = present.iter().map(|m| m.magnitude()).max()?;
        let one = Rational::from(1);
        let above = Rationals.add(&one, &largest.checked_div(&last)?);
        let below = first.checked_div(&Rationals.add(&first, &largest))?;
        Some((below.coarsened(), above))
    }

    /// The fraction of least denominator in ever smaller intervals about the change of sign, if it is a root: the
    /// bisection has one to try in each step.
    fn rational_root(&self, low: &Rational, high: &Rational) -> Option<Rational> {
        let (mut low, mut high) = (low.clone(), high.clone());
        if low == high {
            return Some(low);
        }
        let low_is_negative = self.at(&low).is_negative();
        for _ in 0..200 {
            let simplest = Rational::simplest_between(&low, &high);
            let value = self.at(&simplest);
            if value.is_zero() {
                return Some(simplest);
            }
            let middle = Rationals.over_integer(&Rationals.add(&low, &high), 2)?;
            if self.at(&middle).is_negative() == low_is_negative { low = middle } else { high = middle }
        }
        None
    }
}

/// The limit cycle that attracts for a weak self-excitation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Attracting {
    /// A cycle whose amplitude has this square.
    At(Rational),
    /// A cycle whose squared amplitude is not a fraction of moderate size.
    Irrational,
    /// No attracting cycle; there may be repelling ones.
    None { repelling: usize },
}

/// The coefficients of the polynomial through the points, by Newton's divided differences.
pub(crate) fn interpolated<R: Ring>(
    ring: &R,
    points: &[R::Element],
    values: &[R::Element],
) -> Option<Vec<R::Element>> {
    let mut differences = values.to_vec();
    for step in 1..points.len() {
        for i in (step..points.len()).rev() {
            let rise = ring.subtract(&differences[i], &differences[i - 1]);
            differences[i] = ring.divide(&rise, &ring.subtract(&points[i], &points[i - step]))?;
        }
    }
    let mut polynomial: Vec<R::Element> = vec![];
    for (point, difference) in points.iter().zip(&differences).rev() {
        // polynomial·(s − place) + difference.
        polynomial.insert(0, ring.zero());
        for i in 0..polynomial.len() - 1 {
            let carried = ring.multiply(&polynomial[i + 1], point);
            polynomial[i] = ring.subtract(&polynomial[i], &carried);
        }
        polynomial[0] = ring.add(&polynomial[0], difference);
    }
    Some(polynomial)
}
