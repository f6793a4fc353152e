//! (35) to (37): the series of the period, and the statements about it in the text.

use super::terms::{complete_integral, constant, in_half_pi, partial_sum, times_half_pi};
use super::{statement, text_after};
use crate::paper::amplitudes::at_degrees;
use crate::paper::compare::{decimal, polynomial};
use crate::paper::exact_motion::{GRAVITY, LENGTH};
use crate::paper::finding::StatementFinding;
use crate::paper::period_series::agreement;
use crate::paper::printed::Printed;
use crate::paper::statement::PrintedStatement;
use libration::algebra::{Polynomial, Rational};
use libration::elliptic::Modulus;
use libration::expression::Expression;
use libration::pendulum::{Amplitude, Pendulum};
use libration::period_formulas::{PeriodFormula, period_in_sine_squared};
use libration::quantity::Angle;
use std::f64::consts::{FRAC_PI_2, PI};

pub(super) const STATEMENTS: &[PrintedStatement] = &[
    statement(
        "(35)",
        "K(m) as the sum of this from the given n on.",
        &["n = 1", "pi/2*(odd/even)^2*m^n"],
        sum_of_squares,
    ),
    statement(
        "(36)",
        "Its first terms.",
        &["pi/2*(1 + (1/2)^2*m + (1*3/(2*4))^2*m^2 + (1*3*5/(2*4*6))^2*m^3)"],
        first_terms,
    ),
    statement(
        "(37)",
        "The series of the period.",
        &["T = T0*(1 + sin(theta0/2)^2/4 + 9*sin(theta0/2)^4/64 + 25*sin(theta0/2)^6/256)"],
        period,
    ),
    text_after(
        "(37)",
        "text: the expression holds for any starting angle",
        "The amplitudes for which the series converges, up to this.",
        &["theta0 = pi"],
        any_starting_angle,
    )
    .paraphrased(),
    text_after(
        "(37)",
        "text: at small angles the period becomes 2*pi*sqrt(l/g)",
        "The limit of (37).",
        &["T = 2*pi*sqrt(l/g)"],
        small_angle,
    ),
    text_after(
        "(37)",
        "text: the larger the angle, the more terms are important",
        "The terms that a relative error of this takes.",
        &["error = 1/1000000"],
        terms_needed,
    )
    .paraphrased(),
    text_after(
        "(37)",
        "text: a physical pendulum requires the centre of mass",
        "What the period of a rod of length L needs: the point mass at half its length has this period.",
        &["T = 2*pi*sqrt(L/(2*g))"],
        physical_pendulum,
    )
    .paraphrased(),
];

/// A sum that should equal K(m).
pub(super) fn sum_for_the_integral(printed: &Printed, remark: &str) -> Option<StatementFinding> {
    let missing = complete_integral()? - partial_sum(printed)?;
    let at_half = {
        let value = partial_sum(printed)?.value(|_| Rational::new(1, 2))?;
        format!(
            "at m = 1/2 K = {:.6}, the sum to n = 8 is {:.6}",
            Modulus::from_parameter(0.5).ok()?.first(),
            value.to_f64() * FRAC_PI_2
        )
    };
    let lacking = times_half_pi(&missing);
    let evidence = format!("K(m) less the sum is {lacking}, exactly to m^8; {at_half}{remark}");
    Some(StatementFinding::verified_if(missing.is_zero(), "sum from n = 0", evidence))
}

fn sum_of_squares(printed: &Printed) -> Option<StatementFinding> {
    let remark = "; its two sides, begun alike, agree with each other but not with K(m), and (36), called its expansion, has \
                  the term of n = 0 again";
    sum_for_the_integral(printed, remark)
}

fn first_terms(printed: &Printed) -> Option<StatementFinding> {
    let stands = polynomial_in_half_pi(printed.formula(0)?)?;
    let exact = complete_integral()?;
    let m = "m".into();
    let kept = (0..=3)
        .fold(Polynomial::zero(), |sum, n| sum + exact.coefficient(&m, n) * Polynomial::variable("m").pow(n));
    let next = exact.coefficient(&m, 4);
    let evidence =
        format!("2*K(m)/pi from the squares of the central binomials, exactly: {kept} + {next}*m^4 + ...");
    Some(StatementFinding::verified_if(stands == kept, format!("pi/2*({kept})"), evidence))
}

fn polynomial_in_half_pi(formula: &Expression) -> Option<Polynomial> {
    polynomial(&in_half_pi(formula), &[("halfpi", constant(1))])
}

