//! Which kinds of damping the data tell apart.

use std::ops::ControlFlow;

use super::information::information;
use super::problem::Minimum;
use super::search::{Search, better};
use super::{DampingTerms, TraceFit, TraceFitError, TraceOptions, check_explained, huber, uncertainty};
use crate::measurement::Trace;

/// The same traces under several models.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// One for each model that could be fitted, simpler ones first.
    pub fits: Vec<TraceFit>,
    /// Akaike's criterion of each, less the least.
    pub excess_information: Vec<f64>,
    /// The place of the model that the data prefer: the simplest of those within [`Self::SUBSTANTIAL`] of the best among those whose terms [all damp](TraceFit::damps_by_each_term); or
    /// among those that [take energy](TraceFit::takes_energy) in all, where one of them is better by [`Self::DECISIVE`].
    pub preferred: usize,
    /// After how many rows residuals of the largest model are independent.
    pub correlation_time: f64,
}

impl Comparison {
    /// Models whose criterion differs by less explain the data nearly as well (Burnham and Anderson 2002, section 2.6).
    pub const INDISTINGUISHABLE: f64 = 4.0;

    /// Of models whose criterion is within this of the least the simplest is preferred.
    pub const SUBSTANTIAL: f64 = 2.0;
    /// A coefficient is believed to be negative where the criterion differs by more.
    pub const DECISIVE: f64 = 20.0;

    /// The model that the data prefer.
    #[must_use]
    pub fn best(&self) -> &TraceFit {
        &self.fits[self.preferred]
    }

    /// The other possible models that the data cannot tell from the preferred one.
    #[must_use]
    pub fn rivals(&self) -> Vec<DampingTerms> {
        let least = self.excess_information[self.preferred];
        let close = (0..self.fits.len()).filter(|&place| {
            place != self.preferred
                && self.fits[place].takes_energy()
                && (self.excess_information[place] - least).abs() < Self::INDISTINGUISHABLE
        });
        close.map(|place| self.fits[place].damping).collect()
    }

    fn new(fits: Vec<TraceFit>, robust: bool) -> Option<Self> {
        let correlation_time = fits.last()?.autocorrelation.time;
        let scales = fits.iter().map(|fit| huber::scale(&fit.standard_residuals));
        let scale = scales.reduce(f64::min).filter(|&scale| robust && scale > 0.0);
        let information = fits.iter().map(|fit| information(fit, correlation_time, scale));
        let information: Vec<f64> = information.collect();
        let least = information.iter().copied().fold(f64::INFINITY, f64::min);
        let best_of = |possible: fn(&TraceFit) -> bool| {
            let places = (0..fits.len()).filter(|&place| possible(&fits[place]));
            let least = places.clone().map(|place| information[place]).fold(f64::INFINITY, f64::min);
            // Simpler ones come first.
            let mut close = places.filter(|&place| information[place] <= least + Self::SUBSTANTIAL);
            let first = close.next()?;
            let as_simple =
                close.take_while(|&place| fits[place].damping.count() == fits[first].damping.count());
            as_simple.chain([first]).min_by(|&a, &b| information[a].total_cmp(&information[b]))
        };
        let [plain, any] = [TraceFit::damps_by_each_term, TraceFit::takes_energy].map(best_of);
        let preferred = match (plain, any) {
            (Some(plain), Some(any)) if information[plain] - information[any] > Self::DECISIVE => any,
            (plain, any) => plain.or(any).unwrap_or(0),
        };
        let excess_information = information.iter().map(|value| value - least).collect();
        Some(Self { fits, excess_information, preferred, correlation_time })
    }
}

/// Fits every combination of dry friction, linear and quadratic drag to traces.
///
/// # Errors
/// Those of [`fit_traces`](super::fit_traces), if not even one model can be fitted.
pub fn compare(
    traces: &[Trace],
    options: &TraceOptions,
    watch: &mut dyn FnMut() -> ControlFlow<()>,
) -> Result<Comparison, TraceFitError> {
    // The profile is of interest for the preferred model alone.
    let plain = TraceOptions { profile: false, ..*options };
    let mut search = Search::new(traces, DampingTerms::UNDAMPED, plain, watch)?;
    let mut found: Vec<Found> = vec![];
    let mut fits = vec![];
    let mut reason = None;
    for terms in DampingTerms::all() {
        search.set_terms(terms);
        let fit = minimum(&mut search, &found).and_then(|minimum| {
            let fit = uncertainty::fit(&mut search, &minimum);
            let leaves_noise = fit.as_ref().is_ok_and(|fit| fit.autocorrelation.is_noise());
            found.push(Found { terms, minimum, leaves_noise });
            fit
        });
        match fit {
            Err(TraceFitError::Interrupted) => return Err(TraceFitError::Interrupted),
            Err(error) => reason = Some(error),
            Ok(fit) => fits.push(fit),
        }
    }
    let mut comparison =
        Comparison::new(fits, options.robust).ok_or_else(|| reason.unwrap_or(TraceFitError::NoTrace))?;
    check_explained(comparison.best())?;
    let preferred = comparison.best().damping;
    if let Some(found) = found.iter().find(|found| options.profile && found.terms == preferred) {
        search.set_terms(preferred);
        search.options.profile = true;
        comparison.fits[comparison.preferred] = uncertainty::fit(&mut search, &found.minimum)?;
    }
    Ok(comparison)
}

/// A model that has been fitted.
struct Found {
    terms: DampingTerms,
    minimum: Minimum,
    leaves_noise: bool,
}

/// The deepest minimum of those near models with one kind of damping less, and of that which is found from the first swings
/// on; the latter is not looked for where a smaller model leaves nothing but noise.
fn minimum(search: &mut Search<'_>, found: &[Found]) -> Result<Minimum, TraceFitError> {
    let terms = search.layout.terms();
    let parts = || found.iter().filter(|part| part.terms.is_part_of(terms));
    let mut near = vec![];
    for part in parts().filter(|part| part.terms.count() + 1 == terms.count()) {
        let parameters = search.layout.with_terms_of(part.terms, &part.minimum.parameters);
        near.push(search.minimum_near(parameters));
    }
    match near.into_iter().reduce(better) {
        Some(near) if parts().any(|part| part.leaves_noise) => near,
        Some(near) => better(near, search.minimum_from_scratch()),
        None => search.minimum_from_scratch(),
    }
}
