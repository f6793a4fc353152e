//! A curve with a few coefficients fitted to a few points, robust to an outlier among them.

use crate::statistics::{count, least_squares, triangle};
use nalgebra::{DMatrix, DVector};

/// Rounds of weighting: with 4 nothing changed in 24 recordings (`mod.rs`), with 16 one uncertainty, by a tenth.
const ROUNDS: usize = 8;
/// Distance from the curve, in standard deviations, above which points do not count. With 4 β of one recording by an encoder moved by
/// 0.7 uncertainties and one near the top had an outlier; with 9 one uncertainty changed, by an eighth.
const CUT: f64 = 6.0;

/// Data of a fit: rows of basis functions, the values, and the standard deviation of each.
#[derive(Clone, Debug)]
pub struct Points {
    /// Number of basis functions.
    width: usize,
    /// Basis functions of each point, concatenated.
    rows: Vec<f64>,
    values: Vec<f64>,
    deviations: Vec<f64>,
}

/// The curve.
#[derive(Clone, Debug)]
pub struct LocalFit {
    /// Coefficients of the curve, in the order of its columns.
    pub coefficients: Vec<f64>,
    /// Covariance of the coefficients, if the standard deviations are right.
    pub(super) covariance: DMatrix<f64>,
    /// Residuals over their standard deviations, enlarged to their size had they not been fitted.
    pub(super) residuals: Vec<f64>,
}

impl Points {
    /// Returns an empty set of points with this number of basis functions.
    pub fn with_width(width: usize) -> Self {
        Self { width, rows: vec![], values: vec![], deviations: vec![] }
    }

    /// Adds a point, with its values of the basis functions of the fit.
    pub fn push(&mut self, row: impl Iterator<Item = f64>, value: f64, deviation: f64) {
        self.rows.extend(row.take(self.width));
        self.values.push(value);
        self.deviations.push(deviation);
    }

    pub(super) fn len(&self) -> usize {
        self.values.len()
    }

    /// Fits the curve by least squares; points beyond `noise` standard deviations have falling weights, and all have the same
    /// weight if the noise is not known yet. `None` if the points do not determine the curve.
    pub fn fit(&self, noise: Option<f64>) -> Option<LocalFit> {
        let mut weights = vec![1.0; self.len()];
        let mut fit = self.weighted(&weights)?;
        let (Some(noise), true) = (noise, self.len() > fit.coefficients.len()) else {
            return Some(fit);
        };
        for round in 0..ROUNDS {
            for (weight, residual) in weights.iter_mut().zip(self.residuals(&fit.coefficients)) {
                // First by the absolute deviation, on which an outlier has little influence, then without the outliers.
                let size = (residual / noise).abs();
                *weight = if round < ROUNDS / 2 { 1.0 / size.max(1.0) } else { bisquare(size / CUT) };
            }
            match self.weighted(&weights) {
                Some(renewed) => fit = renewed,
                // The points that are left do not determine the curve.
                None => return Some(fit),
            }
        }
        Some(fit)
    }

    fn weighted(&self, weights: &[f64]) -> Option<LocalFit> {
        let (points, width) = (self.len(), self.width);
        let over = weights.iter().zip(&self.deviations).map(|(weight, deviation)| weight.sqrt() / deviation);
        let over: Vec<f64> = over.collect();
        let mut matrix = DMatrix::zeros(points, width + 1);
        for (column, mut powers) in matrix.column_iter_mut().enumerate() {
            for (point, (entry, over)) in powers.iter_mut().zip(&over).enumerate() {
                let factor =
                    if column < width { self.rows[point * width + column] } else { self.values[point] };
                *entry = factor * over;
            }
        }
        // The triangular factor, with as few rows as there are coefficients and one more, has the same solution.
        let few = triangle(&matrix);
        let values = DVector::from(few.column(width));
        let fit = least_squares(&few.columns(0, width).into_owned(), &values).ok()?;
        let coefficients: Vec<f64> = fit.coefficients.iter().copied().collect();
        let spare = points.saturating_sub(width);
        let enlarged = if spare > 0 { (count(points) / count(spare)).sqrt() } else { 0.0 };
        let residuals = self.residuals(&coefficients).into_iter().map(|residual| residual * enlarged);
        Some(LocalFit { residuals: residuals.collect(), covariance: fit.covariance, coefficients })
    }

    fn residuals(&self, coefficients: &[f64]) -> Vec<f64> {
        let fitted = |row: &[f64]| -> f64 { row.iter().zip(coefficients).map(|(x, c)| x * c).sum() };
        let points = self.rows.chunks_exact(self.width).zip(&self.values).zip(&self.deviations);
        points.map(|((row, value), deviation)| (value - fitted(row)) / deviation).collect()
    }
}

/// Returns 1, x, x², … times a factor.
pub fn powers(x: f64, factor: f64) -> impl Iterator<Item = f64> {
    std::iter::successors(Some(factor), move |power| Some(power * x))
}

/// Tukey's weight.
fn bisquare(size: f64) -> f64 {
    if size < 1.0 { (1.0 - size * size) * (1.0 - size * size) } else { 0.0 }
}