fn period(printed: &Printed) -> Option<StatementFinding> {
    let finding = agreement(printed.formula(0)?, 6)?;
    let next = period_in_sine_squared(5);
    let evidence = format!(
        "{}; the next terms are {}*sin(theta0/2)^8 and {}*sin(theta0/2)^10",
        finding.evidence, next[4], next[5]
    );
    Some(StatementFinding { evidence, ..finding })
}

fn any_starting_angle(printed: &Printed) -> Option<StatementFinding> {
    let limit = decimal(printed.formula(0)?, &[])?;
    let partial = |count: usize| -> f64 { period_in_sine_squared(count).iter().map(Rational::to_f64).sum() };
    let short_of = |degrees: f64| {
        let formula = PeriodFormula::by_key("sin2_series_40").ok()?;
        Some(formula.fractional_error(&at_degrees(degrees)?))
    };
    let evidence = format!(
        "every coefficient is positive and tends to 1/(pi*n), so it converges for sin(theta0/2)^2 < 1 alone: at 180 degrees the \
         sums to n = 10, 100 and 1000 are {:.3}, {:.3} and {:.3}, without limit, as the period; with 40 corrections the error is \
         {:.1e} at 90 degrees, {:.1e} at 150 degrees and {:.1e} at 179 degrees",
        partial(10),
        partial(100),
        partial(1000),
        short_of(90.0)?,
        short_of(150.0)?,
        short_of(179.0)?
    );
    let right = limit <= PI;
    let finding = StatementFinding::verified_if(right, "theta0 < pi", evidence)
        .with_correct("for every theta0 < 180 degrees");
    Some(finding.restricted("for theta0 < pi").holding_for(vec![(0.0, PI)]))
}

fn small_angle(printed: &Printed) -> Option<StatementFinding> {
    let series = period_in_sine_squared(1);
    let stands = decimal(printed.formula(0)?, &[("l", LENGTH), ("g", GRAVITY)])?;
    let limit =
        Pendulum::new(LENGTH, GRAVITY).ok()?.period(&Amplitude::new(Angle::from_radians(1e-9).ok()?).ok()?);
    let deviation = (stands / limit - 1.0).abs();
    let evidence = format!(
        "T/T0 = {} + {}*sin(theta0/2)^2 + ..., exactly; the exact period from 1e-9 rad differs from the limit by {deviation:.1e}",
        series[0], series[1]
    );
    Some(StatementFinding::verified_if(deviation < 1e-14, "", evidence))
}

fn terms_needed(printed: &Printed) -> Option<StatementFinding> {
    let tolerance = decimal(printed.formula(0)?, &[])?;
    let needed = |stem: &str, degrees: f64| {
        let angle = at_degrees(degrees)?;
        (1..200_usize).find(|n| {
            PeriodFormula::by_key(&format!("{stem}{n}"))
                .is_ok_and(|formula| formula.fractional_error(&angle).abs() < tolerance)
        })
    };
    let mut counts = Vec::new();
    let mut shown = Vec::new();
    for degrees in [30.0, 60.0, 90.0, 120.0] {
        let (sine, amplitude) = (needed("sin2_series_", degrees)?, needed("power_series_", degrees)?);
        shown.push(format!("{sine} at {degrees} degrees (the series in theta0: {amplitude})"));
        counts.push(sine);
    }
    let evidence = format!("corrections for a relative error of {tolerance}: {}", shown.join(", "));
    Some(StatementFinding::verified_if(counts.is_sorted() && counts.first() < counts.last(), "", evidence))
}

/// A uniform rod about its end: I = mL²/3, centre of mass at L/2.
fn physical_pendulum(printed: &Printed) -> Option<StatementFinding> {
    let (length, gravity) = (1.0, 9.81);
    let stands = decimal(printed.formula(0)?, &[("L", length), ("g", gravity)])?;
    let inertia_over_moment = (length * length / 3.0) / (length / 2.0);
    let rod = Pendulum::new(inertia_over_moment, gravity).ok()?;
    let exact = rod.small_angle_period();
    let degrees = at_degrees(60.0)?;
    let ratio = rod.period(&Amplitude::new(degrees).ok()?) / exact;
    let evidence = format!(
        "a uniform rod of 1 m about its end swings as a point mass at I/(m*d) = 2/3 m: T0 = {exact:.6} s, while a point mass at \
         its centre of mass gives {stands:.6} s, {:.1} % less; the law of the amplitude is the same (T/T0 = {ratio:.6} at 60 degrees)",
        100.0 * (1.0 - stands / exact)
    );
    let correct = "also the moment of inertia I about the pivot: omega0^2 = m*g*d/I, d from the pivot to the centre of mass";
    let right = (stands / exact - 1.0).abs() < 1e-12;
    let finding = StatementFinding::verified_if(right, correct, evidence);
    Some(if right { finding } else { finding.restricted("by omission") })
}
