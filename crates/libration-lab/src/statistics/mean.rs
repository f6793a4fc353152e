//! Means.

/// The mean; NaN for no values.
pub(crate) fn mean(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, rows) = values.fold((0.0, 0), |(sum, rows), value| (sum + value, rows + 1));
    sum / super::count(rows)
}

/// The root of the mean square; NaN for no values.
pub(crate) fn root_mean_square(values: impl Iterator<Item = f64>) -> f64 {
    mean(values.map(|value| value * value)).sqrt()
}
