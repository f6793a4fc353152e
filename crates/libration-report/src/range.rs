//! The ends of axes: the range of the data with some margin.

use crate::chart::Point;

/// The range of the values with some margin on either side.
pub fn around(values: impl IntoIterator<Item = f64>) -> (f64, f64) {
    let finite = values.into_iter().filter(|value| value.is_finite());
    let (low, high) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
    if low > high {
        return (-1.0, 1.0);
    }
    // Values that differ by rounding errors only count as one value.
    let size = low.abs().max(high.abs());
    let room = if high - low > 1e-12 * size { 0.05 * (high - low) } else { 0.1 * size.max(1e-12) };
    (low - room, high + room)
}

/// The same around vertical error bars and values.
pub fn around_bars(points: &[Point], values: &[f64]) -> (f64, f64) {
    let mut all = values.to_vec();
    all.extend(points.iter().flat_map(Point::vertical_ends));
    around(all)
}

/// The powers of ten that enclose the values, with three more below.
pub fn decades(values: impl IntoIterator<Item = f64>) -> (f64, f64) {
    let positive = values.into_iter().filter(|value| *value > 0.0 && value.is_finite());
    let (low, high) = positive.fold((f64::INFINITY, 0.0), |(l, h), v| (v.min(l), v.max(h)));
    if high <= 0.0 {
        // Errors down to a rounding error.
        return (1e-16, 1.0);
    }
    (10f64.powf((low.log10().floor() - 3.0).max(-18.0)), 10f64.powf(high.log10().ceil()))
}
