//! (39) to (45) and (47): the amplitude as a series in ε, and ε as a series in the amplitude by iteration.

use super::gauges::gauge_of;
use super::statement;
use crate::paper::compare::{against_series, first_difference, inserted, polynomial, series_in, written};
use crate::paper::evaluate::value;
use crate::paper::finding::StatementFinding;
use crate::paper::lindstedt::{Expansion, numbers};
use crate::paper::orders::in_epsilon;
use crate::paper::printed::Printed;
use crate::paper::statement::PrintedStatement;
use libration::algebra::{Polynomial, Rational, Rationals, Ring};
use libration::series::PowerSeries;
use libration::series::powers_of_inverse;

pub(super) const STATEMENTS: &[PrintedStatement] = &[
    statement(
        "(39)",
        "The amplitude in this gauge.",
        &["theta0 = epsilon - epsilon^3/192 - epsilon^5/5120"],
        amplitude_in_the_gauge,
    ),
    statement("(40)", "The amplitude is epsilon less a function F.", &["theta0 = epsilon - F"], split_off),
    statement("(41)", "This function.", &["F = z^3/192 + z^5/5120"], what_is_split_off),
    statement("(42)", "Solved for the epsilon that stands alone.", &["epsilon = theta0 + F"], turned_round),
    statement(
        "(43)",
        "The first approximation: F taken at theta0.",
        &["epsilon = theta0 + theta0^3/192 + theta0^5/5120"],
        first_iteration,
    ),
    statement(
        "(44)",
        "The second: F taken at the first.",
        &["epsilon = theta0 + F1^3/192 + F1^5/5120", "F1 = theta0 + theta0^3/192 + theta0^5/5120"],
        second_iteration,
    ),
    statement(
        "(45)",
        "Epsilon in the amplitude, in the gauge A1 = 1, A3 = A5 = 0.",
        &["A1 = 1", "A3 = A5 = 0", "epsilon = theta0 + theta0^3/192 + 17*theta0^5/61440"],
        parameter_in_amplitude,
    ),
    statement(
        "(47)",
        "Epsilon in the amplitude in this gauge.",
        &["A1 = -A3 = 1", "A5 = 0", "epsilon = theta0 + 193*theta0^3/192 + 185297*theta0^5/61440"],
        parameter_in_amplitude,
    ),
];

/// θ0 in ε for A1 = 1 and all other constants zero, up to an order.
pub(super) fn amplitude_of_fundamental(order: usize) -> Option<Vec<Rational>> {
    let mut gauge = vec![Rational::from(0); order];
    *gauge.first_mut()? = Rational::from(1);
    numbers(&Expansion::of_numbers(&gauge)?.amplitude())
}

fn amplitude_in_the_gauge(printed: &Printed) -> Option<StatementFinding> {
    let stands = series_in("epsilon", 6, printed.formula(0)?, &[])?;
    against_series(
        &stands,
        &amplitude_of_fundamental(5)?,
        5,
        "epsilon",
        "the sum of the harmonics at Omega*t = 0",
    )
}

/// F = ε − θ0(ε).
fn split(order: usize) -> Option<Polynomial> {
    let amplitude: Vec<Polynomial> =
        amplitude_of_fundamental(order)?.into_iter().map(Polynomial::constant).collect();
    Some(Polynomial::variable("epsilon") - in_epsilon(&amplitude))
}

fn split_off(printed: &Printed) -> Option<StatementFinding> {
    let stands = polynomial(printed.formula(0)?, &[("F", split(5)?)])?;
    let right = stands == Polynomial::variable("epsilon") - split(5)?;
    Some(StatementFinding::verified_if(
        right,
        "",
        format!("definition; F = {}, from the computed amplitude", split(5)?),
    ))
}

fn what_is_split_off(printed: &Printed) -> Option<StatementFinding> {
    let stands = polynomial(printed.formula(0)?, &[("z", Polynomial::variable("epsilon"))])?;
    let computed = split(5)?;
    let evidence = format!("epsilon less the computed amplitude, exactly: {computed}");
    Some(StatementFinding::verified_if(stands == computed, format!("F(epsilon) = {computed}"), evidence))
}

fn turned_round(printed: &Printed) -> Option<StatementFinding> {
    let theta0 = Polynomial::variable("epsilon") - split(5)?;
    let stands = polynomial(printed.formula(0)?, &[("F", split(5)?), ("theta0", theta0)])?;
    let right = stands == Polynomial::variable("epsilon");
    Some(StatementFinding::verified_if(
        right,
        "",
        "with F(epsilon) and theta0(epsilon) as computed both sides are epsilon, exactly",
    ))
}

/// The inverse of y = x + ….
pub(super) fn inverse(series: &[Rational]) -> Option<Vec<Rational>> {
    powers_of_inverse(&Rationals, series).map(|powers| powers.first())
}

/// θ0 + F(x) with the computed F, up to θ0⁷.
fn improved(x: &[Rational]) -> Option<Vec<Rational>> {
    let ring = PowerSeries::rational(x.len());
    let excess = inserted(&ring, &split(5)?, |name| (name == "epsilon").then(|| x.to_vec()))?;
    Some(ring.add(&ring.variable()?, &excess))
}

fn first_iteration(printed: &Printed) -> Option<StatementFinding> {
    let ring = PowerSeries::rational(8);
    let stands = series_in("theta0", ring.terms, printed.formula(0)?, &[])?;
    iteration(&stands, &improved(&ring.variable()?)?, 3)
}

fn second_iteration(printed: &Printed) -> Option<StatementFinding> {
    let ring = PowerSeries::rational(8);
    let first = series_in("theta0", ring.terms, printed.formula(1)?, &[])?;
    let stands = value(&ring, printed.formula(0)?, &|name| match name {
        "theta0" => ring.variable(),
        "F1" => Some(first.clone()),
        _ => None,
    })?;
    iteration(&stands, &improved(&improved(&ring.variable()?)?)?, 5)
}

/// A step of the iteration as printed and as computed, and the order up to which it agrees with the inverse of (39).
fn iteration(stands: &[Rational], computed: &[Rational], through: usize) -> Option<StatementFinding> {
    let mut amplitude = amplitude_of_fundamental(5)?;
    amplitude.resize(stands.len(), Rational::from(0));
    let exact = inverse(&amplitude)?;
    let (power, _) = first_difference(computed, &exact)?;
    let evidence = format!(
        "it is theta0 + F(...) as (39) gives F; against the exact inverse of (39) it is right below theta0^{power}, where it \
         has {} instead of {}",
        computed[power], exact[power]
    );
    let right = power > through && stands == computed;
    let finding = StatementFinding::verified_if(right, written(&exact[..=through], "theta0"), evidence);
    Some(finding.restricted(format!("to theta0^{through}")))
}

/// ε in θ0, in the gauge that is stated first.
pub(super) fn parameter_in_amplitude_to(printed: &Printed, order: u32) -> Option<StatementFinding> {
    let assignments: Vec<(String, Rational)> = printed.gauge();
    let expansion = Expansion::of_numbers(&gauge_of(&assignments, order))?;
    let exact = inverse(&numbers(&expansion.amplitude())?)?;
    let stands = series_in("theta0", exact.len(), printed.last()?, &[])?;
    against_series(
        &stands,
        &exact,
        usize::try_from(order).ok()?,
        "theta0",
        "the amplitude in this gauge reverted",
    )
}

fn parameter_in_amplitude(printed: &Printed) -> Option<StatementFinding> {
    parameter_in_amplitude_to(printed, 5)
}
