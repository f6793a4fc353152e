//! Fewer points of what could not be seen one by one, with the extremes kept.

/// More points than this on one pair of axes would not be seen.
const MOST: usize = 3000;

/// The points in the order they are given in, of very many the lowest and the highest of each stretch.
pub(super) fn thinned(points: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    if points.len() <= MOST {
        return points;
    }
    points.chunks((2 * points.len()).div_ceil(MOST)).flat_map(extremes).collect()
}

fn extremes(chunk: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let place = |best: fn(f64, f64) -> bool| {
        let better = |best_place: usize, place: usize| {
            if best(chunk[place].1, chunk[best_place].1) { place } else { best_place }
        };
        (0..chunk.len()).reduce(better).unwrap_or(0)
    };
    let (low, high) = (place(|a, b| a < b), place(|a, b| a > b));
    let mut places = vec![low.min(high), low.max(high)];
    places.dedup();
    places.into_iter().map(|place| chunk[place]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn extremes_outlive_the_thinning() {
        let points: Vec<(f64, f64)> =
            (0..100_000_u32).map(|k| (f64::from(k), f64::from((k % 1009) * (k % 1013) % 977))).collect();
        let fewer = thinned(points.clone());
        assert!(fewer.len() <= MOST && fewer.is_sorted_by(|a, b| a.0 < b.0));
        let highest = |points: &[(f64, f64)]| points.iter().fold(0.0, |high: f64, point| high.max(point.1));
        assert_eq!(highest(&fewer).to_bits(), highest(&points).to_bits());
    }
}
