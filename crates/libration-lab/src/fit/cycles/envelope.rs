//! Comparison of damping laws for the falling amplitude: each combination of dry friction, linear and quadratic damping is fitted to
//! the extremes, by the exact loss of energy at any amplitude, and compared by its residuals.
//!
//! The comparison is Akaike's, corrected for few data: `AICc` = n ln(χ²/n) + 2k + 2k(k + 1)/(n − k − 1), k counting the
//! unknown noise too. Correlated residuals count for fewer: n(1 − ρ)/(1 + ρ).
//!
//! Reference: K. P. Burnham and D. R. Anderson, *Model Selection and Multimodel Inference*, 2nd ed., Springer 2002,
//! doi:10.1007/b97636, sections 2.4 and 2.6.

use libration::internals::InOrder;
use std::fmt;

use super::fall::{EnvelopeLaw, Fall};
use super::{CyclesError, HalfSwing};
use crate::fit::trace::{DampingKind, DampingModel};
use crate::fit::uncertain::Uncertain;
use crate::statistics::{akaike, count};
use libration::internals::progress::Watch;
use libration::quantity::with_uncertainty;

/// Laws whose `AICc` differ by less than this are not separated by the data, as for motions ([`Comparison::INDISTINGUISHABLE`]).
///
/// [`Comparison::INDISTINGUISHABLE`]: crate::fit::trace::Comparison::INDISTINGUISHABLE
pub const SEPARATED: f64 = 4.0;
/// Fewest extremes that determine the law: with four, the correction of `AICc` for a law with one coefficient, which has three unknowns with the
/// noise, is infinite.
const FEWEST: usize = 5;

/// A coefficient of the damping.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coefficient {
    /// Kind of damping, which determines the unit.
    pub term: DampingKind,
    /// Estimate in the unit of the term; its uncertainty comes from the scatter of the extremes, which may be correlated, and from the pivot where
    /// it was fitted.
    pub estimate: Uncertain,
}

/// `0.0300 ± 0.0010 1/s`.
impl fmt::Display for Coefficient {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let unit = match self.term.unit() {
            "1" => String::new(),
            unit => unit.replace("^2", "²"),
        };
        f.pad(&with_uncertainty(self.estimate.value, self.estimate.uncertainty, &unit))
    }
}

/// One law fitted to the extremes.
#[derive(Clone, Debug, PartialEq)]
pub struct EnvelopeFit {
    /// Kinds of damping in the law.
    pub damping: DampingModel,
    /// Amplitude at the time of the first half swing, in radians.
    pub amplitude: f64,
    /// Coefficients in the order of the terms.
    pub coefficients: Vec<Coefficient>,
    /// The root mean square of the residuals, in radians.
    pub rms: f64,
    /// Difference of its `AICc` from that of the best law.
    pub aicc_difference: f64,
    /// The amplitude at each half swing, in radians.
    pub fitted: Vec<f64>,
}

/// The laws of the falling amplitude, the best one first. A law in which a coefficient would be negative is left out.
#[derive(Clone, Debug, PartialEq)]
pub struct Envelope {
    /// Fits, at least one.
    pub fits: Vec<EnvelopeFit>,
    /// Effective number of independent extremes.
    pub independent_half_swings: f64,
    /// Number of extremes that are far from every law and do not count.
    pub outliers: usize,
    /// Weights of the extremes: one over their uncertainties, zero for outliers.
    pub(super) weights: Vec<f64>,
}

impl Envelope {
    /// The law preferred by the data.
    #[must_use]
    pub fn preferred(&self) -> &EnvelopeFit {
        &self.fits[0]
    }

    /// The laws that the data do not separate from the preferred one: `AICc` within [`SEPARATED`] of it.
    pub fn not_separated(&self) -> impl Iterator<Item = &EnvelopeFit> {
        self.fits[1..].iter().filter(|fit| fit.aicc_difference < SEPARATED)
    }

    /// The verdict of the comparison, as a sentence.
    #[must_use]
    pub fn verdict(&self) -> String {
        let preferred = named(self.preferred().damping);
        let others: Vec<String> = self.not_separated().map(|fit| named(fit.damping)).collect();
        match &others[..] {
            [] => format!("the decay of the amplitude fits {preferred} best"),
            others => format!(
                "the decay of the amplitude fits {preferred} best, but that cannot be distinguished from {} (AICc within {SEPARATED})",
                others.join(", ")
            ),
        }
    }
}

