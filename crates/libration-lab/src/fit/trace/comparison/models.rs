//! Every combination of dry friction, linear and quadratic drag, fitted one after the other.

use libration::watch::Watch;

use super::Comparison;
use crate::fit::trace::minimum::{Minimum, deeper};
use crate::fit::trace::problem::{PATIENCE, Problem};
use crate::fit::trace::{
    DampingModel, TraceFit, TraceFitError, TraceOptions, check_explained, search, uncertainty,
};
use crate::measurement::Trace;

/// Fits every combination of dry friction, linear and quadratic drag to traces.
///
/// # Errors
/// Those of [`fit_traces`](crate::fit::trace::fit_traces), if not even one model can be fitted.
pub fn compare(
    traces: &[Trace],
    options: &TraceOptions,
    watch: &Watch<'_>,
) -> Result<Comparison, TraceFitError> {
    // The profile is of interest for the preferred model alone.
    let plain = TraceOptions { profile: false, ..*options };
    let undamped = Problem::new(traces, DampingModel::UNDAMPED, plain)?;
    let mut candidates: Vec<Candidate<'_>> = vec![];
    for terms in DampingModel::all() {
        let candidate = Candidate::new(undamped.with_terms(terms), &candidates, watch)?;
        candidates.push(candidate);
    }
    let fits = candidates.iter().filter_map(|candidate| candidate.fit.clone().ok()).collect();
    let mut comparison = Comparison::new(fits, options.robust).ok_or_else(|| reason(&candidates))?;
    check_explained(comparison.best())?;
    let preferred = comparison.best().damping;
    let preferred = candidates.iter().find(|candidate| options.profile && candidate.terms() == preferred);
    if let Some(Candidate { problem, minimum: Some(minimum), .. }) = preferred {
        let with_profile = Problem { options: *options, ..problem.clone() };
        comparison.fits[comparison.preferred] = uncertainty::fit(&with_profile, minimum, watch)?;
    }
    Ok(comparison)
}

/// A model that is tried.
struct Candidate<'a> {
    problem: Problem<'a>,
    minimum: Option<Minimum>,
    /// What it says, or why it cannot be fitted.
    fit: Result<TraceFit, TraceFitError>,
}

impl<'a> Candidate<'a> {
    /// Beside simpler models that have been tried before.
    ///
    /// # Errors
    /// An interruption.
    fn new(problem: Problem<'a>, simpler: &[Self], watch: &Watch<'_>) -> Result<Self, TraceFitError> {
        let (minimum, fit) = match minimum(&problem, simpler, watch) {
            Ok(minimum) => {
                let fit = uncertainty::fit(&problem, &minimum, watch);
                (Some(minimum), fit)
            }
            Err(reason) => (None, Err(reason)),
        };
        match fit {
            Err(TraceFitError::Interrupted) => Err(TraceFitError::Interrupted),
            fit => Ok(Self { problem, minimum, fit }),
        }
    }

    fn terms(&self) -> DampingModel {
        self.problem.model.layout.terms()
    }

    fn leaves_noise(&self) -> bool {
        self.fit.as_ref().is_ok_and(|fit| fit.autocorrelation.is_noise())
    }
}

/// Why the last of the models could not be fitted.
fn reason(candidates: &[Candidate<'_>]) -> TraceFitError {
    let mut reasons = candidates.iter().rev().filter_map(|candidate| candidate.fit.as_ref().err());
    reasons.next().cloned().unwrap_or(TraceFitError::NoTrace)
}

/// The deepest minimum of those near models with one kind of damping less, and of that which is found from the first swings
/// on; the latter is not looked for where a smaller model leaves nothing but noise.
fn minimum(
    problem: &Problem<'_>,
    simpler: &[Candidate<'_>],
    watch: &Watch<'_>,
) -> Result<Minimum, TraceFitError> {
    let layout = problem.model.layout;
    let terms = layout.terms();
    let parts = || simpler.iter().filter(|part| part.terms().is_part_of(terms) && part.minimum.is_some());
    let mut near = vec![];
    for part in parts().filter(|part| part.terms().count() + 1 == terms.count()) {
        if let Some(minimum) = &part.minimum {
            let parameters = layout.with_terms_of(part.terms(), &minimum.parameters);
            near.push(problem.minimum_near(parameters, PATIENCE, watch));
        }
    }
    match near.into_iter().reduce(deeper) {
        Some(near) if parts().any(Candidate::leaves_noise) => near,
        Some(near) => deeper(near, search::from_scratch(problem, watch)),
        None => search::from_scratch(problem, watch),
    }
}
