//! Black and Vel: the quantitative claims of the text about the formulas, with the amplitudes on which they hold.

use super::compare::{ROUNDING, decimal, first_difference, series_in};
use super::errors::{
    PLOTTED, better_on, crossings, error_at, exact_at, holds_on, in_words, intervals_in_words, leaders,
    ratio_at, ratio_reached,
};
use super::finding::Finding;
use super::printed::Printed;
use super::roots::in_degrees;
use super::statement::{Document, Statement};
use crate::algebra::Rational;
use crate::period_formulas::period_in_amplitude;
use std::f64::consts::{FRAC_PI_2, PI};

const fn statement(
    label: &'static str,
    claim: &'static str,
    printed: &'static [&'static str],
    check: super::statement::Check,
) -> Statement {
    Statement { document: Document::BlackVel, label, claim, printed, check }
}

pub(super) const STATEMENTS: &[Statement] = &[
    statement(
        "text: the 3-term formula is the most accurate for 0 <= theta0 <= pi/2",
        "The best of Fig. 1 on the lower half of the amplitudes.",
        &["theta0 = pi/2"],
        best_on_the_lower_half,
    ),
    statement(
        "text: the 1-term formula is more accurate than the 2- and 3-term ones for pi/2 < theta0 <= pi",
        "On the upper half of the amplitudes one term beats two and three.",
        &["theta0 = pi/2"],
        one_term_on_the_upper_half,
    ),
    statement(
        "text: the error of the 1-term formula decreases noticeably for pi/2 < theta0 <= pi",
        "The dip of its curve.",
        &["theta0 = pi/2"],
        dip_of_one_term,
    ),
    statement(
        "text: some interplay between the elliptic integral and the 1-term formula",
        "Left unexplored there: why one term does so well.",
        &["T = T0/(1 - theta0^2/16)"],
        interplay,
    ),
    statement(
        "text: (52) is about one order of magnitude more accurate than the 3-term formula",
        "The ratio of the errors is about this.",
        &["ratio = 10"],
        carvalhaes_suppes,
    ),
    statement(
        "text: (53) is two orders of magnitude more accurate",
        "The ratio of the errors is this or more; than which formula is not said.",
        &["ratio = 100"],
        belendez,
    ),
    statement(
        "text: (6) is best for theta0 <= pi/2",
        "Kidd and Fogg's formula is meant for amplitudes up to this.",
        &["theta0 = pi/2"],
        kidd_fogg,
    ),
    statement(
        "text: for a measurement error of 1 part in 1000 the 1-term formula suffices",
        "Its error stays below this in an undergraduate laboratory, on 0 <= theta0 <= pi/2.",
        &["error = 1/1000"],
        undergraduate,
    ),
    statement(
        "text: (7) is for initial displacements around 180 degrees",
        "Butikov's formula is good at the top.",
        &["error = 1/1000"],
        butikov,
    ),
    statement(
        "text: the 1/T form is worth its while against the power series (14)",
        "With as many corrections the series of 1/T is more accurate than that of T.",
        &["corrections = 3"],
        against_the_power_series,
    ),
    statement(
        "text: the approximations are on a par with the formulas of the introduction",
        "The largest errors up to 90 degrees.",
        &["theta0 = pi/2"],
        on_a_par,
    ),
];

/// The amplitude that the claim names.
fn amplitude(printed: &Printed) -> Option<f64> {
    decimal(printed.formula(0)?, &[])
}

fn below(limit: f64) -> String {
    format!("for theta0 below {}", in_degrees(limit))
}

fn best_on_the_lower_half(printed: &Printed) -> Option<Finding> {
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
    Some(Finding::verified_if(holds, correct, evidence).holding_for(vec![(0.0, until)]))
}

fn one_term_on_the_upper_half(printed: &Printed) -> Option<Finding> {
    let lower = amplitude(printed)?;
    let from = |other: &str| Some(crossings("black_vel_1", other)?.last()?.amplitude.radians());
    let (two, three) = (from("black_vel_2")?, from("black_vel_3")?);
    let above_both = two.max(three);
    let evidence = format!(
        "1 term beats 2 terms above {} and 3 terms above {}, from there on up to 180 degrees; at 100 degrees the errors \
         of 1, 2, 3 terms are {:.2e}, {:.2e}, {:.2e}",
        in_degrees(two),
        in_degrees(three),
        error_at("black_vel_1", 100.0)?,
        error_at("black_vel_2", 100.0)?,
        error_at("black_vel_3", 100.0)?
    );
    let correct = format!("true for theta0 above {}", in_degrees(above_both));
    let finding = Finding::verified_if(above_both <= lower, correct, evidence);
    let finding = if above_both <= lower {
        finding
    } else {
        finding.restricted(format!("below {}, true above", in_degrees(above_both)))
    };
    Some(finding.holding_for(vec![(above_both, PI)]))
}

