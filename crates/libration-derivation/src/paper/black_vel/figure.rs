//! Fig. 1, (52) and (53): a comparison of formulas, and two better ones.

use super::statement;
use crate::paper::amplitudes::in_degrees;
use crate::paper::compare::{decimal, series_in};
use crate::paper::errors::{PLOTTED, error, exact_at, in_words, leaders};
use crate::paper::finding::{StatementFinding, StatementVerdict};
use crate::paper::period_series::{agreement, ratio_series};
use crate::paper::printed::Printed;
use crate::paper::statement::PrintedStatement;
use libration::algebra::{Rational, Ring};
use libration::expression::{Expression, Symbol};
use libration::period_formulas::PeriodFormula;
use libration::series::PowerSeries;

pub(super) const STATEMENTS: &[PrintedStatement] = &[
    statement(
        "Fig. 1",
        "The fractional errors of the corrections with one, two and three terms and of the formulas (4) to (7) and \
         (14) between 0 and 180 degrees.",
        &[],
        figure,
    ),
    statement(
        "(52)",
        "Carvalhaes and Suppes's period, from the arithmetic-geometric mean.",
        &["T = 4*T0/(1 + sqrt(cos(theta0/2)))^2"],
        second_mean,
    ),
    statement(
        "(53)",
        "Belendez and others' period; r is what stands under each root in the copy of the text that was read, where a line may be lost.",
        &["T = 64*T0/(16*(1 + sqrt(r))^2 - (1 - sqrt(r))^4)", "r = 1 + cos(theta0/2)"],
        belendez,
    ),
];

/// Every curve compared with its exact leading term, and the best formula in each range.
fn figure(_: &Printed) -> Option<StatementFinding> {
    const SMALL: f64 = 0.01;
    let mut farthest = 0.0_f64;
    for key in PLOTTED {
        let formula = PeriodFormula::by_key(key).ok()?;
        if let Some(leading) = formula.leading_error() {
            let term = leading.coefficient.to_f64() * libm::pow(SMALL, f64::from(leading.power));
            farthest = farthest.max((error(key, SMALL)? / term - 1.0).abs());
        }
    }
    let zeros = exact_at("denman")?.into_iter().map(in_degrees).collect::<Vec<_>>().join(", ");
    let evidence = format!(
        "recomputed: at 0.01 rad the errors are their exact leading terms to {farthest:.1e}; the curve of the 1-term \
         formula dips to 0 at {zeros}; the best of the plotted ones is {}",
        in_words(&leaders(&PLOTTED)?)
    );
    Some(StatementFinding::verified_if(farthest < 1e-3, "", evidence))
}

/// 1/a₂ of the mean of 1 and cos(θ0/2), as a series.
fn second_mean_series(terms: usize) -> Option<Vec<Rational>> {
    let ring = PowerSeries::rational(terms);
    let cosine = Printed::read(&["cos(theta0/2)"])?;
    let one = ring.rational(&Rational::from(1))?;
    let (mut a, mut b) = (one.clone(), series_in("theta0", terms, cosine.formula(0)?, &[])?);
    for _ in 0..2 {
        let mean = ring.over_integer(&ring.add(&a, &b), 2)?;
        b = ring.power(&ring.multiply(&a, &b), &Rational::new(1, 2)?)?;
        a = mean;
    }
    ring.divide(&one, &a)
}

fn second_mean(printed: &Printed) -> Option<StatementFinding> {
    const TERMS: usize = 14;
    let stands = ratio_series(printed.formula(0)?, TERMS)?;
    let same = stands == second_mean_series(TERMS)?;
    let agreement = agreement(printed.formula(0)?, 2)?;
    let evidence = format!(
        "equals T0/a2 of the mean from 1 and cos(theta0/2){}; {}",
        if same { " to theta0^13, exactly" } else { ": it does not" },
        agreement.evidence
    );
    Some(StatementFinding::verified_if(same, "T = T0/a2 = 4*T0/(1 + sqrt(cos(theta0/2)))^2", evidence))
}

/// The possible interpretations of the radicands.
const READINGS: [&str; 5] = [
    "1 + cos(theta0/2)",
    "1 + cos(theta0)/2",
    "(1 + cos(theta0))/2",
    "(1 + cos(theta0/2))/2",
    "cos(theta0/2)",
];

fn belendez(printed: &Printed) -> Option<StatementFinding> {
    let formula = printed.formula(0)?;
    let inserted = |under: &Expression| formula.substitute(&Symbol::plain("r"), under);
    let stands = inserted(printed.formula(1)?);
    if let Some(finding) =
        agreement(&stands, 2).filter(|finding| finding.verdict == StatementVerdict::Verified)
    {
        return Some(finding);
    }
    let mut tried = Vec::new();
    let mut meant = None;
    for reading in READINGS {
        let under = Printed::read(&[reading])?;
        let whole = inserted(under.formula(0)?);
        let at_rest = decimal(&whole, &[("theta0", 0.0), ("T0", 1.0)])?;
        let slope = ratio_series(&whole, 4).and_then(|series| series.get(2).cloned());
        tried.push(match slope {
            Some(slope) => format!("r = {reading}: T/T0 = 1 + {slope}*theta0^2 + ..."),
            None => format!("r = {reading}: T(0)/T0 = {at_rest:.5}"),
        });
        let agrees = agreement(&whole, 2).filter(|finding| finding.verdict == StatementVerdict::Verified);
        meant = meant.or_else(|| agrees.map(|finding| (reading, finding.evidence)));
    }
    let at_rest = decimal(&stands, &[("theta0", 0.0), ("T0", 1.0)])?;
    let evidence =
        format!("as it stands T(0)/T0 = {at_rest:.5}, which must be 1; readings tried: {}", tried.join("; "));
    Some(match meant {
        Some((reading, agreement)) => StatementFinding::typo(
            format!("r = {reading}"),
            format!("{evidence}; with r = {reading}: {agreement}"),
        ),
        None => StatementFinding::wrong("", evidence),
    })
}
