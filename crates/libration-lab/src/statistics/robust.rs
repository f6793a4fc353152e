//! The median and the spread of numbers some of which may be wrong.

/// The median absolute deviation of a normal distribution is its standard deviation over this.
pub(crate) const NORMAL_PER_MEDIAN_DEVIATION: f64 = 1.482602218505602;

/// The median; `None` for no values.
pub(crate) fn median(mut values: Vec<f64>) -> Option<f64> {
    if values.is_empty() {
        return None;
    }
    let (middle, is_even) = (values.len() / 2, values.len().is_multiple_of(2));
    let (below, &mut upper, _) = values.select_nth_unstable_by(middle, f64::total_cmp);
    let lower = below.iter().copied().max_by(f64::total_cmp).filter(|_| is_even);
    Some(lower.map_or(upper, |lower| f64::midpoint(lower, upper)))
}

/// The median, of an even number of values the lower of the two middle ones; `None` for no values.
pub(crate) fn lower_median(mut values: Vec<f64>) -> Option<f64> {
    let middle = values.len().checked_sub(1)? / 2;
    Some(*values.select_nth_unstable_by(middle, f64::total_cmp).1)
}

/// The standard deviation of residuals by the median of their sizes; `None` for no values.
pub(crate) fn deviation_by_median(residuals: &[f64]) -> Option<f64> {
    let sizes = residuals.iter().map(|x| x.abs()).collect();
    median(sizes).map(|size| NORMAL_PER_MEDIAN_DEVIATION * size)
}

/// The standard deviation of residuals without their outliers; `None` for no values.
pub fn robust_deviation(residuals: &[f64]) -> Option<f64> {
    let first = deviation_by_median(residuals)?;
    let kept = |cut: f64| residuals.iter().filter(move |x| x.abs() <= cut);
    // With more than half of the residuals exactly zero all of them tell the size.
    let cut = if first > 0.0 { 4.0 * first } else { f64::INFINITY };
    let sum: f64 = kept(cut).map(|x| x * x).sum();
    Some((sum / super::count(kept(cut).count())).sqrt())
}
