//! (26) to (34): the integrals of the powers of the sine by recursion.

use super::terms::{at_index, complete_integral, mean_of_power, partial_sum, term, times_half_pi};
use super::{statement, text_after};
use crate::paper::compare::{decimal, identity, series_in};
use crate::paper::finding::{StatementFinding, StatementVerdict};
use crate::paper::printed::Printed;
use crate::paper::quadrature::quarter;
use crate::paper::statement::PrintedStatement;
use libration::algebra::Rational;
use libration::expression::Expression;
use std::f64::consts::FRAC_PI_2;

pub(super) const STATEMENTS: &[PrintedStatement] = &[
    statement("(26)", "The integral of sin(psi)^(2n) from 0 to pi/2.", &["I = odd/even*pi/2"], wallis),
    text_after(
        "(26)",
        "text: our lowest value of n will be one",
        "Where the sum begins, and with it the recursion.",
        &["n = 1", "odd/even*m^n*I"],
        lowest_index,
    )
    .paraphrased(),
    statement("(27)", "The integral at n = 1.", &["I = pi/4"], first_integral),
    statement(
        "(28)",
        "One sine is split off.",
        &["sin(psi)^(2*n) = sin(psi)^(2*n - 1)*sin(psi)"],
        split_sine,
    ),
    statement(
        "(29)",
        "By parts: the first, between 0 and pi/2, and the integral of the second.",
        &["-cos(psi)*sin(psi)^(2*n - 1)", "(2*n - 1)*cos(psi)^2*sin(psi)^(2*n - 2)"],
        by_parts,
    ),
    text_after(
        "(28)",
        "text: u = sin(psi)^(2n-1) and dv = sin(psi)",
        "The two parts of the integration.",
        &["dv = sin(psi)"],
        parts,
    ),
    statement(
        "(30)",
        "The cosine by sines: the integral of this.",
        &["(2*n - 1)*(sin(psi)^(2*(n - 1)) - sin(psi)^(2*n))"],
        by_sines,
    ),
    statement(
        "(31)",
        "The same in the integrals (I1 is that of n - 1).",
        &["I = (2*n - 1)*(I1 - I)"],
        recursion,
    ),
    statement("(32)", "Solved: the recursion.", &["I = (2*n - 1)/(2*n)*I1"], recursion),
    statement(
        "(33)",
        "Applied three times.",
        &["I = (2*n - 1)/(2*n)*I1 = (2*n - 1)/(2*n)*(2*(n - 1) - 1)/(2*(n - 1))*I2 = \
             (2*n - 1)/(2*n)*(2*(n - 1) - 1)/(2*(n - 1))*(2*(n - 2) - 1)/(2*(n - 2))*I3"],
        recursion,
    ),
    statement(
        "(34)",
        "The closed form, written (2n-1)!!/2n!!; nn is n!!, to which the sign belongs.",
        &["I = odd/(2*nn)*pi/2"],
        closed_form,
    ),
];

fn wallis(printed: &Printed) -> Option<StatementFinding> {
    let exact = (0..12).map(|n| Some(term(printed.formula(0)?, n)?.to_constant() == mean_of_power(n)));
    let right = exact.collect::<Option<Vec<_>>>()?.into_iter().all(|same| same);
    let quadrature = quarter(&|psi| Some(libm::pow(libm::sin(psi), 6.0)))?;
    let evidence = format!(
        "equals binomial(2n, n)/4^n*pi/2, the constant term of sin^(2n) in cosines, for n = 0 to 11, exactly ((-1)!! = 1); \
         at n = 3 quadrature gives {quadrature:.12}, it is {:.12}",
        mean_of_power(3)?.to_f64() * FRAC_PI_2
    );
    Some(StatementFinding::verified_if(right, "", evidence))
}

fn lowest_index(printed: &Printed) -> Option<StatementFinding> {
    let missing = complete_integral()? - partial_sum(printed)?;
    let evidence = format!(
        "begun there the sum lacks {}, the term I(0); n = 0 is the natural seed of the recursion: I(1) = \
         (1/2)*I(0) = pi/4 follows",
        times_half_pi(&missing)
    );
    Some(StatementFinding::verified_if(missing.is_zero(), "the lowest n is 0, with I(0) = pi/2", evidence))
}

fn first_integral(printed: &Printed) -> Option<StatementFinding> {
    let stands = term(printed.formula(0)?, 1)?.to_constant()?;
    let computed = mean_of_power(1)?;
    let quadrature = quarter(&|psi| Some(libm::sin(psi) * libm::sin(psi)))?;
    let evidence =
        format!("the mean of sin^2 is {computed}, exactly, times pi/2; quadrature {quadrature:.12}");
    Some(StatementFinding::verified_if(stands == computed, format!("I = {computed}*pi/2"), evidence))
}