fn dip_of_one_term(printed: &Printed) -> Option<Finding> {
    let lower = amplitude(printed)?;
    let zeros = exact_at("black_vel_1")?;
    let within = zeros.iter().any(|zero| *zero > lower);
    let shown = [120.0, 150.0, 170.0, 179.0]
        .map(|degrees| Some(format!("{:.1e} at {degrees} degrees", error_at("black_vel_1", degrees)?)));
    let evidence = format!(
        "its error changes its sign at {}; it is {}",
        zeros.iter().map(|zero| in_degrees(*zero)).collect::<Vec<_>>().join(", "),
        shown.into_iter().collect::<Option<Vec<_>>>()?.join(", ")
    );
    Some(Finding::verified_if(within, "", evidence))
}

/// The [0/1] Padé approximant of the series of T in θ0² is 1/(1 − t₁θ0²).
fn interplay(printed: &Printed) -> Option<Finding> {
    let stands = series_in("theta0", 8, printed.formula(0)?, &[("T0", 1)])?;
    let slope = period_in_amplitude(1).pop()?;
    let mut geometric = vec![Rational::from(0); 8];
    let mut power = Rational::from(1);
    for place in geometric.iter_mut().step_by(2) {
        *place = power.clone();
        power = power * slope.clone();
    }
    let is_pade = first_difference(&stands, &geometric).is_none();
    let pole = 1.0 / slope.to_f64().sqrt();
    let zero = *exact_at("black_vel_1")?.first()?;
    let evidence = format!(
        "it is the [0/1] Pade approximant in theta0^2 of the series (14), exactly to theta0^7; its pole at {pole} rad stands \
         for the divergence of the exact period at pi, and its error, positive below and negative above, vanishes at {} \
         ({zero:.14} rad)",
        in_degrees(zero)
    );
    Some(Finding::verified_if(is_pade, "", evidence))
}

fn ratios(a: &str, b: &str) -> Option<String> {
    let at = [1.0, 30.0, 60.0, 90.0, 120.0, 150.0, 179.0]
        .map(|degrees| Some(format!("{:.4} at {degrees}", ratio_at(a, b, degrees)?)));
    Some(format!("{} degrees", at.into_iter().collect::<Option<Vec<_>>>()?.join(", ")))
}

fn carvalhaes_suppes(printed: &Printed) -> Option<Finding> {
    let claimed = decimal(printed.formula(0)?, &[])?;
    // About: within half an order.
    let half_an_order = 10.0_f64.sqrt();
    let ratio = |degrees: f64| ratio_at("black_vel_3", "carvalhaes_suppes", degrees);
    let near = |ratio: f64| ratio * half_an_order >= claimed && ratio <= claimed * half_an_order;
    let about =
        [0.01, 45.0, 90.0].into_iter().map(|degrees| ratio(degrees).map(near)).collect::<Option<Vec<_>>>()?;
    let until = ratio_reached("black_vel_3", "carvalhaes_suppes", claimed / half_an_order)?;
    let until = until.last().copied().unwrap_or(PI);
    let limit = PeriodRatioOfLeadingErrors::of("black_vel_3", "carvalhaes_suppes")?;
    let evidence = format!(
        "the ratio of the errors is {limit} = {:.4} as theta0 -> 0 (exactly), {}; it reaches 10 nowhere and falls to half \
         an order at {}",
        limit.to_f64(),
        ratios("black_vel_3", "carvalhaes_suppes")?,
        in_degrees(until)
    );
    let right = about.iter().all(|about| *about);
    Some(
        Finding::verified_if(right, format!("the ratio is {:.4} and less", limit.to_f64()), evidence)
            .holding_for(vec![(0.0, until)]),
    )
}

/// The quotient of exact leading errors of the same power.
struct PeriodRatioOfLeadingErrors;

impl PeriodRatioOfLeadingErrors {
    fn of(a: &str, b: &str) -> Option<Rational> {
        let leading =
            |key: &str| crate::period_formulas::PeriodFormula::by_key(key).ok()?.leading_error().cloned();
        let (a, b) = (leading(a)?, leading(b)?);
        (a.power == b.power).then(|| a.coefficient.checked_div(&b.coefficient)).flatten()
    }
}

fn belendez(printed: &Printed) -> Option<Finding> {
    let claimed = decimal(printed.formula(0)?, &[])?;
    let until = |other: &str, factor: f64| {
        Some(ratio_reached(other, "belendez", factor)?.first().copied().unwrap_or(PI))
    };
    let (three_term, second) = (until("black_vel_3", claimed)?, until("carvalhaes_suppes", claimed)?);
    let evidence = format!(
        "against the 3-term formula the ratio is {}; it is {claimed} at {}. Against (52), the formula named last, it is {}; \
         it is {claimed} at {} and 10 at {}",
        ratios("black_vel_3", "belendez")?,
        in_degrees(three_term),
        ratios("carvalhaes_suppes", "belendez")?,
        in_degrees(second),
        in_degrees(until("carvalhaes_suppes", 10.0)?)
    );
    let correct = format!(
        "at least {claimed} times as accurate as the 3-term formula {}, as (52) {}",
        below(three_term),
        below(second)
    );
    let right = three_term.min(second) >= FRAC_PI_2;
    let finding = Finding::verified_if(right, correct, evidence);
    let finding = if right {
        finding
    } else {
        finding.restricted(format!("above {}, true below", in_degrees(three_term)))
    };
    Some(finding.holding_for(vec![(0.0, three_term)]))
}

