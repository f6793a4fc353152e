//! Which kinds of damping the data tell apart.

use crate::statistics::count;
use std::ops::ControlFlow;

use super::information::information;
use super::problem::Minimum;
use super::search::{Search, better};
use super::{DampingTerms, TraceFit, TraceFitError, TraceOptions, check_explained, huber, uncertainty};
use crate::fit::Uncertain;
use crate::measurement::Trace;

/// The same traces under several models.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// One for each model that could be fitted, simpler ones first.
    pub fits: Vec<TraceFit>,
    /// Akaike's criterion of each, less the least.
    pub excess_information: Vec<f64>,
    /// The place of the model that the data prefer: the simplest of those whose evidence is within [`Self::SUBSTANTIAL`] of the
    /// best.
    pub preferred: usize,
    /// How many rows were counted as independent, by the residuals of the largest model; never fewer than it takes to judge that.
    pub independent_rows: f64,
}

/// How a model stands beside the preferred one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    /// The one that the data prefer.
    Preferred,
    /// The data cannot tell it from the preferred one.
    Tied,
    /// Worse, but the data do not exclude it.
    Possible,
    /// It explains the data better, by too little to believe in a coefficient that is negative.
    Negative,
    /// It feeds energy to the pendulum at some speed, which no friction does.
    FeedsEnergy,
    /// The data exclude it.
    Excluded,
}

impl Standing {
    /// A name that stays.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Preferred => "preferred",
            Self::Tied => "tied",
            Self::Possible => "possible",
            Self::Negative => "negative",
            Self::FeedsEnergy => "feeds_energy",
            Self::Excluded => "excluded",
        }
    }
}

/// A number averaged over the models that the data leave.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Averaged {
    /// The mean, each model with its weight.
    pub value: f64,
    /// The standard uncertainty, the spread between the models included.
    pub uncertainty: f64,
    /// The spread between the models alone, as a standard deviation.
    pub spread: f64,
}

impl From<Averaged> for Uncertain {
    fn from(Averaged { value, uncertainty, .. }: Averaged) -> Self {
        Self { value, uncertainty }
    }
}

impl Comparison {
    /// Models whose criterion differs by less explain the data nearly as well; the data cannot tell them apart (Burnham and
    /// Anderson 2002, section 2.6).
    pub const INDISTINGUISHABLE: f64 = 4.0;
    /// Beyond it a model has essentially no support (ibidem): a weight of e⁻⁵, or 1 in 148.
    pub const UNSUPPORTED: f64 = 10.0;
    /// Of models whose criterion is within this of the least the simplest is preferred.
    pub const SUBSTANTIAL: f64 = 2.0;
    /// So many of its uncertainties a coefficient does not move by chance: one in 370 times.
    pub const MOVED: f64 = 3.0;
    /// A coefficient is believed to be negative where the criterion differs by more.
    pub const DECISIVE: f64 = 20.0;

    /// The model that the data prefer.
    #[must_use]
    pub fn best(&self) -> &TraceFit {
        &self.fits[self.preferred]
    }

    /// How the model at this place stands.
    #[must_use]
    pub fn standing(&self, place: usize) -> Standing {
        let fit = &self.fits[place];
        let beyond = self.evidence(place) - self.evidence(self.preferred);
        match () {
            () if place == self.preferred => Standing::Preferred,
            () if !fit.takes_energy() => Standing::FeedsEnergy,
            () if beyond < Self::INDISTINGUISHABLE => Standing::Tied,
            () if beyond < Self::UNSUPPORTED => Standing::Possible,
            () if self.is_better(place) => Standing::Negative,
            () => Standing::Excluded,
        }
    }

    /// The other models that the data do not exclude.
    #[must_use]
    pub fn rivals(&self) -> Vec<DampingTerms> {
        let left = |place: &usize| matches!(self.standing(*place), Standing::Tied | Standing::Possible);
        (0..self.fits.len()).filter(left).map(|place| self.fits[place].damping).collect()
    }

    /// Those of the rivals that contradict the preferred model: they lack a kind of damping that it has, or with what they add to
    /// it a coefficient of the damping becomes another, by more than [`Self::MOVED`] of the uncertainties that it states.
    #[must_use]
    pub fn contradicting(&self) -> Vec<DampingTerms> {
        let preferred = self.best();
        let moves = |rival: &TraceFit| {
            preferred.damping.iter().any(|term| {
                let [own, other] = [preferred, rival].map(|fit| fit.parameter(term.name()));
                own.zip(other).is_none_or(|(own, other)| {
                    (other.value - own.value).abs() > Self::MOVED * own.uncertainty
                })
            })
        };
        let named = |terms: DampingTerms| self.fits.iter().find(|fit| fit.damping == terms);
        self.rivals().into_iter().filter(|&rival| named(rival).is_some_and(moves)).collect()
    }

