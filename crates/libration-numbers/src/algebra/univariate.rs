//! Polynomials in one variable with rational coefficients, constant term first.

use super::{Rational, Rationals, Ring};

/// The polynomial without leading zeros.
pub fn trimmed(mut polynomial: Vec<Rational>) -> Vec<Rational> {
    while polynomial.last().is_some_and(Rational::is_zero) {
        polynomial.pop();
    }
    polynomial
}

/// Quotient and remainder; `None` for a division by zero.
pub fn divided(polynomial: &[Rational], by: &[Rational]) -> Option<(Vec<Rational>, Vec<Rational>)> {
    let leading = by.last()?;
    let mut rest = polynomial.to_vec();
    let mut quotient = vec![];
    while rest.len() >= by.len() {
        let factor = rest.last()?.checked_div(leading)?;
        let shift = rest.len() - by.len();
        for (entry, coefficient) in rest[shift..].iter_mut().zip(by) {
            *entry = Rationals.subtract(entry, &Rationals.multiply(&factor, coefficient));
        }
        quotient.push(factor);
        rest.pop();
    }
    quotient.reverse();
    Some((quotient, trimmed(rest)))
}

/// The quotient, if the remainder is zero.
pub fn divided_exactly(polynomial: &[Rational], by: &[Rational]) -> Option<Vec<Rational>> {
    divided(polynomial, by).filter(|(_, rest)| rest.is_empty()).map(|(quotient, _)| quotient)
}

fn derivative(polynomial: &[Rational]) -> Vec<Rational> {
    (1..).zip(&polynomial[1..]).map(|(n, c)| Rationals.times_integer(c, n)).collect()
}

/// The common divisor of highest degree, with a leading coefficient of one.
fn common_divisor(a: &[Rational], b: &[Rational]) -> Vec<Rational> {
    let (mut a, mut b) = (a.to_vec(), b.to_vec());
    while let Some((_, rest)) = divided(&a, &b) {
        (a, b) = (b, rest);
    }
    let leading = a.last().cloned().unwrap_or_else(|| Rational::from(1));
    a.iter().filter_map(|c| c.checked_div(&leading)).collect()
}

/// The square-free factors of the polynomial, each with its multiplicity (Yun's algorithm).
pub fn square_free_factors(polynomial: &[Rational]) -> Vec<(Vec<Rational>, usize)> {
    let (mut factors, mut multiplicity) = (vec![], 1);
    if polynomial.len() < 2 {
        return factors;
    }
    let mut rest = common_divisor(polynomial, &derivative(polynomial));
    let mut simple = divided_exactly(polynomial, &rest).unwrap_or_default();
    while simple.len() > 1 {
        let again = common_divisor(&simple, &rest);
        let factor = divided_exactly(&simple, &again).unwrap_or_default();
        if factor.len() > 1 {
            factors.push((factor, multiplicity));
        }
        rest = divided_exactly(&rest, &again).unwrap_or_default();
        simple = again;
        multiplicity += 1;
    }
    factors
}
