//! Warnings that a fit of amplitudes calls for.

use super::comparison::Comparison;
use super::{AmplitudeTable, AmplitudesFit, AmplitudesWarning};
use crate::fit::DampingModel;
use crate::fit::scatter::{Scatter, ScatterWarning};

/// Damping counts as resolved where chance would make the fall as large less often than this.
const RESOLVED: f64 = 0.05;
/// Below this Q averaging over a cycle errs by a hundredth or more: coefficients of integrated motions from Q = 11 on are off by less than 0.2/Q².
const WEAK: f64 = 4.0;
/// Residuals below this part of the largest value are rounding.
const ROUNDING: f64 = 1e-12;

/// Warnings, refuted laws first.
pub(super) fn warnings(
    table: &AmplitudeTable,
    comparison: &Comparison<'_>,
    fit: &AmplitudesFit,
) -> Vec<AmplitudesWarning> {
    let law = fit.law();
    let largest = table.rows.iter().map(|row| row.value.abs()).fold(0.0, f64::max);
    let is_rounding = law.residuals.iter().all(|residual| residual.abs() <= ROUNDING * largest);
    let scatter = match table.weighted {
        true => {
            law.scatter().and_then(|scatter: Scatter| scatter.warning("the zero or the factor of the scale"))
        }
        false => is_rounding.then_some(ScatterWarning::Without),
    };
    let chance = law.chance.filter(|chance| *chance > RESOLVED && law.damping.count() == 1);
    let qualities = [fit.quality, fit.last_quality].into_iter().flatten().map(|it| it.factor.value);
    let lowest = qualities.fold(f64::INFINITY, f64::min);
    [
        refuted(comparison),
        (law.rows_per_error > 1.0)
            .then_some(AmplitudesWarning::ResidualsNotWhite { rows_per_error: law.rows_per_error }),
        scatter.map(AmplitudesWarning::Scatter),
        not_separated(comparison),
        law.aicc.is_none().then_some(AmplitudesWarning::TooFewRowsToCompare),
        chance.map(|chance| AmplitudesWarning::DampingNotResolved { chance }),
        (lowest < WEAK).then_some(AmplitudesWarning::StrongDamping { quality: lowest }),
    ]
    .into_iter()
    .flatten()
    .collect()
}

fn refuted(comparison: &Comparison<'_>) -> Option<AmplitudesWarning> {
    let (given, preferred) = (&comparison.laws[comparison.chosen], comparison.preferred_to_given()?);
    Some(AmplitudesWarning::LawRefuted {
        given: given.found.terms,
        preferred: preferred.found.terms,
        difference: given.excess - preferred.excess,
    })
}

fn not_separated(comparison: &Comparison<'_>) -> Option<AmplitudesWarning> {
    let chosen = comparison.laws[comparison.chosen].found.terms;
    // A law with one kind of damping more is not another one: its further coefficient is not resolved.
    let others = comparison.not_separated().filter(|law| !chosen.is_part_of(law.found.terms));
    let laws: Vec<DampingModel> = others.map(|law| law.found.terms).collect();
    (!laws.is_empty()).then_some(AmplitudesWarning::LawsNotSeparated(laws))
}
