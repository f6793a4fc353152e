//! Statements of the text on Fig. 1: the best formula in each range.

use super::text_after;
use crate::paper::amplitudes::in_degrees;
use crate::paper::compare::{decimal, first_difference};
use crate::paper::errors::{
    PLOTTED, better_on, crossings, error, error_at, exact_at, in_words, intervals_in_words, leaders,
    ratio_at, ratio_of_leading_errors,
};
use crate::paper::finding::StatementFinding;
use crate::paper::period_series::ratio_series;
use crate::paper::printed::Printed;
use crate::paper::statement::PrintedStatement;
use libration::algebra::Rational;
use libration::period_formulas::period_in_amplitude;
use std::f64::consts::PI;

pub(super) const STATEMENTS: &[PrintedStatement] = &[
    text_after(
        "Fig. 1",
        "text: the 3-term formula is the most accurate for 0 <= theta0 <= pi/2",
        "The best of Fig. 1 on the lower half of the amplitudes.",
        &["theta0 = pi/2"],
        best_on_the_lower_half,
    )
    .paraphrased(),
    text_after(
        "Fig. 1",
        "text: the 1-term formula is more accurate than the 2- and 3-term ones for pi/2 < theta0 <= pi",
        "On the upper half of the amplitudes one term beats two and three.",
        &["theta0 = pi/2"],
        one_term_on_the_upper_half,
    )
    .paraphrased(),
    text_after(
        "Fig. 1",
        "text: the error of the 1-term formula decreases noticeably for pi/2 < theta0 <= pi",
        "The dip of its curve.",
        &["theta0 = pi/2"],
        dip_of_one_term,
    )
    .paraphrased(),
    text_after(
        "Fig. 1",
        "text: some interplay between the elliptic integral and the 1-term formula",
        "Left unexplored there: why one term does so well.",
        &["T = T0/(1 - theta0^2/16)"],
        interplay,
    )
    .paraphrased(),
    text_after(
        "Fig. 1",
        "text: (implicit) the 1/T form is worth its while against the power series (14)",
        "With as many corrections the series of 1/T is more accurate than that of T.",
        &["corrections = 3"],
        against_the_power_series,
    )
    .paraphrased(),
    text_after(
        "Fig. 1",
        "text: the approximations are on a par with the formulas of the introduction",
        "The largest errors up to 90 degrees.",
        &["theta0 = pi/2"],
        on_a_par,
    )
    .paraphrased(),
];

/// The amplitude stated in the claim.
pub(super) fn amplitude(printed: &Printed) -> Option<f64> {
    decimal(printed.formula(0)?, &[])
}

pub(super) fn below(limit: f64) -> String {
    format!("for theta0 below {}", in_degrees(limit))
}

fn best_on_the_lower_half(printed: &Printed) -> Option<StatementFinding> {
    let upper = amplitude(printed)?;
    let leaders = leaders(&PLOTTED)?;
    let (first, until) = leaders.first()?.clone();
    let holds = first == "black_vel_3" && until >= upper;
    let beaten = ["carvalhaes_suppes", "belendez"].map(|key| better_on(key, "black_vel_3"));
    let beaten = beaten.into_iter().collect::<Option<Vec<_>>>()?;
    let evidence = format!(
        "of Fig. 1 the best is {}; (52) beats the 3-term formula on {}, (53) on {}: both are left out of the comparison",
        in_words(&leaders),
        intervals_in_words(&beaten[0]),
        intervals_in_words(&beaten[1])
    );
    let correct = format!("it is the most accurate {}", below(until));
    Some(StatementFinding::verified_if(holds, correct, evidence).holding_for(vec![(0.0, until)]))
}

fn one_term_on_the_upper_half(printed: &Printed) -> Option<StatementFinding> {
    let lower = amplitude(printed)?;
    let from = |other: &str| Some(crossings("denman", other)?.last()?.amplitude.radians());
    let (two, three) = (from("black_vel_2")?, from("black_vel_3")?);
    let above_both = two.max(three);
    let evidence = format!(
        "1 term beats 2 terms above {} and 3 terms above {}, from there on up to 180 degrees; at 100 degrees the errors \
         of 1, 2, 3 terms are {:.2e}, {:.2e}, {:.2e}",
        in_degrees(two),
        in_degrees(three),
        error_at("denman", 100.0)?,
        error_at("black_vel_2", 100.0)?,
        error_at("black_vel_3", 100.0)?
    );
    let correct = format!("true for theta0 above {}", in_degrees(above_both));
    let finding = StatementFinding::verified_if(above_both <= lower, correct, evidence);
    let finding = if above_both <= lower {
        finding
    } else {
        finding.restricted(format!("below {}, true above", in_degrees(above_both)))
    };
    Some(finding.holding_for(vec![(above_both, PI)]))
}

