//! A curve with a few coefficients through a few points, robust to an outlier among them.

use crate::statistics::{count, least_squares, triangle};
use nalgebra::{DMatrix, DVector};

/// Rounds of weighting: with 4 nothing changed in 24 recordings (`mod.rs`), with 16 one uncertainty, by a tenth.
const ROUNDS: usize = 8;
/// Points further from the curve than so many standard deviations do not count. With 4 β of one recording by an encoder moved by
/// 0.7 uncertainties and one near the top had an outlier; with 9 one uncertainty changed, by an eighth.
const CUT: f64 = 6.0;

/// What is fitted: rows of basis functions, the values, and the standard deviation of each.
#[derive(Clone, Debug)]
pub struct Points {
    /// How many basis functions there are.
    width: usize,
    /// Of each point, one behind the other.
    rows: Vec<f64>,
    values: Vec<f64>,
    deviations: Vec<f64>,
}

/// The curve.
#[derive(Clone, Debug)]
pub struct LocalFit {
    /// Of the curve, in the order of its columns.
    pub coefficients: Vec<f64>,
    /// Of the coefficients, if the standard deviations are right.
    pub(super) covariance: DMatrix<f64>,
    /// Residuals over their standard deviations, enlarged to what they would be without having been fitted.
    pub(super) residuals: Vec<f64>,
}

impl Points {
    /// None yet, of so many basis functions.
    pub fn with_width(width: usize) -> Self {
        Self { width, rows: vec![], values: vec![], deviations: vec![] }
    }

    /// One more, with as many basis functions of these as there are.
    pub fn push(&mut self, row: impl Iterator<Item = f64>, value: f64, deviation: f64) {
        self.rows.extend(row.take(self.width));
        self.values.push(value);
        self.deviations.push(deviation);
    }

    pub(super) fn len(&self) -> usize {
        self.values.len()
    }

    /// The curve by least squares, with points beyond `noise` standard deviations counting less and less; all alike when
    /// the noise is not known yet. Nothing when the points do not determine it.
    pub fn fit(&self, noise: Option<f64>) -> Option<LocalFit> {
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
        let (points, width) = (self.len(), self.width);
        let over = weights.iter().zip(&self.deviations).map(|(weight, deviation)| weight.sqrt() / deviation);
        let over: Vec<f64> = over.collect();
        let mut matrix = DMatrix::zeros(points, width + 1);
        for (column, mut place) in matrix.column_iter_mut().enumerate() {
            for (point, (entry, over)) in place.iter_mut().zip(&over).enumerate() {
                let factor =
                    if column < width { self.rows[point * width + column] } else { self.values[point] };
                *entry = factor * over;
            }
        }
        // As few rows as there are coefficients say the same.
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

/// 1, x, x², … times a factor.
pub fn powers(x: f64, factor: f64) -> impl Iterator<Item = f64> {
    std::iter::successors(Some(factor), move |power| Some(power * x))
}

/// Tukey's weight.
fn bisquare(size: f64) -> f64 {
    if size < 1.0 { (1.0 - size * size) * (1.0 - size * size) } else { 0.0 }
}
