//! Statements of the text on the accuracy of single formulas.

use super::regimes::{amplitude, below};
use super::text_after;
use crate::paper::amplitudes::in_degrees;
use crate::paper::compare::{ROUNDING, decimal};
use crate::paper::errors::{
    PLOTTED, better_on, crossings, error, error_at, holds_on, in_words, intervals_in_words, leaders,
    ratio_at, ratio_of_leading_errors, ratio_reached,
};
use crate::paper::finding::StatementFinding;
use crate::paper::printed::Printed;
use crate::paper::statement::PrintedStatement;
use std::f64::consts::{FRAC_PI_2, PI};

pub(super) const STATEMENTS: &[PrintedStatement] = &[
    text_after(
        "(52)",
        "text: (52) is about one order of magnitude more accurate than the 3-term formula",
        "The ratio of the errors is about this.",
        &["ratio = 10"],
        carvalhaes_suppes,
    )
    .paraphrased(),
    text_after(
        "(53)",
        "text: (53) is two orders of magnitude more accurate",
        "The ratio of the errors is this or more; than which formula is not said.",
        &["ratio = 100"],
        belendez,
    )
    .paraphrased(),
    text_after(
        "(6)",
        "text: (6) is best for theta0 <= pi/2",
        "Kidd and Fogg's formula is meant for amplitudes up to this.",
        &["theta0 = pi/2"],
        kidd_fogg,
    )
    .paraphrased(),
    text_after(
        "(53)",
        "text: for a measurement error of 1 part in 1000 the 1-term formula suffices",
        "Its error stays below this in an undergraduate laboratory, on 0 <= theta0 <= pi/2.",
        &["error = 1/1000"],
        undergraduate,
    )
    .paraphrased(),
    text_after(
        "(7)",
        "text: (7) is for initial displacements around 180 degrees",
        "Butikov's formula is good at the top.",
        &["error = 1/1000"],
        butikov,
    )
    .paraphrased(),
];

fn ratios(a: &str, b: &str) -> Option<String> {
    let at = [1.0, 30.0, 60.0, 90.0, 120.0, 150.0, 179.0]
        .map(|degrees| Some(format!("{:.4} at {degrees}", ratio_at(a, b, degrees)?)));
    Some(format!("{} degrees", at.into_iter().collect::<Option<Vec<_>>>()?.join(", ")))
}

fn carvalhaes_suppes(printed: &Printed) -> Option<StatementFinding> {
    let claimed = decimal(printed.formula(0)?, &[])?;
    // "About" is interpreted as within half an order of magnitude.
    let half_an_order = 10.0_f64.sqrt();
    let ratio = |degrees: f64| ratio_at("black_vel_3", "carvalhaes_suppes", degrees);
    let near = |ratio: f64| ratio * half_an_order >= claimed && ratio <= claimed * half_an_order;
    let about =
        [0.01, 45.0, 90.0].into_iter().map(|degrees| ratio(degrees).map(near)).collect::<Option<Vec<_>>>()?;
    let until = ratio_reached("black_vel_3", "carvalhaes_suppes", claimed / half_an_order)?;
    let until = until.last().copied().unwrap_or(PI);
    let limit = ratio_of_leading_errors("black_vel_3", "carvalhaes_suppes")?;
    let evidence = format!(
        "the ratio of the errors is {limit} = {:.4} as theta0 -> 0 (exactly), {}; it reaches 10 nowhere and falls to half \
         an order at {}",
        limit.to_f64(),
        ratios("black_vel_3", "carvalhaes_suppes")?,
        in_degrees(until)
    );
    let right = about.iter().all(|about| *about);
    Some(
        StatementFinding::verified_if(
            right,
            format!("the ratio is {:.4} and less", limit.to_f64()),
            evidence,
        )
        .holding_for(vec![(0.0, until)]),
    )
}

fn belendez(printed: &Printed) -> Option<StatementFinding> {
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
    let finding = StatementFinding::verified_if(right, correct, evidence);
    let finding = if right {
        finding
    } else {
        finding.restricted(format!("above {}, true below", in_degrees(three_term)))
    };
    Some(finding.holding_for(vec![(0.0, three_term)]))
}

fn kidd_fogg(printed: &Printed) -> Option<StatementFinding> {
    let upper = amplitude(printed)?;
    let tolerance = holds_on("kidd_fogg", 1e-3)?.first()?.1;
    let always_beaten = better_on("molina", "kidd_fogg")?;
    let others = ["denman", "black_vel_2", "black_vel_3"].map(|key| better_on(key, "kidd_fogg"));
    let others = others.into_iter().collect::<Option<Vec<_>>>()?;
    let at_limit = error("kidd_fogg", upper)?;
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
    let finding = StatementFinding::verified_if(at_limit.abs() < 0.01, "", evidence);
    let within = holds_on("kidd_fogg", 0.01)?;
    Some(finding.restricted("as the range where it is good to 1 %").holding_for(within))
}

fn undergraduate(printed: &Printed) -> Option<StatementFinding> {
    let tolerance = decimal(printed.formula(0)?, &[])?;
    let intervals = holds_on("denman", tolerance)?;
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
        error_at("denman", 90.0)?,
        others.into_iter().collect::<Option<Vec<_>>>()?.join(", ")
    );
    let right = until >= FRAC_PI_2;
    let finding = StatementFinding::verified_if(right, format!("it suffices {}", below(until)), evidence);
    let finding =
        if right { finding } else { finding.restricted(format!("above {}, true below", in_degrees(until))) };
    Some(finding.holding_for(intervals))
}

fn butikov(printed: &Printed) -> Option<StatementFinding> {
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
        overtakes("denman")?,
        overtakes("carvalhaes_suppes")?,
        overtakes("belendez")?,
        in_words(&leads)
    );
    let right = (reached - PI).abs() < ROUNDING && leads.last()?.0 == "butikov";
    Some(StatementFinding::verified_if(right, "", evidence).holding_for(intervals))
}
