//! Outliers, found by a robust scale on which they have no influence.

use super::error::FitError;
use super::law::Law;
use super::period_table::{PeriodTable, Weighting};
use crate::statistics::{deviation_by_median, median};

/// Number of robust standard deviations beyond which a row is an outlier: among normal tables of a thousand rows one in 1700
/// has such a row, and among those of fewer than 24 rows, with [more deviations](find_outliers), one in a hundred.
pub const DEFAULT_OUTLIER_THRESHOLD: f64 = 5.0;

/// Factors of the threshold for three rows and more. With them 5 robust standard deviations become the value that the largest residual of a normal
/// table exceeds in one table in a hundred: by 400 000 tables of each number of rows (200 000 from twelve rows on). The median of few residuals is
/// often very small.
const OF_FEW_ROWS: [f64; 21] = [
    22.7, 3.21, 3.72, 2.0, 2.16, 1.59, 1.65, 1.37, 1.42, 1.27, 1.28, 1.18, 1.19, 1.13, 1.13, 1.09, 1.09,
    1.05, 1.05, 1.02, 1.02,
];

/// The rows, counted from zero, whose distance from the law is more than `threshold` robust standard deviations; in tables of fewer than 24 rows more,
/// as their scatter is less certain: 114 in place of 5 for three rows, 18.6 for five, 6.9 for ten.
///
/// T0 is the median of T/R, and the robust standard deviation that of the residuals by their median absolute
/// value, so that up to half of the rows may be outliers; it is not taken below that of rounding to the last digit. With uncertainties a residual
/// is measured in its own.
///
/// # Errors
/// Fails for a law without a value at one of the amplitudes.
pub fn find_outliers(table: &PeriodTable, law: &Law<'_>, threshold: f64) -> Result<Vec<usize>, FitError> {
    let points = law.points(&table.rows)?;
    let t0 = median(points.iter().map(|point| point.row.period / point.ratio).collect()).unwrap_or(f64::NAN);
    let deviation = |point: &super::law::Point| {
        let residual = (point.row.period - t0 * point.ratio).abs();
        if table.weighting() == Weighting::Scatter { residual } else { residual / point.variance(t0).sqrt() }
    };
    let deviations: Vec<f64> = points.iter().map(deviation).collect();
    let rounding = table.rounding.iter().flatten().copied().fold(0.0, f64::max);
    let rounding = if table.weighting() == Weighting::Scatter { rounding } else { 0.0 };
    let sigma = deviation_by_median(&deviations).map_or(f64::NAN, |sigma| sigma.max(rounding));
    let of_few = table.len().checked_sub(3).and_then(|index| OF_FEW_ROWS.get(index)).unwrap_or(&1.0);
    // With more than half of the rows exactly on the law there is no scale for the others.
    let beyond = |deviation: f64| sigma > 0.0 && deviation > threshold * of_few * sigma;
    Ok((0..deviations.len()).filter(|&row| beyond(deviations[row])).collect())
}