fn kidd_fogg(printed: &Printed) -> Option<Finding> {
    let upper = amplitude(printed)?;
    let tolerance = holds_on("kidd_fogg", 1e-3)?.first()?.1;
    let always_beaten = better_on("molina", "kidd_fogg")?;
    let others = ["black_vel_1", "black_vel_2", "black_vel_3"].map(|key| better_on(key, "kidd_fogg"));
    let others = others.into_iter().collect::<Option<Vec<_>>>()?;
    let at_limit = super::errors::error("kidd_fogg", upper)?;
    let bernoulli = crossings("kidd_fogg", "bernoulli")?;
    let evidence = format!(
        "its error grows to {at_limit:.2e} there and is below 1e-3 up to {}; as a comparison with others it would be false: \
         Molina's formula is better on {}, 1, 2 and 3 terms on {}, {} and {}; Bernoulli's above {}",
        in_degrees(tolerance),
        intervals_in_words(&always_beaten),
        intervals_in_words(&others[0]),
        intervals_in_words(&others[1]),
        intervals_in_words(&others[2]),
        bernoulli.last().map_or("none".to_owned(), |crossing| in_degrees(crossing.amplitude.radians()))
    );
    let finding = Finding::verified_if(at_limit.abs() < 0.01, "", evidence);
    let within = holds_on("kidd_fogg", 0.01)?;
    Some(finding.restricted("as the range where it is good to 1 %").holding_for(within))
}

fn undergraduate(printed: &Printed) -> Option<Finding> {
    let tolerance = decimal(printed.formula(0)?, &[])?;
    let intervals = holds_on("black_vel_1", tolerance)?;
    let until = intervals.first()?.1;
    let others = [
        "small_angle",
        "bernoulli",
        "kidd_fogg",
        "molina",
        "black_vel_2",
        "black_vel_3",
        "carvalhaes_suppes",
        "belendez",
    ]
    .map(|key| Some(format!("{key} {:.10}", holds_on(key, tolerance)?.first()?.1.to_degrees())));
    let evidence = format!(
        "its error is below {tolerance} on {}; at 90 degrees it is {:.2e}; others keep it up to (degrees): {}",
        intervals_in_words(&intervals),
        error_at("black_vel_1", 90.0)?,
        others.into_iter().collect::<Option<Vec<_>>>()?.join(", ")
    );
    let right = until >= FRAC_PI_2;
    let finding = Finding::verified_if(right, format!("it suffices {}", below(until)), evidence);
    let finding =
        if right { finding } else { finding.restricted(format!("above {}, true below", in_degrees(until))) };
    Some(finding.holding_for(intervals))
}

fn butikov(printed: &Printed) -> Option<Finding> {
    let tolerance = decimal(printed.formula(0)?, &[])?;
    let intervals = holds_on("butikov", tolerance)?;
    let percent = holds_on("butikov", 0.01)?;
    let (_, reached) = *intervals.last()?;
    let leads = leaders(&PLOTTED)?;
    let overtakes = |other: &str| Some(in_degrees(crossings("butikov", other)?.last()?.amplitude.radians()));
    let evidence = format!(
        "its error is below {tolerance} on {}, below 1 % on {}; it beats the 1-term formula above {}, (52) above {}, (53) above \
         {}; the best of Fig. 1 is {}",
        intervals_in_words(&intervals),
        intervals_in_words(&percent),
        overtakes("black_vel_1")?,
        overtakes("carvalhaes_suppes")?,
        overtakes("belendez")?,
        in_words(&leads)
    );
    let right = (reached - PI).abs() < ROUNDING && leads.last()?.0 == "butikov";
    Some(Finding::verified_if(right, "", evidence).holding_for(intervals))
}

fn against_the_power_series(printed: &Printed) -> Option<Finding> {
    let corrections = printed.number(0)?;
    let (ours, theirs) = (format!("black_vel_{corrections}"), format!("power_series_{corrections}"));
    let always = better_on(&ours, &theirs)?;
    let [two, three] = ["power_series_2", "power_series_3"]
        .map(|key| Some(in_degrees(crossings("black_vel_1", key)?.last()?.amplitude.radians())));
    let limit = PeriodRatioOfLeadingErrors::of(&theirs, &ours)?;
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
    Some(Finding::verified_if(right, "", evidence).holding_for(always))
}

fn on_a_par(printed: &Printed) -> Option<Finding> {
    let upper = amplitude(printed)?;
    let worst = |key: &str| Some(super::errors::error(key, upper)?.abs());
    let shown = PLOTTED.map(|key| Some(format!("{key} {:.2e}", worst(key)?)));
    let evidence =
        format!("at {}: {}", in_degrees(upper), shown.into_iter().collect::<Option<Vec<_>>>()?.join(", "));
    let published = ["bernoulli", "molina", "kidd_fogg"].map(worst);
    let best = published.into_iter().collect::<Option<Vec<_>>>()?.into_iter().fold(f64::INFINITY, f64::min);
    Some(Finding::verified_if(worst("black_vel_1")? <= best, "", evidence))
}