fn named(damping: DampingModel) -> String {
    if damping == DampingModel::UNDAMPED { "no damping".to_owned() } else { format!("{damping} damping") }
}

/// Fits the laws to these half swings of a pendulum of this ω0.
pub(super) fn envelope(
    half_swings: &[HalfSwing],
    omega0: f64,
    watch: &Watch<'_>,
) -> Result<Envelope, CyclesError> {
    if half_swings.len() < FEWEST {
        return Err(CyclesError::TooFewHalfSwings { count: half_swings.len(), needed: FEWEST });
    }
    let mut fall = Fall::new(half_swings, omega0, watch);
    let full = DampingModel::all().into_iter().max_by_key(|terms| terms.count()).unwrap_or_default();
    let outliers = fall.drop_outliers(full);
    let curves: Vec<EnvelopeLaw> =
        DampingModel::all().into_iter().filter_map(|terms| fall.fit(terms)).collect();
    let physical = |curve: &EnvelopeLaw| curve.parameters[1..].iter().all(|&coefficient| coefficient >= 0.0);
    let best = curves.iter().min_by(|a, b| a.chi2.total_cmp(&b.chi2));
    let counted = fall.weights.iter().filter(|&&weight| weight > 0.0).count();
    let counted = count(counted);
    let independent = best.map_or(counted, |best| counted * independence(&fall, best)).max(3.0);
    let score =
        |curve: &EnvelopeLaw| akaike::of_scatter(curve.chi2 / counted, independent, curve.parameters.len());
    let mut fits: Vec<(f64, EnvelopeFit)> = curves
        .iter()
        .filter(|curve| physical(curve))
        .filter_map(|curve| Some((score(curve)?, fall.described(curve, counted, independent))))
        .collect();
    fits.put_in_order(|a, b| a.0.total_cmp(&b.0));
    let Some(lowest) = fits.first().map(|fit| fit.0) else {
        return Err(CyclesError::TooFewHalfSwings { count: half_swings.len(), needed: FEWEST });
    };
    let fits = fits.into_iter().map(|(score, fit)| EnvelopeFit { aicc_difference: score - lowest, ..fit });
    Ok(Envelope {
        fits: fits.collect(),
        independent_half_swings: independent,
        outliers,
        weights: fall.weights,
    })
}

/// (1 − ρ)/(1 + ρ) with the correlation ρ of residuals: the mean of those at lags one and two, so that a small
/// error of the centre does not look like independence.
fn independence(fall: &Fall<'_>, best: &EnvelopeLaw) -> f64 {
    let residuals: Vec<f64> = fall.residuals(&best.fitted);
    let square: f64 = residuals.iter().map(|r| r * r).sum();
    let lagged =
        |lag: usize| residuals.iter().zip(&residuals[lag..]).map(|(a, b)| a * b).sum::<f64>() / square;
    let correlation = (0.5 * (lagged(1) + lagged(2))).clamp(0.0, 0.95);
    if correlation.is_nan() { 1.0 } else { (1.0 - correlation) / (1.0 + correlation) }
}

impl Fall<'_> {
    fn described(&self, curve: &EnvelopeLaw, counted: f64, independent: f64) -> EnvelopeFit {
        let dof = (counted - count(curve.parameters.len())).max(1.0);
        let scale = curve.chi2 / dof * counted / independent;
        let coefficients = curve.terms.iter().enumerate().map(|(k, term)| Coefficient {
            term,
            estimate: Uncertain {
                value: curve.parameters[k + 1],
                uncertainty: (scale * curve.covariance[(k + 1, k + 1)]).sqrt(),
            },
        });
        let counts = self.half_swings.iter().zip(&curve.fitted).zip(&self.weights).filter(|row| *row.1 > 0.0);
        let deviations = counts.map(|((half, fitted), _)| half.amplitude.value - fitted);
        let square: f64 = deviations.map(|deviation| deviation * deviation).sum();
        EnvelopeFit {
            damping: curve.terms,
            amplitude: curve.parameters[0],
            coefficients: coefficients.collect(),
            rms: (square / counted).sqrt(),
            aicc_difference: 0.0,
            fitted: curve.fitted.clone(),
        }
    }
}
