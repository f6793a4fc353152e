//! Repeated readings of the values of a weighted linear fit: the covariance of its coefficients and the test of its χ².
//!
//! The weights are those of the pooled variance. Where the rows scatter differently the covariance C·V·Cᵀ has the variance of each row in V, C being
//! the dependence of the coefficients on the values, and χ² = rᵀWr is compared with its expected value Σaᵢvᵢ, where aᵢ is the diagonal of
//! A = W − WX(XᵀWX)⁻¹XᵀW: an F test with the degrees of freedom (Σaᵢvᵢ)²/tr(AV)² and those of Σaᵢvᵢ after Welch and Satterthwaite. With one pooled
//! variance it is the usual one.
//!
//! Reference: G. E. P. Box, Ann. Math. Stat. 25, 290 (1954), doi:10.1214/aoms/1177728786; M. B. Brown and A. B. Forsythe, Technometrics 16, 129 (1974),
//! doi:10.1080/00401706.1974.10489158.

use nalgebra::DMatrix;

use super::readings::{RepeatedReadings, effective_degrees_of_freedom};
use super::scatter::{ExpectedChi2, Scatter};
use crate::statistics::count;

/// Readings of a fit.
pub(super) struct ReadingsOfFit<'a> {
    readings: &'a RepeatedReadings,
    /// The change of each value with the mean of its readings.
    factors: Vec<f64>,
    columns: &'a DMatrix<f64>,
    variances: &'a [f64],
    /// (XᵀWX)⁻¹.
    covariance: &'a DMatrix<f64>,
}

impl<'a> ReadingsOfFit<'a> {
    /// The readings of a fit with these columns, with these variances as weights; `covariance` is that of the weighted fit.
    pub(super) fn new(
        readings: &'a RepeatedReadings,
        factors: Vec<f64>,
        columns: &'a DMatrix<f64>,
        variances: &'a [f64],
        covariance: &'a DMatrix<f64>,
    ) -> Self {
        Self { readings, factors, columns, variances, covariance }
    }

    /// The covariance of the coefficients.
    pub(super) fn covariance(&self) -> DMatrix<f64> {
        let responses = self.responses();
        let excess =
            DMatrix::from_fn(responses.nrows(), responses.ncols(), |k, i| responses[(k, i)] * self.excess(i));
        self.covariance + excess * responses.transpose()
    }

    /// Degrees of freedom of Σ wₖbₖ, where bₖ are the coefficients, which has this variance.
    pub(super) fn degrees_of_freedom(&self, weights: &[f64], variance: f64) -> f64 {
        let responses = self.responses();
        let of_row = |(i, factor): (usize, &f64)| {
            factor * weights.iter().enumerate().map(|(k, weight)| weight * responses[(k, i)]).sum::<f64>()
        };
        let changes: Vec<f64> = self.factors.iter().enumerate().map(of_row).collect();
        effective_degrees_of_freedom(self.readings, &changes, variance)
    }

    /// The scatter of the rows, with this χ².
    pub(super) fn scatter(&self, chi2: f64, dof: usize) -> Option<Scatter> {
        let rows = self.variances.len();
        let responses = self.responses();
        let variance = |i: usize| self.variances[i] + self.excess(i);
        let spanned = self.columns * responses;
        // A row of A·V.
        let part = |i: usize, j: usize| {
            let unit = if i == j { 1.0 } else { 0.0 };
            (unit - spanned[(i, j)]) / self.variances[i] * variance(j)
        };
        let value: f64 = (0..rows).map(|i| part(i, i)).sum();
        let square: f64 = (0..rows).map(|i| (0..rows).map(|j| part(i, j) * part(j, i)).sum::<f64>()).sum();
        let root = |i: usize| ((1.0 - spanned[(i, i)]).max(0.0) / self.variances[i]).sqrt() * self.factors[i];
        let roots: Vec<f64> = (0..rows).map(root).collect();
        let expected = ExpectedChi2 {
            value,
            degrees_of_freedom: (value * value / square).clamp(1.0, count(dof.max(1))),
            of_value: effective_degrees_of_freedom(self.readings, &roots, value),
        };
        Scatter::new(Some(chi2), dof).map(|scatter| scatter.expected(expected))
    }

    /// The dependence of the coefficients on the values.
    fn responses(&self) -> DMatrix<f64> {
        let weighted = DMatrix::from_fn(self.columns.ncols(), self.columns.nrows(), |k, i| {
            self.columns[(i, k)] / self.variances[i]
        });
        self.covariance * weighted
    }

    /// The variance of a value minus the one used in its weight.
    fn excess(&self, row: usize) -> f64 {
        let reading = &self.readings.rows[row];
        let [separate, pooled] =
            [reading.by_own_scatter, reading.by_scatter].map(|uncertainty| uncertainty * self.factors[row]);
        separate * separate - pooled * pooled
    }
}
