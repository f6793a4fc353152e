//! Statements of the text on the sizes of the coefficients, at every amplitude.

use super::text_after;
use crate::paper::amplitudes::{amplitude_where_zero, at_degrees, in_degrees};
use crate::paper::compare::decimal;
use crate::paper::exact_motion::{frequency_ratio, harmonics};
use crate::paper::finding::StatementFinding;
use crate::paper::printed::Printed;
use crate::paper::statement::PrintedStatement;
use libration::quantity::Angle;
use std::f64::consts::PI;

pub(super) const STATEMENTS: &[PrintedStatement] = &[
    text_after(
        "(27)",
        "text: a1 is at most a bit greater than pi",
        "An upper bound of a1 over all amplitudes up to pi.",
        &["a1 = pi"],
        largest_fundamental,
    )
    .paraphrased(),
    text_after(
        "(24)",
        "text: a1 is not much greater than 1",
        "An upper bound of a1 over all amplitudes; much greater is taken as twice.",
        &["a1 = 2"],
        fundamental_beside_one,
    )
    .paraphrased(),
    text_after(
        "(24)",
        "text: a3 is much smaller than 1 for 0 < theta0 <= pi",
        "A bound of |a3| over all amplitudes; much smaller is taken as a tenth.",
        &["a3 = 1/10"],
        largest_third,
    )
    .paraphrased(),
    text_after(
        "(27)",
        "text: a1*a3 stays much less than 1, so a1^3 is much greater than a1^4*a3",
        "A bound of |a1*a3| over all amplitudes; already 1 is too much.",
        &["a1*a3 = 1"],
        product_of_both,
    )
    .paraphrased(),
    text_after(
        "(24)",
        "text: a1 >> Delta - 1 >> a3",
        "The corrections decrease: |a3| is much smaller than |Delta - 1|, taken as a fifth of it.",
        &["a3/(Delta - 1) = 1/5"],
        order_of_corrections,
    )
    .paraphrased(),
];

/// The amplitude closest to the top that the library accepts.
fn top() -> Option<Angle> {
    Angle::from_complement(1e-300).ok()
}

/// a1, a3, a5 next to the top, where they tend to 4, −4/3, 4/5.
fn limits() -> Option<[f64; 3]> {
    harmonics(&top()?)?.get(..3)?.try_into().ok()
}

fn largest_fundamental(printed: &Printed) -> Option<StatementFinding> {
    let bound = decimal(printed.formula(0)?, &[])?;
    let [a1, a3, a5] = limits()?;
    let passed = amplitude_where_zero(0.1, PI - 1e-9, &|amplitude| Some(harmonics(amplitude)?[0] - bound));
    let evidence = format!(
        "the coefficients tend to 4*(-1)^n/(2n+1): at 1e-300 rad below pi they are {a1:.5}, {a3:.5}, {a5:.5}; a1 \
         passes {bound:.4} at {}",
        passed.map_or("no amplitude".to_owned(), in_degrees)
    );
    let correct = "a1 < 4, which it tends to as theta0 -> pi";
    // "A bit" is interpreted as a tenth.
    Some(StatementFinding::verified_if(a1 <= 1.1 * bound, correct, evidence))
}

fn fundamental_beside_one(printed: &Printed) -> Option<StatementFinding> {
    let bound = decimal(printed.formula(0)?, &[])?;
    let [a1, ..] = limits()?;
    let reached = |bound: f64| {
        amplitude_where_zero(0.1, PI - 1e-9, &|amplitude| Some(harmonics(amplitude)?[0] - bound))
    };
    let limit = reached(bound);
    let evidence = format!(
        "a1 passes 1 at {} and {bound} at {}; it tends to 4: {a1:.5} at 1e-300 rad below pi",
        reached(1.0).map_or("no amplitude".to_owned(), in_degrees),
        limit.map_or("no amplitude".to_owned(), in_degrees)
    );
    let correct = "a1 < 4, which it tends to as theta0 -> pi";
    let finding = StatementFinding::verified_if(a1 <= bound, correct, evidence);
    Some(finding.holding_for(vec![(0.0, limit.unwrap_or(PI))]))
}

fn largest_third(printed: &Printed) -> Option<StatementFinding> {
    let bound = decimal(printed.formula(0)?, &[])?;
    let [_, a3, _] = limits()?;
    let reached = |bound: f64| {
        amplitude_where_zero(0.1, PI - 1e-9, &|amplitude| Some(harmonics(amplitude)?[1].abs() - bound))
    };
    let limit = reached(bound);
    let evidence = format!(
        "|a3| reaches {bound} at {} and 1 at {}; it tends to 4/3: {a3:.5} at 1e-300 rad below pi",
        limit.map_or("no amplitude".to_owned(), in_degrees),
        reached(1.0).map_or("no amplitude".to_owned(), in_degrees)
    );
    let correct =
        limit.map_or(String::new(), |limit| format!("|a3| < {bound} for theta0 below {}", in_degrees(limit)));
    let finding = StatementFinding::verified_if(a3.abs() <= bound, correct, evidence);
    Some(finding.holding_for(vec![(0.0, limit.unwrap_or(PI))]))
}

fn product_of_both(printed: &Printed) -> Option<StatementFinding> {
    let bound = decimal(printed.formula(0)?, &[])?;
    let product = |amplitude: &Angle| {
        let harmonics = harmonics(amplitude)?;
        Some((harmonics[0] * harmonics[1]).abs())
    };
    let reached =
        |bound: f64| amplitude_where_zero(0.1, PI - 1e-9, &|amplitude| Some(product(amplitude)? - bound));
    let limit = reached(bound);
    let evidence = format!(
        "|a1*a3| is {:.4} at 90 degrees, reaches 0.1 at {} and {bound} at {}, and tends to 16/3: {:.4} at 1e-300 rad \
         below pi",
        product(&at_degrees(90.0)?)?,
        reached(0.1).map_or("no amplitude".to_owned(), in_degrees),
        limit.map_or("no amplitude".to_owned(), in_degrees),
        product(&top()?)?
    );
    let correct = limit
        .map_or(String::new(), |limit| format!("|a1*a3| < {bound} for theta0 below {}", in_degrees(limit)));
    Some(
        StatementFinding::verified_if(limit.is_none(), correct, evidence)
            .holding_for(vec![(0.0, limit.unwrap_or(PI))]),
    )
}

fn order_of_corrections(printed: &Printed) -> Option<StatementFinding> {
    let bound = decimal(printed.formula(0)?, &[])?;
    let ratio =
        |amplitude: &Angle| Some(harmonics(amplitude)?[1].abs() / (1.0 - frequency_ratio(amplitude)?));
    let reached =
        |bound: f64| amplitude_where_zero(0.1, PI - 1e-9, &|amplitude| Some(ratio(amplitude)? - bound));
    let limit = reached(bound);
    let evidence = format!(
        "|a3|/|Delta - 1| is {:.3} at 90 degrees and {:.3} at 179 degrees; it reaches {bound} at {} and 1 at {}, and \
         tends to 4/3",
        ratio(&at_degrees(90.0)?)?,
        ratio(&at_degrees(179.0)?)?,
        limit.map_or("no amplitude".to_owned(), in_degrees),
        reached(1.0).map_or("no amplitude".to_owned(), in_degrees)
    );
    let correct = limit.map_or(String::new(), |limit| {
        format!("|a3| < {bound}*|Delta - 1| for theta0 below {}", in_degrees(limit))
    });
    Some(
        StatementFinding::verified_if(limit.is_none(), correct, evidence)
            .holding_for(vec![(0.0, limit.unwrap_or(PI))]),
    )
}