    /// The models that explain the data better than the preferred one and are not believed, with by how much.
    pub fn better(&self) -> impl Iterator<Item = (&TraceFit, f64)> {
        let least = self.excess_information[self.preferred];
        let places = (0..self.fits.len()).filter(|&place| place != self.preferred && self.is_better(place));
        places.map(move |place| (&self.fits[place], least - self.excess_information[place]))
    }

    fn is_better(&self, place: usize) -> bool {
        let possible = self.fits[place].takes_energy() && self.fits[place].damps_by_each_term();
        !possible && self.excess_information[place] < self.excess_information[self.preferred]
    }

    /// How much the data speak for each model (Akaike's weights, ibidem, section 2.9): the sum is 1, and those that are
    /// excluded have none.
    #[must_use]
    pub fn weights(&self) -> Vec<f64> {
        let least = (0..self.fits.len()).map(|place| self.evidence(place)).fold(f64::INFINITY, f64::min);
        let weight = |place: usize| match self.standing(place) {
            Standing::Preferred | Standing::Tied | Standing::Possible => {
                libm::exp(-0.5 * (self.evidence(place) - least).min(2.0 * Self::DECISIVE))
            }
            Standing::Negative | Standing::FeedsEnergy | Standing::Excluded => 0.0,
        };
        let weights: Vec<f64> = (0..self.fits.len()).map(weight).collect();
        let sum: f64 = weights.iter().sum();
        weights.into_iter().map(|weight| weight / sum).collect()
    }

    /// 2π/ω0, averaged over the models, in s.
    #[must_use]
    pub fn small_angle_period(&self) -> Averaged {
        self.averaged(|fit| {
            let period = fit.small_angle_period();
            Some((period.value, period.uncertainty))
        })
    }

    /// A shared parameter, averaged over the models that have it; none if no model has.
    #[must_use]
    pub fn parameter(&self, name: &str) -> Option<Averaged> {
        let value = |fit: &TraceFit| fit.parameter(name).map(|it| (it.value, it.uncertainty));
        self.fits.iter().any(|fit| value(fit).is_some()).then(|| self.averaged(value))
    }

    /// With the unconditional variance of Burnham and Anderson's equation 4.9, as variances.
    fn averaged(&self, of: impl Fn(&TraceFit) -> Option<(f64, f64)>) -> Averaged {
        let weights = self.weights();
        let known = self.fits.iter().zip(&weights).filter_map(|(fit, weight)| Some((of(fit)?, *weight)));
        let known: Vec<((f64, f64), f64)> = known.collect();
        let total: f64 = known.iter().map(|(_, weight)| weight).sum();
        let mean = |value: &dyn Fn((f64, f64)) -> f64| {
            known.iter().map(|(pair, weight)| weight * value(*pair)).sum::<f64>() / total
        };
        let value = mean(&|(value, _)| value);
        let between = mean(&|(one, _)| (one - value) * (one - value));
        let within = mean(&|(_, uncertainty)| uncertainty * uncertainty);
        Averaged { value, uncertainty: (within + between).sqrt(), spread: between.sqrt() }
    }

    /// The criterion, with what it takes to believe in a negative coefficient; infinite for what no friction does.
    fn evidence(&self, place: usize) -> f64 {
        evidence(&self.fits[place], self.excess_information[place])
    }

    fn new(fits: Vec<TraceFit>, robust: bool) -> Option<Self> {
        let independent_rows = rows_that_count(fits.last()?);
        let scales = fits.iter().map(|fit| huber::scale(&fit.standard_residuals));
        let scale = scales.reduce(f64::min).filter(|&scale| robust && scale > 0.0);
        let information: Vec<f64> =
            fits.iter().map(|fit| information(fit, independent_rows, scale)).collect();
        let least = information.iter().copied().fold(f64::INFINITY, f64::min);
        let excess_information: Vec<f64> =
            information.iter().map(|value| if value.is_finite() { value - least } else { *value }).collect();
        let evidence: Vec<f64> =
            fits.iter().zip(&excess_information).map(|(fit, excess)| evidence(fit, *excess)).collect();
        let counts: Vec<usize> = fits.iter().map(|fit| fit.damping.count()).collect();
        Some(Self { preferred: simplest(&counts, &evidence), fits, excess_information, independent_rows })
    }
}

