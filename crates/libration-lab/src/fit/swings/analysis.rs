//! Analysis of recordings of swings.

use libration::internals::progress::Watch;
use libration::progress::Progress;

use super::FittedPendulum;
use super::fitted::{SwingsFit, small_angle_period};
use super::options::SwingsOptions;
use super::pendulum::pendulum_of;
use super::{doubts, improvements};
use crate::fit::budget::BudgetError;
use crate::fit::cycles::{CyclesError, CyclesOptions, beta_of_traces, fit_cycles};
use crate::fit::trace::{ParameterKind, TraceFitError, compare, fit_traces};
use crate::fit::uncertain::Uncertain;
use crate::measurement::Trace;

/// Reasons why swings have no result.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SwingsError {
    /// No motion could be fitted.
    #[error(transparent)]
    Motion(#[from] TraceFitError),
    /// Gravity cannot be computed with this apparatus.
    #[error(transparent)]
    Gravity(#[from] BudgetError),
}

/// Analyses traces of the same pendulum.
///
/// # Errors
/// Fails where no motion could be fitted, and where gravity cannot be computed with this apparatus; on cancellation.
pub fn fit_swings(
    traces: &[Trace],
    options: &SwingsOptions<'_>,
    progress: &dyn Progress,
) -> Result<SwingsFit, SwingsError> {
    let watch = &Watch::new(progress);
    let (fit, comparison) = match options.damping {
        Some(damping) => (fit_traces(traces, damping, &options.trace, watch)?, None),
        None => {
            let comparison = compare(traces, &options.trace, watch)?;
            (comparison.best().clone(), Some(comparison))
        }
    };
    let cycles = traces.iter().map(|trace| match fit_cycles(trace, &CyclesOptions::default(), watch) {
        Err(CyclesError::Interrupted(_)) => Err(TraceFitError::Interrupted),
        cycles => Ok(cycles),
    });
    let cycles = cycles.collect::<Result<Vec<_>, TraceFitError>>()?;
    let beta = beta_of_traces(traces, &cycles, watch);
    if watch.is_stopped() {
        return Err(TraceFitError::Interrupted.into());
    }
    let t0 = small_angle_period(&fit, comparison.as_ref());
    if t0.uncertainty.is_nan() || t0.uncertainty >= t0.value {
        return Err(TraceFitError::Undetermined { parameter: ParameterKind::NaturalFrequency }.into());
    }
    let pendulum = FittedPendulum::Length(Uncertain::default());
    let (contradiction, warnings, advice) = (None, vec![], vec![]);
    let mut analysis = SwingsFit { fit, comparison, cycles, beta, contradiction, pendulum, warnings, advice };
    analysis.contradiction = analysis.contradicting(traces);
    let model = analysis
        .contradiction
        .as_ref()
        .map(|contradiction| contradiction.uncertainty() / contradiction.values[0]);
    analysis.pendulum =
        pendulum_of(&analysis.fit, analysis.period_of_runs(), model, &analysis.cycles, options)?;
    analysis.warnings = doubts::warnings(&analysis, traces);
    analysis.advice = improvements::advice(&analysis, traces, options.angle_scale);
    Ok(analysis)
}