fn dip_of_one_term(printed: &Printed) -> Option<StatementFinding> {
    let lower = amplitude(printed)?;
    let zeros = exact_at("denman")?;
    let within = zeros.iter().any(|zero| *zero > lower);
    let shown = [120.0, 150.0, 170.0, 179.0]
        .map(|degrees| Some(format!("{:.1e} at {degrees} degrees", error_at("denman", degrees)?)));
    let evidence = format!(
        "its error changes its sign at {}; it is {}",
        zeros.iter().map(|zero| in_degrees(*zero)).collect::<Vec<_>>().join(", "),
        shown.into_iter().collect::<Option<Vec<_>>>()?.join(", ")
    );
    Some(StatementFinding::verified_if(within, "", evidence))
}

/// The [0/1] Padé approximant of the series of T in θ0² is 1/(1 − t₁θ0²).
fn interplay(printed: &Printed) -> Option<StatementFinding> {
    let stands = ratio_series(printed.formula(0)?, 8)?;
    let slope = period_in_amplitude(1).pop()?;
    let mut geometric = vec![Rational::from(0); 8];
    let mut power = Rational::from(1);
    for coefficient in geometric.iter_mut().step_by(2) {
        *coefficient = power.clone();
        power = power * slope.clone();
    }
    let is_pade = first_difference(&stands, &geometric).is_none();
    let pole = 1.0 / slope.to_f64().sqrt();
    let zero = *exact_at("denman")?.first()?;
    let evidence = format!(
        "it is the [0/1] Pade approximant in theta0^2 of the series (14), exactly to theta0^7; its pole at {pole} rad stands \
         for the divergence of the exact period at pi, and its error, positive below and negative above, vanishes at {} \
         ({zero:.14} rad)",
        in_degrees(zero)
    );
    Some(StatementFinding::verified_if(is_pade, "", evidence))
}

fn against_the_power_series(printed: &Printed) -> Option<StatementFinding> {
    let corrections = printed.number(0)?;
    let (ours, theirs) = (format!("black_vel_{corrections}"), format!("power_series_{corrections}"));
    let always = better_on(&ours, &theirs)?;
    let [two, three] = ["power_series_2", "power_series_3"]
        .map(|key| Some(in_degrees(crossings("denman", key)?.last()?.amplitude.radians())));
    let limit = ratio_of_leading_errors(&theirs, &ours)?;
    let evidence = format!(
        "{ours} beats {theirs} on {}; the ratio of the errors is {:.2} as theta0 -> 0 and {:.2} at 90 degrees; one term beats \
         (14) with 2 corrections above {}, with 3 above {}",
        intervals_in_words(&always),
        limit.to_f64().abs(),
        ratio_at(&theirs, &ours, 90.0)?,
        two?,
        three?
    );
    let right = always.first().is_some_and(|&(from, to)| from <= 0.0 && to >= PI) && always.len() == 1;
    Some(StatementFinding::verified_if(right, "", evidence).holding_for(always))
}

fn on_a_par(printed: &Printed) -> Option<StatementFinding> {
    let upper = amplitude(printed)?;
    let worst = |key: &str| Some(error(key, upper)?.abs());
    let shown = PLOTTED.map(|key| Some(format!("{key} {:.2e}", worst(key)?)));
    let evidence =
        format!("at {}: {}", in_degrees(upper), shown.into_iter().collect::<Option<Vec<_>>>()?.join(", "));
    let published = ["bernoulli", "molina", "kidd_fogg"].map(worst);
    let best = published.into_iter().collect::<Option<Vec<_>>>()?.into_iter().fold(f64::INFINITY, f64::min);
    Some(StatementFinding::verified_if(worst("denman")? <= best, "", evidence))
}
