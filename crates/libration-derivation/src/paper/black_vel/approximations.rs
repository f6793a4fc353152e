//! (4) to (7) and (14): the formulas of the introduction, compared with the exact period.

use super::{statement, text_after};
use crate::paper::compare::{ROUNDING, decimal, series_in};
use crate::paper::finding::StatementFinding;
use crate::paper::period_series::{agreement, exact_series, ratio_series};
use crate::paper::printed::Printed;
use crate::paper::statement::PrintedStatement;
use libration::algebra::{Rational, Ring};
use libration::pendulum::period_ratio_near_top;
use libration::series::PowerSeries;
use std::f64::consts::PI;

pub(super) const STATEMENTS: &[PrintedStatement] = &[
    statement(
        "(4)",
        "Bernoulli's period, exact to theta0^2.",
        &["T = T0*(1 + theta0^2/16)"],
        agrees_to_second,
    ),
    text_after(
        "(4)",
        "text: sin(theta) replaced by F(theta0)*theta with F = (sin(theta0)/theta0)^a",
        "Matching the first correction of the period fixes the exponent a, and (5) follows.",
        &["F = (sin(theta0)/theta0)^(3/4)", "T = T0*(theta0/sin(theta0))^(3/8)"],
        exponent_of_molina,
    )
    .paraphrased(),
    statement(
        "(5)",
        "Molina's period, whose first correction is that of the exact one.",
        &["T = T0*(theta0/sin(theta0))^(3/8)"],
        agrees_to_second,
    ),
    statement("(6)", "Kidd and Fogg's period.", &["T = T0/sqrt(cos(theta0/2))"], agrees_to_second),
    statement(
        "(7)",
        "Butikov's period, for amplitudes near 180 degrees.",
        &["T = (2*T0/pi)*ln(8/(pi - theta0))"],
        asymptotic_at_the_top,
    ),
    statement(
        "(14)",
        "The power series of the period.",
        &["T = T0*(1 + theta0^2/16 + 11*theta0^4/3072 + 173*theta0^6/737280)"],
        agrees_to_sixth,
    ),
];

fn agrees_to_second(printed: &Printed) -> Option<StatementFinding> {
    agreement(printed.formula(0)?, 2)
}

fn agrees_to_sixth(printed: &Printed) -> Option<StatementFinding> {
    agreement(printed.formula(0)?, 6)
}

/// T = T0/√F: the exponent p of θ0/sin θ0 in the period must make p·(1/6) the exact 1/16.
fn exponent_of_molina(printed: &Printed) -> Option<StatementFinding> {
    let force = series_in("theta0", 8, printed.formula(0)?, &[])?;
    let from_force = PowerSeries::rational(8).power(&force, &Rational::new(-1, 2)?)?;
    let period = ratio_series(printed.formula(1)?, 8)?;
    let one_power = Printed::read(&["theta0/sin(theta0)"])?;
    let slope = series_in("theta0", 8, one_power.formula(0)?, &[])?.get(2)?.clone();
    let exponent = exact_series(4).get(2)?.checked_div(&slope)?;
    let twice = exponent.clone() + exponent.clone();
    let follows = from_force.iter().zip(&period).all(|(a, b)| a == b);
    let matches = period.get(2) == exact_series(4).get(2);
    let correct = format!("a = {twice}, T = T0*(theta0/sin(theta0))^({exponent})");
    let evidence = format!(
        "theta0/sin(theta0) = 1 + {slope}*theta0^2 + ..., so the exact 1/16 needs the power (1/16)/({slope}) = \
         {exponent} in the period and a = {twice} in F; 1/sqrt(F) and (5) agree to theta0^{}",
        from_force.len() - 1
    );
    Some(StatementFinding::verified_if(follows && matches, correct, evidence))
}

/// formula/exact − 1 over δ², which must tend to −(1/16 − 1/(48·ln(8/δ))), from the next term of K.
fn asymptotic_at_the_top(printed: &Printed) -> Option<StatementFinding> {
    let complements = [1e-1, 1e-2, 1e-3];
    let mut shown = Vec::new();
    let mut vanishes = true;
    for complement in complements {
        let theta0 = PI - complement;
        // The part that the rounded subtraction π − θ0 lost.
        let complement = PI - theta0;
        let formula = decimal(printed.formula(0)?, &[("T0", 2.0), ("theta0", theta0)])? / 2.0;
        let error = formula / period_ratio_near_top(complement) - 1.0;
        let square = complement * complement;
        let expected = -(1.0 / 16.0 - 1.0 / (48.0 * libm::log(8.0 / complement))) * square;
        vanishes &= (error - expected).abs() < square * square + ROUNDING;
        shown.push(format!("{error:.3e} at {complement:.0e} rad below pi"));
    }
    let evidence = format!(
        "the error vanishes as -delta^2*(1/16 - 1/(48*ln(8/delta))), delta = pi - theta0: {}; at small amplitudes \
         it is {:.1} %",
        shown.join(", "),
        100.0 * (decimal(printed.formula(0)?, &[("T0", 2.0), ("theta0", 0.0)])? / 2.0 - 1.0)
    );
    Some(StatementFinding::verified_if(vanishes, "", evidence).restricted("near theta0 = pi"))
}
