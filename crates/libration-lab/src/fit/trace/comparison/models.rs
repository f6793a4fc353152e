//! Every combination of dry friction, linear and quadratic drag, fitted one after the other.

use libration::internals::InOrder;
use libration::internals::progress::Watch;
use libration::progress::Progress;

use super::Comparison;
use crate::fit::trace::minimum::{Care, Descent, HOPELESS, TraceMinimum, deeper};
use crate::fit::trace::problem::{PATIENCE, Problem};
use crate::fit::trace::{
    DampingKind, DampingModel, TraceFit, TraceFitError, TraceOptions, check_explained, search, uncertainty,
};
use crate::measurement::Trace;
use crate::parallel;

/// Fits every combination of dry friction, linear and quadratic drag to traces.
///
/// Fails as [`fit_traces`](crate::fit::trace::fit_traces) does, if not even one model can be fitted.
pub fn compare(
    traces: &[Trace],
    options: &TraceOptions,
    progress: &dyn Progress,
) -> Result<Comparison, TraceFitError> {
    let watch = &Watch::new(progress);
    // The profile is of interest for the preferred model alone.
    let plain = TraceOptions { profile: false, ..*options };
    let undamped = Problem::new(traces, DampingModel::UNDAMPED, plain)?;
    let mut candidates: Vec<Candidate<'_>> = vec![];
    for count in 0..=DampingKind::ALL.len() {
        let alike: Vec<DampingModel> =
            DampingModel::all().into_iter().filter(|terms| terms.count() == count).collect();
        let tried = parallel::map(&alike, watch, |&terms, watch| {
            Candidate::new(undamped.with_terms(terms), &candidates, watch)
        });
        let tried = tried.into_iter().collect::<Result<Vec<Candidate<'_>>, TraceFitError>>()?;
        candidates.extend(tried);
    }
    if !candidates.iter().any(Candidate::follows) {
        return Err(reason(&candidates));
    }
    for candidate in &mut candidates {
        if let Some(end) = candidate.lost.take() {
            *candidate = Candidate::near(candidate.problem.clone(), Ok(end), watch)?;
        }
    }
    let fits = candidates.iter().filter_map(|candidate| candidate.fit.clone().ok()).collect();
    let mut comparison = Comparison::new(fits, options.robust).ok_or_else(|| reason(&candidates))?;
    check_explained(comparison.best())?;
    let preferred = comparison.best().damping;
    let preferred = candidates.iter().find(|candidate| candidate.terms() == preferred);
    if let Some(Candidate { problem, minimum: Some(minimum), .. }) = preferred {
        let with_profile = Problem { options: *options, ..problem.clone() };
        let minimum = with_profile.minimum_near(minimum.parameters.clone(), PATIENCE, Care::FULL, watch)?;
        comparison.fits[comparison.preferred] = uncertainty::fit(&with_profile, &minimum, watch)?;
    }
    Ok(comparison)
}

/// A model that is fitted for the comparison.
struct Candidate<'a> {
    problem: Problem<'a>,
    /// The end of a search that has lost the data, near which no minimum was searched: with all rows that takes longer than all searches, and is
    /// useful only next to a model that follows the data.
    lost: Option<Descent>,
    minimum: Option<TraceMinimum>,
    /// The fit, or the reason why it failed.
    fit: Result<TraceFit, TraceFitError>,
}

impl<'a> Candidate<'a> {
    /// Fits a model next to simpler ones that have been fitted before.
    ///
    /// # Errors
    /// Fails if the search was interrupted.
    fn new(problem: Problem<'a>, simpler: &[Self], watch: &Watch<'_>) -> Result<Self, TraceFitError> {
        match end(&problem, simpler, watch) {
            Ok(end) if end.is_lost() => {
                let fit = Err(end.unexplained_data());
                Ok(Self { problem, lost: Some(end), minimum: None, fit })
            }
            end => Self::near(problem, end, watch),
        }
    }

