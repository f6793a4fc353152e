//! From recordings of swings to everything that they say.

use libration::watch::Watch;

use super::fitted::{SwingsFit, small_angle_period};
use super::options::SwingsOptions;
use super::pendulum::pendulum;
use super::{doubts, improvements};
use crate::fit::budget::BudgetError;
use crate::fit::cycles::{self, beta_of_traces};
use crate::fit::trace::{TraceFitError, compare, fit_traces};
use crate::measurement::Trace;

/// Why swings have no answer.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SwingsError {
    /// No motion could be fitted.
    #[error(transparent)]
    Motion(#[from] TraceFitError),
    /// There is no gravity with this apparatus.
    #[error(transparent)]
    Gravity(#[from] BudgetError),
}

/// What traces of the same pendulum say. `watch` is asked before each evaluation of the motion, and before the
/// cycles of each trace, and may stop it all.
///
/// # Errors
/// No motion could be fitted, or there is no gravity with this apparatus.
pub fn swings(
    traces: &[Trace],
    options: &SwingsOptions<'_>,
    watch: &Watch<'_>,
) -> Result<SwingsFit, SwingsError> {
    let (fit, comparison) = match options.damping {
        Some(damping) => (fit_traces(traces, damping, &options.trace, watch)?, None),
        None => {
            let comparison = compare(traces, &options.trace, watch)?;
            (comparison.best().clone(), Some(comparison))
        }
    };
    let cycles = traces.iter().map(|trace| {
        watch.go_on().map_err(|_| TraceFitError::Interrupted)?;
        Ok(cycles::cycles(trace, &cycles::CyclesOptions::default()))
    });
    let cycles = cycles.collect::<Result<Vec<_>, TraceFitError>>()?;
    let pendulum = pendulum(&fit, small_angle_period(&fit, comparison.as_ref()), &cycles, options)?;
    let beta = beta_of_traces(traces, &cycles);
    let mut found = SwingsFit { fit, comparison, cycles, beta, pendulum, warnings: vec![], advice: vec![] };
    found.warnings = doubts::warnings(&found, traces);
    found.advice = improvements::advice(&found, traces);
    Ok(found)
}
