//! Steps between the values of columns.

/// The smallest step between different values; `None` if all are equal.
pub(super) fn smallest_step(values: &[f64]) -> Option<f64> {
    // Steps below this part of the range are the rounding of a change of unit.
    const ROUNDING: f64 = 1e-12;
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let range = sorted.last()? - sorted.first()?;
    let steps = sorted.windows(2).map(|pair| pair[1] - pair[0]);
    steps.filter(|&step| step > ROUNDING * range).reduce(f64::min)
}
