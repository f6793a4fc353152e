//! The period of a formula as an exact power series in the amplitude, compared with the exact series.

use crate::paper::compare::{first_difference, series_in};
use crate::paper::finding::StatementFinding;
use libration::algebra::Rational;
use libration::expression::Expression;
use libration::period_formulas::{frequency_in_amplitude, period_in_amplitude};

/// The ratio T/T0 of a formula for T as a series in the amplitude, with T0 = 2.
pub(super) fn ratio_series(formula: &Expression, terms: usize) -> Option<Vec<Rational>> {
    let period = series_in("theta0", terms, formula, &[("T0", 2)])?;
    Some(period.iter().map(|coefficient| coefficient.divided_by_power_of_two(1)).collect())
}

/// T/T0 as a series in the amplitude, compared with the exact one.
pub(super) fn agreement(formula: &Expression, through: usize) -> Option<StatementFinding> {
    const TERMS: usize = 16;
    let printed = ratio_series(formula, TERMS)?;
    let exact = exact_series(TERMS);
    let Some((power, difference)) = first_difference(&printed, &exact) else {
        return Some(StatementFinding::verified(format!(
            "equals the exact series to theta0^{}",
            printed.len() - 1
        )));
    };
    let term = |n: usize| format!("{}*theta0^{n}", exact[n]);
    let evidence = format!(
        "expanded exactly it agrees with the series of the period below theta0^{power}; its error begins with \
         {difference}*theta0^{power}"
    );
    Some(StatementFinding::verified_if(power > through, format!("the term is {}", term(power)), evidence))
}

/// T/T0 = 1 + 0·θ0 + θ0²/16 + ….
pub(super) fn exact_series(terms: usize) -> Vec<Rational> {
    let even = period_in_amplitude(terms / 2).into_iter();
    even.flat_map(|coefficient| [coefficient, Rational::from(0)]).take(terms).collect()
}

/// T0/T = 1 + 0·θ0 − θ0²/16 + ….
pub(super) fn frequency_series(terms: usize) -> Vec<Rational> {
    let even = frequency_in_amplitude(terms / 2).into_iter();
    even.flat_map(|coefficient| [coefficient, Rational::from(0)]).take(terms).collect()
}
