//! The fitted motion between the times it was computed at.

/// Points drawn in each interval between two rows, where rows are few.
const PARTS: u32 = 8;
/// An interval that is longer than the usual one by this factor is a gap.
const GAP: f64 = 2.5;

/// The curve by cubics through four neighbours; broken at gaps by a point that is not a number.
pub fn smooth(times: &[f64], values: &[f64]) -> Vec<(f64, f64)> {
    let mut lengths: Vec<f64> = times.windows(2).map(|pair| pair[1] - pair[0]).collect();
    lengths.sort_by(f64::total_cmp);
    let usual = lengths.get(lengths.len() / 2).copied().unwrap_or(0.0);
    let mut points = vec![];
    for row in 0..times.len().saturating_sub(1) {
        let length = times[row + 1] - times[row];
        if length > GAP * usual {
            points.extend([(times[row], values[row]), (times[row] + 0.5 * length, f64::NAN)]);
            continue;
        }
        let from = row.saturating_sub(1).min(times.len().saturating_sub(4));
        let to = times.len().min(from + 4);
        let between = |part: u32| times[row] + length * f64::from(part) / f64::from(PARTS);
        let at = |part| (between(part), cubic(&times[from..to], &values[from..to], between(part)));
        points.extend((0..PARTS).map(at));
    }
    points.extend(times.last().copied().zip(values.last().copied()));
    points
}

/// Lagrange's polynomial through the points.
fn cubic(times: &[f64], values: &[f64], time: f64) -> f64 {
    let weight = |k: usize| -> f64 {
        let others = (0..times.len()).filter(|&other| other != k);
        others.map(|other| (time - times[other]) / (times[k] - times[other])).product()
    };
    (0..times.len()).map(|k| weight(k) * values[k]).sum()
}