/// The independent rows of the largest model. Where they are fewer than its parameters, the criterion would be infinite for the
/// large models, or for all of them, and the simplest one preferred however badly it describes the data. With the fewest that
/// make it finite a parameter more costs some ten times as much as with many rows: only a far better fit is worth it.
fn rows_that_count(largest: &TraceFit) -> f64 {
    // The variance of the residuals is a parameter too, and n − k − 1 must be above zero.
    largest.independent_rows.max(count(largest.parameters.len() + 1) + 2.0)
}

fn evidence(fit: &TraceFit, excess: f64) -> f64 {
    match (fit.takes_energy(), fit.damps_by_each_term()) {
        (false, _) => f64::INFINITY,
        (true, false) => excess + Comparison::DECISIVE,
        (true, true) => excess,
    }
}

/// Of the models within [`Comparison::SUBSTANTIAL`] of the best one those with the fewest terms, and of these the best.
fn simplest(counts: &[usize], evidence: &[f64]) -> usize {
    let least = evidence.iter().copied().fold(f64::INFINITY, f64::min);
    let close = (0..counts.len()).filter(|&place| evidence[place] <= least + Comparison::SUBSTANTIAL);
    let order =
        |&a: &usize, &b: &usize| counts[a].cmp(&counts[b]).then_with(|| evidence[a].total_cmp(&evidence[b]));
    close.min_by(order).unwrap_or(0)
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

#[cfg(test)]
mod tests {
    use super::super::{Autocorrelation, DampingTerm, Parameter};
    use super::*;

    fn coefficient(name: &'static str, value: f64) -> Parameter {
        Parameter { name, value, uncertainty: 0.001, ..Parameter::default() }
    }

    /// A model of a pendulum with ω0 and these coefficients that leaves residuals of this size in 100 rows.
    fn fit(terms: &str, omega0: f64, coefficients: &[f64], residual: f64) -> TraceFit {
        let damping: DampingTerms = terms.parse().unwrap();
        let names = damping.iter().map(DampingTerm::name);
        let of_damping = names.zip(coefficients).map(|(name, &value)| coefficient(name, value));
        let speed = Parameter { trace: Some(0), ..coefficient("velocity0", 2.0) };
        let parameters: Vec<Parameter> =
            [coefficient("omega0", omega0)].into_iter().chain(of_damping).chain([speed]).collect();
        let n = parameters.len();
        let unit = |i: usize| (0..n).map(|j| if i == j { 1.0 } else { 0.0 }).collect();
        TraceFit {
            damping,
            correlations: (0..n).map(unit).collect(),
            parameters,
            traces: vec![super::super::FittedTrace {
                begins: 0.0,
                fitted: vec![],
                residuals: vec![],
                outliers: vec![],
            }],
            degrees_of_freedom: 100 - n,
            independent_rows: 100.0,
            chi2_per_dof: None,
            rms: residual,
            unexplained: 0.0,
            autocorrelation: Autocorrelation::of(&[]),
            bootstrap_block: None,
            converged: true,
            standard_residuals: vec![residual; 100],
        }
    }

    /// The size of residuals of 100 rows by which linear damping is worse than linear and quadratic one by `excess`.
    fn residual(excess: f64) -> f64 {
        let cost = |k: f64| crate::statistics::akaike::cost(100.0, k).unwrap();
        libm::exp((excess + cost(5.0) - cost(4.0)) / 200.0)
    }

    fn two(excess: f64, first: f64, second: f64) -> Comparison {
        let fits = vec![
            fit("linear", 3.0, &[first], residual(excess)),
            fit("linear+quadratic", 3.01, &[0.02, second], 1.0),
        ];
        Comparison::new(fits, false).unwrap()
    }

    #[test]
    fn the_simplest_of_those_within_two_is_preferred() {
        assert_eq!(two(1.99, 0.1, 0.03).preferred, 0);
        assert_eq!(two(2.01, 0.1, 0.03).preferred, 1);
        assert_eq!(simplest(&[1, 1, 2], &[1.5, 0.5, 0.0]), 1);
    }

    #[test]
    fn standings_change_at_four_and_at_ten() {
        for (excess, expected) in [
            (3.99, Standing::Tied),
            (4.01, Standing::Possible),
            (9.99, Standing::Possible),
            (10.01, Standing::Excluded),
        ] {
            let comparison = two(excess, 0.1, 0.03);
            assert_eq!((comparison.preferred, comparison.standing(0)), (1, expected), "{excess}");
            assert_eq!(comparison.rivals().len(), usize::from(expected != Standing::Excluded));
        }
    }

    /// Uncertainties are 0.001: the linear coefficient is 0.02 in the larger model.
    #[test]
    fn a_larger_model_contradicts_where_it_moves_a_coefficient() {
        for (linear, contradicts) in [(0.0229, false), (0.0231, true), (0.0169, true)] {
            let comparison = two(1.5, linear, 0.03);
            assert_eq!((comparison.preferred, comparison.rivals().len()), (0, 1));
            assert_eq!(comparison.contradicting().len(), usize::from(contradicts), "{linear}");
        }
        // A smaller one lacks what the preferred one has, as long as it is not excluded.
        assert_eq!(two(4.1, 0.02, 0.03).contradicting().len(), 1);
        assert_eq!(two(10.1, 0.1, 0.03).contradicting().len(), 0);
    }

    #[test]
    fn a_negative_coefficient_is_believed_beyond_twenty_only_and_else_told() {
        let doubted = two(11.9, 0.1, -0.005);
        assert_eq!((doubted.preferred, doubted.standing(1)), (0, Standing::Possible));
        let better: Vec<f64> = doubted.better().map(|(_, by)| by).collect();
        assert!(better.len() == 1 && (better[0] - 11.9).abs() < 1e-9, "{better:?}");
        assert_eq!(two(9.0, 0.1, -0.005).standing(1), Standing::Negative);
        assert_eq!(two(19.0, 0.1, -0.005).preferred, 0);
        let believed = two(22.1, 0.1, -0.005);
        assert_eq!((believed.preferred, believed.better().count()), (1, 0));
    }

    #[test]
    fn what_feeds_energy_is_never_preferred() {
        let comparison = two(100.0, 0.1, -1.0);
        assert_eq!((comparison.preferred, comparison.standing(1)), (0, Standing::FeedsEnergy));
        assert!(comparison.weights()[0] > 0.999 && comparison.weights()[1] <= 0.0);
    }

    /// Weights 1 : e⁻² by hand, and the variance of both parts.
    #[test]
    fn numbers_are_averaged_over_the_models_that_are_left() {
        let comparison = two(4.0 + 1e-9, 0.1, 0.03);
        let part = libm::exp(-2.0) / (1.0 + libm::exp(-2.0));
        assert!((comparison.weights()[0] - part).abs() < 1e-9);
        let omega0 = comparison.parameter("omega0").unwrap();
        assert!((omega0.value - (3.01 - 0.01 * part)).abs() < 1e-9);
        let spread = 0.01 * (part * (1.0 - part)).sqrt();
        assert!((omega0.spread - spread).abs() < 1e-9);
        assert!((omega0.uncertainty - libm::hypot(spread, 0.001)).abs() < 1e-9);
        assert_eq!(comparison.parameter("quadratic").unwrap().value.to_bits(), 0.03_f64.to_bits());
        assert_eq!(comparison.parameter("dry"), None);
        assert!(
            (comparison.small_angle_period().value - 2.0 * std::f64::consts::PI / omega0.value).abs() < 1e-5
        );
    }

    /// Five rows count as seven, the fewest that judge the larger model: 8 + 40/2 and 10 + 60/1 is what the parameters cost,
    /// 42 of which a residual e^−3 as large just pays: 7·2·3.
    #[test]
    fn few_independent_rows_believe_in_far_better_fits_only() {
        let preferred = |residual: f64| {
            let mut fits =
                vec![fit("linear", 3.0, &[0.1], 1.0), fit("dry+linear", 3.0, &[0.1, 0.1], residual)];
            fits[1].independent_rows = 5.0;
            let comparison = Comparison::new(fits, false).unwrap();
            assert!((comparison.independent_rows - 7.0).abs() < 1e-12, "{}", comparison.independent_rows);
            assert!(comparison.excess_information.iter().all(|excess| excess.is_finite()));
            comparison.preferred
        };
        assert_eq!(preferred(0.5), 0);
        // The simpler one of those within two.
        assert_eq!(preferred(libm::exp(-3.1)), 0);
        assert_eq!(preferred(libm::exp(-3.2)), 1);
        assert_eq!(preferred(0.01), 1);
    }

    /// One outlier spoils the squares of the better model, and not Huber's loss.
    #[test]
    fn outliers_do_not_choose_a_robust_model() {
        let mut better = fit("linear", 3.0, &[0.1], 1.0);
        better.standard_residuals[7] = 40.0;
        let worse = fit("quadratic", 3.0, &[0.1], 2.0);
        let fits = vec![better, worse];
        assert_eq!(Comparison::new(fits.clone(), false).unwrap().best().damping.to_string(), "quadratic");
        assert_eq!(Comparison::new(fits, true).unwrap().best().damping.to_string(), "linear");
    }
}
