//! Warnings that a fit of amplitudes calls for.

use std::f64::consts::{PI, TAU};

use super::comparison::LawComparison;
use super::{AmplitudeTable, AmplitudesFit, AmplitudesWarning};
use crate::fit::damping_model::DampingModel;
use crate::fit::scatter::{Scatter, ScatterWarning};

/// Damping counts as resolved where chance would make the fall as large less often than this.
const RESOLVED: f64 = 0.05;
/// Q below which averaging over a cycle has an error of 1 % or more: coefficients of integrated motions are off by less than 0.2/Q² from Q = 11 on.
const WEAK: f64 = 4.0;
/// Largest residual, relative to the largest value, that counts as rounding.
const ROUNDING: f64 = 1e-12;

/// Warnings, refuted laws first.
pub(super) fn warnings(
    table: &AmplitudeTable,
    comparison: &LawComparison<'_>,
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
    let qualities = [fit.quality, fit.last_quality].into_iter().flatten().map(|quality| quality.factor.value);
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
        near_top(table, fit),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// Warns where the error of the average over a cycle is more than a third of the uncertainty of a row.
fn near_top(table: &AmplitudeTable, fit: &AmplitudesFit) -> Option<AmplitudesWarning> {
    /// The error of an amplitude is at most about (2π/Q)²/(π − A)³ times this or 0.0034 A², whichever is less, A being the largest amplitude: of
    /// turning points under linear damping, integrated to 1e-11 from 1.0 to 3.0 rad with Q = 10 to 333, the largest error was 0.06 (from 3.0 rad
    /// with Q = 10) to 1.06 times that, and 0.7 to 1.06 times up to 2.5 rad.
    const ERROR: f64 = 0.017;
    const OF_SQUARE: f64 = 0.0034;
    const PART: f64 = 1.0 / 3.0;
    let law = fit.law();
    let quality = fit.quality.filter(|_| table.reading.is_of_angles())?.factor.value;
    let largest = law.amplitudes.iter().copied().fold(0.0, f64::max);
    let spread = law.standard_deviations.iter().copied().fold(f64::INFINITY, f64::min);
    let loss = TAU / quality;
    let (at_one, tolerated) = (ERROR * loss * loss, PART * spread);
    let part = (OF_SQUARE / ERROR * largest * largest).min(1.0);
    let below = PI - largest;
    let error = part * at_one / (below * below * below);
    let from = PI - libm::cbrt(at_one / tolerated);
    (error > tolerated && spread > 0.0).then_some(AmplitudesWarning::AveragedNearTop { error, from })
}

fn refuted(comparison: &LawComparison<'_>) -> Option<AmplitudesWarning> {
    let (given, preferred) = (&comparison.laws[comparison.chosen], comparison.preferred_to_given()?);
    Some(AmplitudesWarning::LawRefuted {
        given: given.fit.terms,
        preferred: preferred.fit.terms,
        difference: given.excess - preferred.excess,
    })
}

fn not_separated(comparison: &LawComparison<'_>) -> Option<AmplitudesWarning> {
    let chosen = comparison.laws[comparison.chosen].fit.terms;
    // A law with one kind of damping more is not another one: its further coefficient is not resolved.
    let others = comparison.not_separated().filter(|law| !chosen.is_part_of(law.fit.terms));
    let laws: Vec<DampingModel> = others.map(|law| law.fit.terms).collect();
    (!laws.is_empty()).then_some(AmplitudesWarning::LawsNotSeparated(laws))
}
