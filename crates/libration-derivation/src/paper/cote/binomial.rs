//! (23) to (25): the binomial series under the integral.

use super::period::sum_for_the_integral;
use super::terms::{TERMS, double_factorial, partial_sum};
use super::{statement, text_after};
use crate::paper::compare::{polynomial, series_in};
use crate::paper::finding::StatementFinding;
use crate::paper::printed::Printed;
use crate::paper::statement::PrintedStatement;
use libration::algebra::{Polynomial, Rational};

pub(super) const STATEMENTS: &[PrintedStatement] = &[
    statement(
        "(23)",
        "The binomial series of the integrand (s is sin(psi)), its signs as displayed.",
        &["1 + m*s^2/2 + (-1/2)*(-3/2)*m^2*s^4/2 + (-1/2)*(-3/2)*(-5/2)*(-m^3*s^6)/6 + \
             (-1/2)*(-3/2)*(-5/2)*(-7/2)*m^4*s^8/24 = \
             1 + m*s^2/2 + 1*3/(2*4)*m^2*s^4 + 1*3*5/(2*4*6)*m^3*s^6 + 1*3*5*7/(2*4*6*8)*m^4*s^8"],
        binomial_terms,
    ),
    statement(
        "(24)",
        "The integrand as the sum of this from the given n on (odd is (2n-1)!!, even is (2n)!!).",
        &["n = 1", "odd/even*m^n*s^(2*n)"],
        sum_of_the_integrand,
    ),
    text_after(
        "(24)",
        "text: 5!! = 5*3*1 and 6!! = 6*4*2",
        "Double factorials skip every second factor.",
        &["5*3*1", "6*4*2"],
        double_factorials,
    ),
    statement(
        "(25)",
        "K(m) as the sum of this from the given n on (I is the integral of sin(psi)^(2n) from 0 to pi/2).",
        &["n = 1", "odd/even*m^n*I"],
        sum_of_the_integral,
    ),
];

/// (1 − m·s²)^(−1/2), to order 8 in m, with the binomial coefficients of −1/2.
fn integrand() -> Option<Polynomial> {
    let x = Polynomial::variable("m") * Polynomial::variable("s").pow(2);
    let series = Printed::read(&["1/sqrt(1 - x)"])?;
    let coefficients = series_in("x", usize::try_from(TERMS).ok()?, series.formula(0)?, &[])?;
    Some((0..).zip(coefficients).fold(Polynomial::zero(), |sum, (n, c)| sum + x.pow(n).scaled(&c)))
}

fn binomial_terms(printed: &Printed) -> Option<StatementFinding> {
    let exact = integrand()?;
    let m = "m".into();
    let kept = (0..=4)
        .fold(Polynomial::zero(), |sum, n| sum + exact.coefficient(&m, n) * Polynomial::variable("m").pow(n));
    let sides = printed.sides(0)?.iter().map(|side| polynomial(side, &[])).collect::<Option<Vec<_>>>()?;
    let right = sides.iter().all(|side| *side == kept);
    let evidence = "both forms are the binomial series of (1 - m*s^2)^(-1/2) to m^4, exactly, with every sign as displayed";
    Some(StatementFinding::verified_if(right, kept.to_string(), evidence))
}

fn sum_of_the_integrand(printed: &Printed) -> Option<StatementFinding> {
    let missing = integrand()? - partial_sum(printed)?;
    let evidence = format!(
        "(1 - m*s^2)^(-1/2) less the sum is {missing}, exactly to m^8; (23), which it abbreviates, begins with n = 0"
    );
    Some(StatementFinding::verified_if(missing.is_zero(), "sum from n = 0, with (-1)!! = 0!! = 1", evidence))
}

fn double_factorials(printed: &Printed) -> Option<StatementFinding> {
    let (five, six) = (printed.number(0)?, printed.number(1)?);
    let right = five == Rational::from(double_factorial(5)) && six == Rational::from(double_factorial(6));
    Some(StatementFinding::verified_if(
        right,
        "",
        format!("5!! = {}, 6!! = {}", double_factorial(5), double_factorial(6)),
    ))
}

fn sum_of_the_integral(printed: &Printed) -> Option<StatementFinding> {
    sum_for_the_integral(printed, "")
}
