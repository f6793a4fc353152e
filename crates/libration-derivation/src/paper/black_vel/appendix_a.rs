//! (A1) to (A3): why the frequency contains only even powers of ε.

use super::{statement, text_after};
use crate::paper::compare::{polynomial, same_polynomial};
use crate::paper::cosines::{cosine, cosines, projection};
use crate::paper::finding::StatementFinding;
use crate::paper::lindstedt::Expansion;
use crate::paper::orders::{Clock, form, orders_of};
use crate::paper::printed::Printed;
use crate::paper::statement::PrintedStatement;
use libration::algebra::{Polynomial, Rational};

pub(super) const STATEMENTS: &[PrintedStatement] = &[
    statement(
        "(A1)",
        "Two harmonics in odd powers of epsilon.",
        &["theta = (epsilon*A1 + epsilon^3*A3)*c1 + (epsilon*B1 + epsilon^3*B3)*c3"],
        two_harmonics,
    ),
    statement(
        "(A2)",
        "The frequency in all powers of epsilon.",
        &["Omega = omega0*(1 + epsilon*d1 + epsilon^2*d2)"],
        frequency_with_odd_powers,
    ),
    statement(
        "(A3)",
        "What stands at epsilon^2, on cos(Omega*t): d1 must vanish.",
        &["-2*A1*d1*c1"],
        first_correction,
    ),
    text_after(
        "(A3)",
        "text: d_n = 0 for every odd n",
        "Appendix A: the frequency has even powers of epsilon alone.",
        &["d3 = 0"],
        odd_corrections,
    )
    .paraphrased(),
];

pub(super) fn number(value: i64) -> Polynomial {
    Polynomial::constant(Rational::from(value))
}

fn two_harmonics(printed: &Printed) -> Option<StatementFinding> {
    let expansion = Expansion::odd_gauge(3)?;
    form(printed.formula(0)?, &cosines(), expansion.motion(), &expansion)
}

fn frequency_with_odd_powers(printed: &Printed) -> Option<StatementFinding> {
    let expansion = Expansion::every_gauge(3)?;
    form(printed.formula(0)?, &[("omega0", number(1))], &expansion.frequency()?, &expansion)
}

/// (8) with (A1) and (A2) at ε².
fn first_correction(printed: &Printed) -> Option<StatementFinding> {
    let motion = |k: u32, letter: &str, order: u32| {
        Polynomial::variable(format!("{letter}{order}").as_str()) * cosine(k)
    };
    let theta = [Polynomial::zero(), motion(1, "A", 1) + motion(3, "B", 1), Polynomial::zero()];
    let frequency = [number(1), Polynomial::variable("d1"), Polynomial::variable("d2")];
    let equation = Printed::read(&["theta'' + theta - theta^3/6"])?;
    let at_second = orders_of(equation.formula(0)?, &theta, &frequency, Clock::Time)?.get(2)?.clone();
    let computed = projection(&at_second, 1);
    let stands = projection(&polynomial(printed.formula(0)?, &cosines())?, 1);
    let how = format!(
        "(A1) and (A2) in (8) leave {at_second} at epsilon^2 (c is cos(Omega*t)), on cos(Omega*t) {computed}, so d1 = 0"
    );
    Some(same_polynomial(&stands, &computed, &how))
}

fn odd_corrections(printed: &Printed) -> Option<StatementFinding> {
    let claimed = printed.number(0)?;
    let (every, odd) = (Expansion::every_gauge(5)?, Expansion::odd_gauge(6)?);
    let corrections = ["d1", "d3", "d5"].map(|name| odd.named(name));
    let corrections = corrections.into_iter().collect::<Option<Vec<_>>>()?;
    let odd_vanish = corrections.iter().all(|d| d.to_constant() == Some(claimed.clone()));
    let evidence = format!(
        "with A2 = A4 = 0 it holds to d5, exactly; with every An open d1 = {}, d3 = {}, and B4 = {}: an A2 is the \
         change epsilon -> epsilon + (A2/A1)*epsilon^2 of the parameter, not of the motion",
        every.named("d1")?,
        every.named("d3")?,
        every.named("B4")?
    );
    let correct = "odd d_n can be removed by the gauge A2 = A4 = ... = 0, because theta0 -> -theta0 is the shift \
                   Omega*t -> Omega*t + pi; in other gauges they do not vanish";
    let finding = StatementFinding::verified_if(odd_vanish, correct, evidence).with_correct(correct);
    Some(finding.restricted("in gauges with A2 = A4 = ... = 0"))
}
