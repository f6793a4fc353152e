//! (25) to (31): the truncated system solved to third order.

use super::statement;
use super::two_harmonics::condition;
use crate::paper::amplitudes::at_degrees;
use crate::paper::compare::{
    against_series, coefficients, decimal, first_difference, inserted, polynomial, series_in, written,
};
use crate::paper::exact_motion::harmonics;
use crate::paper::finding::StatementFinding;
use crate::paper::lindstedt::{Expansion, numbers};
use crate::paper::printed::Printed;
use crate::paper::statement::PrintedStatement;
use libration::algebra::{Polynomial, Rational, Rationals, Ring, Variable};
use libration::series::PowerSeries;
use libration::series::powers_of_inverse;

pub(super) const STATEMENTS: &[PrintedStatement] = &[
    statement(
        "(25)",
        "(22) solved for the square of the frequency.",
        &["Delta^2 = 1 - (a1^2 + a1*a3 + a3^2)/8"],
        solved_for_the_frequency,
    ),
    statement(
        "(26)",
        "Its root, where a3 is much smaller than a1.",
        &["Delta = 1 - a1^2/16"],
        root_of_the_square,
    ),
    statement(
        "(27)",
        "(26) in (23), solved for the a3 that stands alone.",
        &["a3 = (-a1^3 + 426*a1^2*a3 - 216*a1^4*a3 - 3*a3^3)/192"],
        solved_for_the_third,
    ),
    statement("(28)", "Its leading term.", &["a3 = -a1^3/192"], third_of_fundamental),
    statement("(29)", "The same in the amplitude.", &["a3 = -theta0^3/192"], third_of_amplitude),
    statement(
        "(30)",
        "The fundamental in the amplitude.",
        &["a1 = theta0 + theta0^3/192"],
        fundamental_of_amplitude,
    ),
    statement(
        "(31)",
        "The frequency in the amplitude.",
        &["Delta = 1 - theta0^2/16"],
        frequency_of_amplitude,
    ),
];

/// Δ² from the projection on the fundamental, which is linear in it.
fn square_of_frequency() -> Option<Polynomial> {
    let condition = condition(1)?;
    let delta = Variable::from("Delta");
    (-condition.coefficient(&delta, 0)).divide_exactly(&condition.coefficient(&delta, 2))
}

fn solved_for_the_frequency(printed: &Printed) -> Option<StatementFinding> {
    let (stands, computed) = (polynomial(printed.formula(0)?, &[])?, square_of_frequency()?);
    let difference = stands.clone() - computed.clone();
    if difference.is_zero() {
        return Some(StatementFinding::verified("(22) solved for Delta^2, exactly"));
    }
    let left_over = condition(1)?.coefficient(&"Delta".into(), 0)
        + condition(1)?.coefficient(&"Delta".into(), 2) * stands;
    let order = order_of(&difference);
    let evidence = format!(
        "(22) solved for Delta^2 exactly; the printed form less the correct one is {difference}, and put into the \
         projection it leaves {left_over} instead of 0; the difference is of the order theta0^{order}, beyond what \
         is kept"
    );
    Some(StatementFinding::wrong(format!("Delta^2 = {computed}"), evidence))
}

/// The lowest power of θ0, with a1 of first and a3 of third order.
fn order_of(sum: &Polynomial) -> u32 {
    let weight = |name: &Variable| name.index().unwrap_or(0);
    let orders = sum
        .terms()
        .map(|(monomial, _)| monomial.factors().iter().map(|(name, exponent)| weight(name) * exponent).sum());
    orders.min().unwrap_or(0)
}

fn root_of_the_square(printed: &Printed) -> Option<StatementFinding> {
    const TERMS: usize = 6;
    let leading = square_of_frequency()?.substitute(&"a3".into(), &Polynomial::zero());
    let root =
        PowerSeries::rational(TERMS).power(&coefficients(&leading, "a1", TERMS)?, &Rational::new(1, 2)?)?;
    let stands = series_in("a1", TERMS, printed.formula(0)?, &[])?;
    let agrees_below = first_difference(&stands, &root).map_or(TERMS, |(power, _)| power);
    let evidence = format!(
        "the root of the correct Delta^2 at a3 = 0 is {} + ..., exactly; a3, of the order a1^3, enters at a1^4",
        written(&root[..4], "a1")
    );
    Some(StatementFinding::verified_if(
        agrees_below > 2,
        format!("Delta = {}", written(&root[..3], "a1")),
        evidence,
    ))
}

/// The second condition with this frequency, solved for the linear a3: numerator and divisor.
fn third_alone(frequency: &Polynomial) -> Option<(Polynomial, Rational)> {
    let scaled = condition(3)?.scaled(&Rational::from(-24)).substitute(&"Delta".into(), frequency);
    let alone =
        scaled.coefficient(&"a3".into(), 1).substitute(&"a1".into(), &Polynomial::zero()).to_constant()?;
    Some((Polynomial::variable("a3").scaled(&alone) - scaled, alone))
}