fn split_sine(printed: &Printed) -> Option<StatementFinding> {
    let mut last = None;
    for n in 1..5 {
        let finding =
            identity(&at_index(&printed.residual(0)?, n), &[("psi", 0.0, FRAC_PI_2)], "for n = 1 to 4")?;
        if finding.verdict != StatementVerdict::Verified {
            return Some(finding);
        }
        last = Some(finding);
    }
    last
}

/// The boundary term must vanish at both ends, and its derivative plus the integrand must be sin²ⁿψ.
fn by_parts(printed: &Printed) -> Option<StatementFinding> {
    let power = Printed::read(&["sin(psi)^(2*n)"])?;
    let mut right = true;
    let mut at_ends = 0.0_f64;
    for n in 1..5 {
        let series = |formula: &Expression| series_in("psi", 14, &at_index(formula, n), &[]);
        let boundary = series(printed.formula(0)?)?;
        let slope = (1..).map(Rational::from).zip(boundary.iter().skip(1)).map(|(n, c)| c.clone() * n);
        let (integrand, whole) = (series(printed.formula(1)?)?, series(power.formula(0)?)?);
        right &= slope.zip(&integrand).zip(&whole).all(|((a, b), sum)| a + b.clone() == *sum);
        for psi in [0.0, FRAC_PI_2] {
            at_ends = at_ends.max(decimal(&at_index(printed.formula(0)?, n), &[("psi", psi)])?.abs());
        }
    }
    let evidence = format!(
        "for n = 1 to 4 the derivative of the first and the second sum to sin(psi)^(2n) to psi^12, exactly; the first is at most \
         {at_ends:.1e} at 0 and pi/2"
    );
    Some(StatementFinding::verified_if(right && at_ends < 1e-15, "", evidence))
}

/// With the document's v = −cos ψ, dv is sin ψ·dψ.
fn parts(printed: &Printed) -> Option<StatementFinding> {
    let stands = series_in("psi", 12, printed.formula(0)?, &[("dpsi", 1)])?;
    let part = Printed::read(&["-cos(psi)"])?;
    let part = series_in("psi", 13, part.formula(0)?, &[])?;
    let slope = (1..).map(Rational::from).zip(part.iter().skip(1)).map(|(n, c)| c.clone() * n);
    let right = slope.eq(stands);
    let scales = series_in("psi", 12, printed.formula(0)?, &[("dpsi", 2)])?
        != series_in("psi", 12, printed.formula(0)?, &[("dpsi", 1)])?;
    let evidence = "the derivative of v = -cos(psi), which (29) uses, is sin(psi), exactly to psi^11; its differential has d(psi)";
    Some(match (right, scales) {
        (true, true) => StatementFinding::verified(evidence),
        (true, false) => StatementFinding::typo("dv = sin(psi)*d(psi)", evidence),
        _ => StatementFinding::wrong("dv = sin(psi)*d(psi)", evidence),
    })
}

fn by_sines(printed: &Printed) -> Option<StatementFinding> {
    let mut largest = 0.0_f64;
    for n in 1..8 {
        let integral = quarter(&|psi| decimal(&at_index(printed.formula(0)?, n), &[("psi", psi)]))?;
        largest = largest.max((integral - mean_of_power(n)?.to_f64() * FRAC_PI_2).abs());
    }
    let evidence = format!(
        "its quadrature is I(n) within {largest:.1e} for n = 1 to 7; as displayed the parentheses about the difference are missing"
    );
    Some(StatementFinding::verified_if(largest < 1e-13, "", evidence))
}

fn recursion(printed: &Printed) -> Option<StatementFinding> {
    let sides = printed.sides(0)?;
    let from = i64::try_from(sides.len()).ok()? - 1;
    let mut right = true;
    for n in from..12 {
        let exact = mean_of_power(n)?;
        for side in sides {
            right &= term(side, n)?.to_constant() == Some(exact.clone());
        }
    }
    let evidence = format!("exact for n = {from} to 11 with I(n) = binomial(2n, n)/4^n*pi/2");
    Some(StatementFinding::verified_if(right, "I(n) = (2n-1)/(2n)*I(n-1)", evidence))
}

fn closed_form(printed: &Printed) -> Option<StatementFinding> {
    let right = |formula: &Expression| {
        let same = (1..12).map(|n| Some(term(formula, n)?.to_constant() == mean_of_power(n)));
        same.collect::<Option<Vec<_>>>().map(|same| same.into_iter().all(|same| same))
    };
    if right(printed.formula(0)?)? {
        return Some(StatementFinding::verified("exact for n = 1 to 11"));
    }
    let meant = Printed::read(&["odd/even*pi/2"])?;
    let evidence = format!(
        "at n = 2 it gives {}*pi/2 instead of {}*pi/2; with (2n)!! below it is exact for n = 1 to 11",
        term(printed.formula(0)?, 2)?.to_constant()?,
        mean_of_power(2)?
    );
    let correct = "I(n) = (2n-1)!!/(2n)!!*pi/2";
    Some(if right(meant.formula(0)?)? {
        StatementFinding::typo(correct, evidence)
    } else {
        StatementFinding::wrong(correct, evidence)
    })
}
