//! The terms of the series with their double factorials and integrals, exactly.
//!
//! In printed formulas `odd` stands for (2n − 1)!!, `even` for (2n)!!, `nn` for n!!, `s` for sin ψ, `I` for the integral of
//! sin²ⁿψ from 0 to π/2, and `I1`, `I2`, `I3` for those of n − 1, n − 2, n − 3.

use crate::paper::compare::polynomial;
use crate::paper::printed::Printed;
use libration::algebra::{Polynomial, Rational};
use libration::expression::{Expression, Symbol};
use libration::period_formulas::period_in_sine_squared;

pub(super) const TERMS: i64 = 9;

/// n·(n − 2)·(n − 4)⋯, which is 1 for n below 2.
pub(super) fn double_factorial(n: i64) -> i64 {
    (1..=n).rev().step_by(2).product()
}

pub(super) fn constant(value: i64) -> Polynomial {
    Polynomial::constant(Rational::from(value))
}

/// The integral over π/2: the mean of sin²ⁿ, which is binomial(2n, n)/4ⁿ as the constant term of its cosines.
pub(super) fn mean_of_power(n: i64) -> Option<Rational> {
    let factors = (1..=n).map(|j| Rational::new(n + j, 4 * j));
    factors.into_iter().try_fold(Rational::from(1), |product, factor| Some(product * factor?))
}

/// A term of a sum at n as a polynomial in m and s, with the integrals in units of π/2.
pub(super) fn term(formula: &Expression, n: i64) -> Option<Polynomial> {
    let at = at_index(formula, n);
    let integral = |n: i64| Some(Polynomial::constant(mean_of_power(n.max(0))?));
    let over = |value: Rational| Some(Polynomial::constant(value));
    let replaced = [
        ("odd", constant(double_factorial(2 * n - 1))),
        ("even", constant(double_factorial(2 * n))),
        ("nn", constant(double_factorial(n))),
        ("I", integral(n)?),
        ("I1", integral(n - 1)?),
        ("I2", integral(n - 2)?),
        ("I3", integral(n - 3)?),
        ("halfpi", over(Rational::from(1))?),
    ];
    polynomial(&in_half_pi(&at), &replaced)
}

pub(super) fn at_index(formula: &Expression, n: i64) -> Expression {
    formula.substitute(&Symbol::plain("n"), &Expression::Number(Rational::from(n)))
}

/// The formula with a separate name for π/2.
pub(super) fn in_half_pi(formula: &Expression) -> Expression {
    let twice = Expression::Multiply(
        Box::new(Expression::Number(Rational::from(2))),
        Box::new(Expression::symbol("halfpi")),
    );
    replace_pi(formula, &twice)
}

pub(super) fn replace_pi(formula: &Expression, by: &Expression) -> Expression {
    let inner = |a: &Expression| Box::new(replace_pi(a, by));
    match formula {
        Expression::Pi => by.clone(),
        Expression::Multiply(a, b) => Expression::Multiply(inner(a), inner(b)),
        Expression::Divide(a, b) => Expression::Divide(inner(a), inner(b)),
        Expression::Power(a, b) => Expression::Power(inner(a), inner(b)),
        _ => formula.clone(),
    }
}

/// The sum of the terms from the printed n on, up to order 8 in m.
pub(super) fn partial_sum(printed: &Printed) -> Option<Polynomial> {
    let first = i64::try_from(printed.number(0)?.to_natural()?).ok()?;
    (first..TERMS).try_fold(Polynomial::zero(), |sum, n| Some(sum + term(printed.formula(1)?, n)?))
}

/// K(m)/(π/2) up to order 8 in m.
pub(super) fn complete_integral() -> Option<Polynomial> {
    let coefficients = period_in_sine_squared(usize::try_from(TERMS).ok()?.checked_sub(1)?);
    let m = Polynomial::variable("m");
    Some((0..).zip(coefficients).fold(Polynomial::zero(), |sum, (n, c)| sum + m.pow(n).scaled(&c)))
}

/// Formats the sum times π/2, like `pi/2` for 1.
pub(super) fn times_half_pi(sum: &Polynomial) -> String {
    if *sum == constant(1) { "pi/2".to_owned() } else { format!("({sum})*pi/2") }
}