fn solved_for_the_third(printed: &Printed) -> Option<StatementFinding> {
    let stands = polynomial(printed.formula(0)?, &[])?;
    let of_frequency = |text: &str| {
        let frequency = Printed::read(&[text])?;
        third_alone(&polynomial(frequency.formula(0)?, &[])?)
    };
    let (numerator, divisor) = of_frequency("1 - a1^2/16")?;
    let (slip, slip_divisor) = of_frequency("1 - a1^2")?;
    let inverse = Rational::from(1).checked_div(&divisor)?;
    if stands == numerator.scaled(&inverse) {
        return Some(StatementFinding::verified("(26) put into (23) and solved for a3, exactly"));
    }
    let from_slip = stands == slip.scaled(&Rational::from(1).checked_div(&slip_divisor)?);
    let origin = if from_slip { ", which is exactly what is printed: the 1/16 was lost" } else { "" };
    let evidence = format!(
        "(26) put into (23), exactly, gives 192*a3 = {numerator}; with Delta = 1 - a1^2 instead it gives \
         {slip_divisor}*a3 = {slip}{origin}; the leading term and so (28) are not touched"
    );
    Some(StatementFinding::wrong(format!("a3 = ({numerator})/{divisor}"), evidence))
}

/// a3 as a function of a1 from both conditions, as a series, by iteration.
fn third_of_fundamental_series(terms: usize) -> Option<Vec<Rational>> {
    let delta = Variable::from("Delta");
    let condition = condition(3)?;
    let eliminated =
        condition.coefficient(&delta, 0) + condition.coefficient(&delta, 2) * square_of_frequency()?;
    let alone = eliminated
        .coefficient(&"a3".into(), 1)
        .substitute(&"a1".into(), &Polynomial::zero())
        .to_constant()?;
    let next = Polynomial::variable("a3") - eliminated.scaled(&Rational::from(1).checked_div(&alone)?);
    let mut third = Polynomial::zero();
    for _ in 0..terms {
        let better = next.substitute(&"a3".into(), &third);
        third = powers(&coefficients(&better, "a1", terms)?, "a1");
    }
    coefficients(&third, "a1", terms)
}

fn powers(series: &[Rational], name: &str) -> Polynomial {
    let power = |n: u32| Polynomial::variable(name).pow(n);
    (0..).zip(series).fold(Polynomial::zero(), |sum, (n, c)| sum + power(n).scaled(c))
}

/// a1, a3 and Δ of the truncated system as series in θ0.
fn solution_in_amplitude(terms: usize) -> Option<[Vec<Rational>; 3]> {
    let ring = PowerSeries::rational(terms);
    let third = third_of_fundamental_series(terms)?;
    let amplitude = ring.add(&ring.variable()?, &third);
    let inverse = powers_of_inverse(&Rationals, &amplitude)?;
    let (fundamental, third) = (inverse.first(), inverse.composed(&Rationals, &third));
    let squared = inserted(&ring, &square_of_frequency()?, |name| match name {
        "a1" => Some(fundamental.clone()),
        "a3" => Some(third.clone()),
        _ => None,
    })?;
    let frequency = ring.power(&squared, &Rational::new(1, 2)?)?;
    Some([fundamental, third, frequency])
}

fn third_of_fundamental(printed: &Printed) -> Option<StatementFinding> {
    const TERMS: usize = 8;
    let stands = series_in("a1", TERMS, printed.formula(0)?, &[])?;
    let truncated = third_of_fundamental_series(TERMS)?;
    let mut finding = against_series(&stands, &truncated, 3, "a1", "(22) and (23) solved for a3")?;
    finding.evidence += &format!("; the whole sine gives {}", written(&whole_third()?, "a1"));
    Some(finding)
}

/// The exact a3 for a1 = ε, up to the seventh power.
fn whole_third() -> Option<Vec<Rational>> {
    let mut gauge = vec![Rational::from(0); 7];
    *gauge.first_mut()? = Rational::from(1);
    numbers(&Expansion::of_numbers(&gauge)?.harmonic(3))
}

fn third_of_amplitude(printed: &Printed) -> Option<StatementFinding> {
    let right_angle = at_degrees(90.0)?;
    let approximate = decimal(printed.formula(0)?, &[("theta0", right_angle.radians())])?;
    let exact = *harmonics(&right_angle)?.get(1)?;
    let mut finding = in_amplitude(printed, 1, 3)?;
    finding.evidence += &format!(
        "; at 90 degrees {approximate:.6} against the exact {exact:.6}, {:.0} % low",
        100.0 * (1.0 - approximate / exact)
    );
    Some(finding)
}

fn fundamental_of_amplitude(printed: &Printed) -> Option<StatementFinding> {
    in_amplitude(printed, 0, 3)
}

fn frequency_of_amplitude(printed: &Printed) -> Option<StatementFinding> {
    in_amplitude(printed, 2, 2)
}

/// One of a1, a3, Δ compared with the solution of (22) to (24) as a series in the amplitude.
fn in_amplitude(printed: &Printed, which: usize, through: usize) -> Option<StatementFinding> {
    const TERMS: usize = 6;
    let stands = series_in("theta0", TERMS, printed.formula(0)?, &[])?;
    let computed = solution_in_amplitude(TERMS)?;
    let finding = against_series(
        &stands,
        computed.get(which)?,
        through,
        "theta0",
        "(22) to (24) solved in powers of theta0",
    )?;
    Some(finding)
}