    /// Finds the minimum near the end of a search, by all rows.
    fn near(
        problem: Problem<'a>,
        end: Result<Descent, TraceFitError>,
        watch: &Watch<'_>,
    ) -> Result<Self, TraceFitError> {
        let minimum = end.and_then(|end| {
            let patience = search::patience(&end);
            problem.minimum_near(end.parameters, patience, Care::COMPARISON, watch)
        });
        let (minimum, fit) = match minimum {
            Ok(minimum) => {
                let fit = uncertainty::fit(&problem, &minimum, watch);
                (Some(minimum), fit)
            }
            Err(reason) => (None, Err(reason)),
        };
        match fit {
            Err(TraceFitError::Interrupted) => Err(TraceFitError::Interrupted),
            fit => Ok(Self { problem, lost: None, minimum, fit }),
        }
    }

    fn terms(&self) -> DampingModel {
        self.problem.model.layout.terms()
    }

    /// Returns `true` if the model is in phase with the data.
    fn follows(&self) -> bool {
        self.fit.as_ref().is_ok_and(|fit| fit.unexplained <= HOPELESS)
    }

    fn leaves_noise(&self) -> bool {
        self.fit.as_ref().is_ok_and(|fit| fit.autocorrelation.is_noise())
    }
}

/// The reason why no model could be fitted: that of the best model if all lose the data, otherwise that of the last one.
fn reason(candidates: &[Candidate<'_>]) -> TraceFitError {
    let lost = candidates.iter().filter_map(|candidate| candidate.lost.as_ref());
    let best = lost.min_by(|one, other| one.unexplained.total_cmp(&other.unexplained));
    let mut reasons = candidates.iter().rev().filter_map(|candidate| candidate.fit.as_ref().err());
    best.map(Descent::unexplained_data).or_else(|| reasons.next().cloned()).unwrap_or(TraceFitError::NoTrace)
}

/// The deepest end of the searches near models with one kind of damping less, and of that found from the first swings
/// on; the search ends early where the model or a smaller one leaves only noise. Models that are out of phase are not used as starts.
fn end(
    problem: &Problem<'_>,
    simpler: &[Candidate<'_>],
    watch: &Watch<'_>,
) -> Result<Descent, TraceFitError> {
    let layout = problem.model.layout;
    let terms = layout.terms();
    let parts = || simpler.iter().filter(|part| part.terms().is_part_of(terms));
    let next = parts().filter(|part| part.terms().count() + 1 == terms.count() && part.follows());
    let mut starts: Vec<(DampingModel, &TraceMinimum)> =
        next.filter_map(|part| Some((part.terms(), part.minimum.as_ref()?))).collect();
    starts.put_in_order(|(_, one), (_, other)| one.sum_of_squares().total_cmp(&other.sum_of_squares()));
    let mut near = vec![];
    for (part, minimum) in starts {
        near.push(problem.approach(layout.with_terms_of(part, &minimum.parameters), PATIENCE, watch));
        if near.last().is_some_and(|end| end.as_ref().is_ok_and(Descent::leaves_noise)) {
            break;
        }
    }
    let leaves_noise = near.last().is_some_and(|end| end.as_ref().is_ok_and(Descent::leaves_noise));
    // Where two starts lead to the same end a third is not needed.
    let is_known = near.iter().enumerate().any(|(n, one)| {
        near[..n]
            .iter()
            .any(|other| matches!((one, other), (Ok(one), Ok(other)) if search::are_alike(one, other)))
    });
    match near.into_iter().reduce(deeper) {
        Some(near) if is_known || leaves_noise => near,
        Some(near) if parts().any(Candidate::leaves_noise) => near,
        Some(near) => {
            let nearest = near.as_ref().ok().cloned();
            deeper(near, search::from_scratch(problem, nearest.as_ref(), watch))
        }
        None => search::from_scratch(problem, None, watch),
    }
}
