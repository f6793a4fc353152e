//! Uncertainties where the errors of the periods and of the lengths have unknown variances: restricted maximum likelihood of their ratio.
//!
//! A row has the variance σT² + (dT/dh)² σh². For a given ratio of the two, g follows Student's distribution; the ratio itself is known poorly from few
//! rows. Its likelihood therefore weighs the covariances of all ratios, with the differences of their coefficients (Harville, J. Am. Stat. Assoc. 72,
//! 320 (1977), for the likelihood).

use nalgebra::{DMatrix, DVector};

use crate::statistics::count;

/// Shares of the errors of the lengths in the mean variance of the periods, except a share that would leave the smallest period without error.
pub(super) const SHARES: [f64; 11] = [0.0, 0.02, 0.06, 0.15, 0.3, 0.5, 0.7, 0.85, 0.94, 0.98, 0.995];

/// A fit with the weights of one ratio of the variances.
pub(super) struct OfRatio<'a> {
    pub(super) coefficients: &'a [f64],
    /// Covariance for rows with the variances given.
    pub(super) covariance: &'a DMatrix<f64>,
    pub(super) variances: &'a [f64],
    pub(super) chi2: f64,
}

impl OfRatio<'_> {
    /// Logarithm of the restricted likelihood, with the common factor of the variances at its maximum; the same for variances in other units.
    fn log_likelihood(&self) -> f64 {
        let rows = self.variances.len();
        let of_variances: f64 = self.variances.iter().map(|&variance| libm::log(variance)).sum();
        let free = count(rows - self.coefficients.len());
        0.5 * (libm::log(self.covariance.determinant()) - of_variances - free * libm::log(self.chi2))
    }
}

/// Index of the most likely fit, and its covariance in units of its χ² per degree of freedom, with the uncertainty of the ratio; `None` where rows
/// without any deviation have no likelihood.
pub(super) fn most_likely(fits: &[OfRatio<'_>]) -> Option<(usize, DMatrix<f64>)> {
    let likelihoods: Vec<f64> = fits.iter().map(OfRatio::log_likelihood).collect();
    let (index, &largest) =
        likelihoods.iter().enumerate().max_by(|(_, one), (_, other)| one.total_cmp(other))?;
    if !likelihoods.iter().all(|likelihood| likelihood.is_finite()) {
        return None;
    }
    let best = &fits[index];
    let per_dof = best.chi2 / count(best.variances.len() - best.coefficients.len());
    let width = best.coefficients.len();
    let mut sum = DMatrix::zeros(width, width);
    let mut total = 0.0;
    for (fit, likelihood) in fits.iter().zip(&likelihoods) {
        let weight = libm::exp(likelihood - largest);
        let change = DVector::from_fn(width, |k, _| fit.coefficients[k] - best.coefficients[k]);
        sum += (fit.covariance * (fit.chi2 / best.chi2) + &change * change.transpose() / per_dof) * weight;
        total += weight;
    }
    Some((index, sum / total))
}
