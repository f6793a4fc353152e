//! A curve with a few coefficients through a few points, robust to an outlier among them.

use crate::statistics::{count, weighted_least_squares};
use nalgebra::{DMatrix, DVector};

/// Rounds of weighting: with 4 nothing changed in 24 recordings (`mod.rs`), with 16 one uncertainty, by a tenth.
const ROUNDS: usize = 8;
/// Points further from the curve than so many standard deviations do not count. With 4 β of one recording by an encoder moved by
/// 0.7 uncertainties and one near the top had an outlier; with 9 one uncertainty changed, by an eighth.
const CUT: f64 = 6.0;

/// What is fitted: rows of basis functions, the values, and the standard deviation of each.
#[derive(Clone, Debug, Default)]
pub(super) struct Points {
    pub(super) rows: Vec<Vec<f64>>,
    pub(super) values: Vec<f64>,
    pub(super) deviations: Vec<f64>,
}

/// The curve.
#[derive(Clone, Debug)]
pub(super) struct LocalFit {
    pub(super) coefficients: Vec<f64>,
    /// Of the coefficients, if the standard deviations are right.
    pub(super) covariance: DMatrix<f64>,
    /// Residuals over their standard deviations, enlarged to what they would be without having been fitted.
    pub(super) residuals: Vec<f64>,
}

impl Points {
    pub(super) fn push(&mut self, row: Vec<f64>, value: f64, deviation: f64) {
        self.rows.push(row);
        self.values.push(value);
        self.deviations.push(deviation);
    }

    pub(super) fn len(&self) -> usize {
        self.values.len()
    }

    /// The curve by least squares, with points beyond `noise` standard deviations counting less and less; all alike when
    /// the noise is not known yet. Nothing when the points do not determine it.
    pub(super) fn fit(&self, noise: Option<f64>) -> Option<LocalFit> {
        let mut weights = vec![1.0; self.len()];
        let mut fit = self.weighted(&weights)?;
        let (Some(noise), true) = (noise, self.len() > fit.coefficients.len()) else {
            return Some(fit);
        };
        for round in 0..ROUNDS {
            for (weight, residual) in weights.iter_mut().zip(self.residuals(&fit.coefficients)) {
                // First by the absolute deviation, which an outlier cannot draw far, then without the outliers.
                let size = (residual / noise).abs();
                *weight = if round < ROUNDS / 2 { 1.0 / size.max(1.0) } else { bisquare(size / CUT) };
            }
            match self.weighted(&weights) {
                Some(renewed) => fit = renewed,
                // So many points were left out that the others do not determine the curve.
                None => return Some(fit),
            }
        }
        Some(fit)
    }

    fn weighted(&self, weights: &[f64]) -> Option<LocalFit> {
        let (points, width) = (self.len(), self.rows.first()?.len());
        let matrix = DMatrix::from_fn(points, width, |i, j| self.rows[i][j]);
        let values = DVector::from_column_slice(&self.values);
        let over = weights.iter().zip(&self.deviations).map(|(weight, deviation)| weight.sqrt() / deviation);
        let fit = weighted_least_squares(matrix, values, &over.collect::<Vec<f64>>()).ok()?;
        let coefficients: Vec<f64> = fit.coefficients.iter().copied().collect();
        let spare = points.saturating_sub(width);
        let enlarged = if spare > 0 { (count(points) / count(spare)).sqrt() } else { 0.0 };
        let residuals = self.residuals(&coefficients).into_iter().map(|residual| residual * enlarged);
        Some(LocalFit { residuals: residuals.collect(), covariance: fit.covariance, coefficients })
    }

    fn residuals(&self, coefficients: &[f64]) -> Vec<f64> {
        let fitted = |row: &[f64]| -> f64 { row.iter().zip(coefficients).map(|(x, c)| x * c).sum() };
        let points = self.rows.iter().zip(&self.values).zip(&self.deviations);
        points.map(|((row, value), deviation)| (value - fitted(row)) / deviation).collect()
    }
}

/// Tukey's weight.
fn bisquare(size: f64) -> f64 {
    if size < 1.0 { (1.0 - size * size) * (1.0 - size * size) } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line_with(outlier: f64) -> LocalFit {
        let mut points = Points::default();
        for step in -5..=5 {
            let x = f64::from(step) / 5.0;
            let error = if step == 2 { outlier } else { 0.01 * f64::from(step * step % 3 - 1) };
            points.push(vec![1.0, x], 0.5 + 2.0 * x + error, 0.01);
        }
        points.fit(Some(1.0)).unwrap()
    }

    #[test]
    fn an_outlier_does_not_draw_the_curve() {
        let (clean, spoilt) = (line_with(0.0), line_with(3.0));
        assert!((clean.coefficients[0] - 0.5).abs() < 0.01 && (clean.coefficients[1] - 2.0).abs() < 0.02);
        assert!((clean.coefficients[0] - spoilt.coefficients[0]).abs() < 0.003, "{spoilt:?}");
        assert!((clean.coefficients[1] - spoilt.coefficients[1]).abs() < 0.005, "{spoilt:?}");
    }
}
