//! Outliers, found by a robust scale on which they have no influence.

use super::law::Law;
use super::{FitError, PeriodTable, Weighting};
use crate::statistics::{deviation_by_median, median};

/// Beyond five robust standard deviations a row counts as an outlier: among normal tables of a thousand rows
/// one in 1700 has such a row.
pub const DEFAULT_OUTLIER_THRESHOLD: f64 = 5.0;

/// The rows, counted from zero, whose distance from the law is more than `threshold` robust standard deviations.
///
/// T0 is the median of T/R, and the robust standard deviation that of the residuals by their median absolute
/// value, so that up to half of the rows may be outliers. With uncertainties a residual is measured in its own.
///
/// # Errors
/// Fails for a law without a value at one of the amplitudes.
pub fn outliers(table: &PeriodTable, law: &Law<'_>, threshold: f64) -> Result<Vec<usize>, FitError> {
    let points = law.points(&table.rows)?;
    let t0 = median(points.iter().map(|point| point.row.period / point.ratio).collect()).unwrap_or(f64::NAN);
    let deviation = |point: &super::law::Point| {
        let residual = (point.row.period - t0 * point.ratio).abs();
        if table.weighting() == Weighting::Scatter { residual } else { residual / point.variance(t0).sqrt() }
    };
    let deviations: Vec<f64> = points.iter().map(deviation).collect();
    let sigma = deviation_by_median(&deviations).unwrap_or(f64::NAN);
    // With more than half of the rows exactly on the law there is no scale for the others.
    let beyond = |deviation: f64| sigma > 0.0 && deviation > threshold * sigma;
    Ok((0..deviations.len()).filter(|&row| beyond(deviations[row])).collect())
}
