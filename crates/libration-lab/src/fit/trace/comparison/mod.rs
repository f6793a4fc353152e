//! Comparison of the kinds of damping by the data.
//!
//! # Method
//! Akaike's criterion counts the effective number of independent rows under the noise of the largest model. T0 is averaged over the models that the
//! data do not exclude, with the spread between them in its uncertainty.

mod average;
mod models;
mod standing;

pub use average::ModelAverage;
pub use models::compare;
pub use standing::Standing;

use super::information::information;
use super::{TraceFit, huber};
use crate::statistics::count;

/// The same traces under several models.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// Fits, one for each model that could be fitted, simpler ones first.
    pub fits: Vec<TraceFit>,
    /// Differences of each model's Akaike criterion from the least one.
    pub aicc_differences: Vec<f64>,
    /// Index of the preferred model: the simplest of those whose evidence is within [`Self::SUBSTANTIAL`] of the
    /// best.
    pub preferred: usize,
    /// Number of rows that count as independent, by the residuals of the largest model; never fewer than needed for the comparison.
    pub independent_rows: f64,
}

impl Comparison {
    /// Models whose criterion differs by less explain the data nearly as well; the data cannot distinguish them (Burnham and
    /// Anderson 2002, section 2.6).
    pub const INDISTINGUISHABLE: f64 = 4.0;
    /// Difference beyond which a model has essentially no support (ibidem): a weight of e⁻⁵, or 1 in 148.
    pub const UNSUPPORTED: f64 = 10.0;
    /// Difference from the least criterion below which models have substantial support (ibidem); the simplest of them is preferred.
    pub const SUBSTANTIAL: f64 = 2.0;
    /// Number of its uncertainties beyond which the change of a coefficient is not chance, which exceeds it once in 370 times.
    pub const MOVED: f64 = 3.0;
    /// Number of its uncertainties from zero within which a coefficient counts as zero.
    pub const ZERO: f64 = 2.0;
    /// Difference of the criterion above which a negative coefficient is accepted: a weight of e⁻¹⁰, or 1 in 22 000.
    pub const DECISIVE: f64 = 20.0;

    /// The preferred model's fit.
    #[must_use]
    pub fn best(&self) -> &TraceFit {
        &self.fits[self.preferred]
    }

    /// The criterion, with the penalty for a negative coefficient; infinite for damping that feeds energy.
    fn evidence(&self, index: usize) -> f64 {
        evidence(&self.fits[index], self.aicc_differences[index])
    }

    #[doc(hidden)]
    pub fn new(fits: Vec<TraceFit>, robust: bool) -> Option<Self> {
        let independent_rows = rows_that_count(fits.last()?);
        let scales = fits.iter().map(|fit| huber::scale(&fit.standard_residuals));
        let scale = scales.reduce(f64::min).filter(|&scale| robust && scale > 0.0);
        let information: Vec<f64> =
            fits.iter().map(|fit| information(fit, independent_rows, scale)).collect();
        let least = information.iter().copied().fold(f64::INFINITY, f64::min);
        let aicc_differences: Vec<f64> =
            information.iter().map(|value| if value.is_finite() { value - least } else { *value }).collect();
        let evidence: Vec<f64> =
            fits.iter().zip(&aicc_differences).map(|(fit, excess)| evidence(fit, *excess)).collect();
        let counts: Vec<usize> = fits.iter().map(|fit| fit.damping.count()).collect();
        Some(Self { preferred: simplest(&counts, &evidence), fits, aicc_differences, independent_rows })
    }
}

/// The independent rows of the largest model. If they were fewer than its parameters, the criterion would be infinite for the
/// large models, or for all of them, and the simplest one would be preferred however badly it describes the data. With the
/// smallest number that makes it finite, a further parameter costs about ten times as much as with many rows, so that only a
/// far better fit is preferred.
fn rows_that_count(largest: &TraceFit) -> f64 {
    // The variance of the residuals is a parameter too, and n − k − 1 must be above zero.
    largest.independent_rows.max(count(largest.parameters.len() + 1) + 2.0)
}

fn evidence(fit: &TraceFit, excess: f64) -> f64 {
    match (fit.dissipates(), fit.dissipates_by_each_term()) {
        (false, _) => f64::INFINITY,
        (true, false) => excess + Comparison::DECISIVE,
        (true, true) => excess,
    }
}

/// Index of the simplest model: of those within [`Comparison::SUBSTANTIAL`] of the best one those with the fewest terms, and of these the best.
pub fn simplest(counts: &[usize], evidence: &[f64]) -> usize {
    let least = evidence.iter().copied().fold(f64::INFINITY, f64::min);
    let close = (0..counts.len()).filter(|&index| evidence[index] <= least + Comparison::SUBSTANTIAL);
    let order =
        |&a: &usize, &b: &usize| counts[a].cmp(&counts[b]).then_with(|| evidence[a].total_cmp(&evidence[b]));
    close.min_by(order).unwrap_or(0)
}
