//! Comparison of printed with computed formulas, exactly or at sample points.

use libration::algebra::{Doubles, Polynomial, Polynomials, Rational, Ring, Variable};
use libration::expression::Expression;

use super::evaluate::value;
use super::finding::StatementFinding;
use libration::series::PowerSeries;

/// Tolerance of numerical identities; the compared values are of order 1.
pub(super) const ROUNDING: f64 = 1e-13;

/// The value of the formula for these values of its symbols; `None` if it is not a number.
pub(super) fn decimal(formula: &Expression, values: &[(&str, f64)]) -> Option<f64> {
    let number =
        value(&Doubles, formula, &|name| values.iter().find(|(symbol, _)| *symbol == name).map(|(_, v)| *v));
    number.filter(|number| !number.is_nan())
}

/// The formula as a power series in `variable`; `values` gives the other symbols.
pub(super) fn series_in(
    variable: &str,
    terms: usize,
    formula: &Expression,
    values: &[(&str, i64)],
) -> Option<Vec<Rational>> {
    let ring = PowerSeries::rational(terms);
    value(&ring, formula, &|name| {
        if name == variable {
            return ring.variable();
        }
        let (_, number) = values.iter().find(|(symbol, _)| *symbol == name)?;
        ring.rational(&Rational::from(*number))
    })
}

/// The formula as a polynomial in its symbols, some of which are replaced.
pub(super) fn polynomial(formula: &Expression, replaced: &[(&str, Polynomial)]) -> Option<Polynomial> {
    value(&Polynomials, formula, &|name| {
        let by = replaced.iter().find(|(symbol, _)| *symbol == name).map(|(_, by)| by.clone());
        Some(by.unwrap_or_else(|| Polynomial::variable(name)))
    })
}

/// A polynomial evaluated in another ring.
pub(super) fn inserted<R: Ring>(
    ring: &R,
    sum: &Polynomial,
    of: impl Fn(&str) -> Option<R::Element>,
) -> Option<R::Element> {
    let mut value = ring.zero();
    for (monomial, factor) in sum.terms() {
        let mut term = ring.rational(factor)?;
        for (name, exponent) in monomial.factors() {
            let base = of(&name.to_string())?;
            term = (0..*exponent).fold(term, |product, _| ring.multiply(&product, &base));
        }
        value = ring.add(&value, &term);
    }
    Some(value)
}

/// The finding for two polynomials that should be equal.
pub(super) fn same_polynomial(printed: &Polynomial, computed: &Polynomial, how: &str) -> StatementFinding {
    let difference = printed.clone() - computed.clone();
    if difference.is_zero() {
        return StatementFinding::verified(how);
    }
    StatementFinding::wrong(computed.to_string(), format!("{how}; printed less computed is {difference}"))
}

/// The index of the first coefficient in which two series differ, with the difference a − b.
pub(super) fn first_difference(a: &[Rational], b: &[Rational]) -> Option<(usize, Rational)> {
    let differences = a.iter().zip(b).map(|(a, b)| a.clone() - b.clone());
    differences.enumerate().find(|(_, difference)| !difference.is_zero())
}

/// The largest |residual| of an equation at points distributed over boxes with these ranges.
pub(super) fn largest_residual(residual: &Expression, ranges: &[(&str, f64, f64)]) -> Option<f64> {
    let mut largest = 0.0_f64;
    for index in 1..=POINTS {
        let at = point(index, ranges);
        largest = largest.max(decimal(residual, &at)?.abs());
    }
    Some(largest)
}

/// Number of points at which an identity is tested.
pub(super) const POINTS: u32 = 40;

/// A point of an additive recurrence with the roots of primes, which fills the box uniformly.
fn point<'a>(index: u32, ranges: &[(&'a str, f64, f64)]) -> Vec<(&'a str, f64)> {
    const PRIMES: [f64; 8] = [2.0, 3.0, 5.0, 7.0, 11.0, 13.0, 17.0, 19.0];
    let coordinate = |(prime, (name, low, high)): (&f64, &(&'a str, f64, f64))| {
        let turns = f64::from(index) * prime.sqrt();
        (*name, low + (high - low) * (turns - turns.floor()))
    };
    PRIMES.iter().zip(ranges).map(coordinate).collect()
}

/// The finding for an identity, tested at points.
pub(super) fn identity(
    residual: &Expression,
    ranges: &[(&str, f64, f64)],
    what: &str,
) -> Option<StatementFinding> {
    let largest = largest_residual(residual, ranges)?;
    let evidence = format!("{what}: at {POINTS} points the sides differ by at most {largest:.1e}");
    Some(StatementFinding::verified_if(largest < ROUNDING, "", evidence))
}

/// The coefficients of a polynomial in one variable.
pub(super) fn coefficients(sum: &Polynomial, name: &str, terms: usize) -> Option<Vec<Rational>> {
    let variable = Variable::from(name);
    (0..u32::try_from(terms).ok()?).map(|power| sum.coefficient(&variable, power).to_constant()).collect()
}

/// A series as text, without zero terms.
pub(super) fn written(series: &[Rational], name: &str) -> String {
    let power = |n: usize| Polynomial::variable(name).pow(u32::try_from(n).unwrap_or(u32::MAX));
    let terms = series.iter().enumerate().filter(|(_, c)| !c.is_zero());
    terms.fold(Polynomial::zero(), |sum, (n, c)| sum + power(n).scaled(c)).to_string()
}

/// The finding for a printed series that should agree with a computed one up to a power.
pub(super) fn against_series(
    stands: &[Rational],
    computed: &[Rational],
    through: usize,
    name: &str,
    how: &str,
) -> Option<StatementFinding> {
    let agrees_below = first_difference(stands, computed).map_or(stands.len(), |(power, _)| power);
    let correct = written(computed.get(..=through)?, name);
    let evidence = format!("{how}, exactly: {} + ...", written(computed, name));
    Some(StatementFinding::verified_if(agrees_below > through, correct, evidence))
}
