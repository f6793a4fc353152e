//! Medians and root mean squares of what the columns hold.

/// The median absolute deviation of a normal distribution is its standard deviation over this.
pub(super) const NORMAL_PER_MEDIAN_DEVIATION: f64 = 1.482602218505602;

/// The middle value, of an even number of values the lower of the two; nothing of none.
pub(in crate::measurement) fn median(mut values: Vec<f64>) -> Option<f64> {
    let middle = values.len().checked_sub(1)? / 2;
    Some(*values.select_nth_unstable_by(middle, f64::total_cmp).1)
}

pub(super) fn mean(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, rows) = values.fold((0.0, 0), |(sum, rows), value| (sum + value, rows + 1));
    sum / number(rows)
}

pub(super) fn root_mean_square(values: impl Iterator<Item = f64>) -> f64 {
    mean(values.map(|value| value * value)).sqrt()
}

/// A number of rows as a float.
#[expect(clippy::cast_precision_loss, reason = "rows are fewer than 2⁵³")]
pub(in crate::measurement) fn number(rows: usize) -> f64 {
    rows as f64
}

/// The smallest step between different values; nothing when all are the same.
pub(super) fn smallest_step(values: &[f64]) -> Option<f64> {
    // Steps below this part of the range are the rounding of a change of unit.
    const ROUNDING: f64 = 1e-12;
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let range = sorted.last()? - sorted.first()?;
    let steps = sorted.windows(2).map(|pair| pair[1] - pair[0]);
    steps.filter(|&step| step > ROUNDING * range).reduce(f64::min)
}
