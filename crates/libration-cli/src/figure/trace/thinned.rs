//! Fewer points of what could not be seen one by one, with the extremes kept.

use crate::output::number::count;

/// More points than this on one pair of axes would not be seen.
const MOST: usize = 3000;

/// The points in the order they are given in, of very many the lowest and the highest of each stretch.
pub(super) fn thinned(points: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    if points.len() <= MOST {
        return points;
    }
    points.chunks((2 * points.len()).div_ceil(MOST)).flat_map(extremes).collect()
}

/// One of so many points, each from another place of its stretch so that no rhythm of the rows shows, and all that are further from zero
/// than four standard deviations, of which chance makes one in 16 000: how the values are distributed is seen as in all of them, which
/// the extremes of each stretch would hide.
pub(super) fn representative(points: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    const FAR: f64 = 4.0;
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let stretch = one_of(points.len());
    if stretch == 1 {
        return points;
    }
    let far = FAR * (points.iter().map(|point| point.1 * point.1).sum::<f64>() / count(points.len())).sqrt();
    let chosen = |number: usize, length: usize| {
        let place = (GOLDEN * count(number)).fract() * count(length);
        (0..length).take_while(|&k| count(k) <= place).count() - 1
    };
    let of_stretch = |(number, chunk): (usize, &[(f64, f64)])| {
        let one = chosen(number, chunk.len());
        let kept = chunk.iter().enumerate().filter(|(k, point)| *k == one || point.1.abs() > far);
        kept.map(|(_, point)| *point).collect::<Vec<_>>()
    };
    points.chunks(stretch).enumerate().flat_map(of_stretch).collect()
}

/// How many points each of those that are shown stands for.
pub(super) fn one_of(points: usize) -> usize {
    points.div_ceil(MOST).max(1)
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

    /// Even numbers from −1 to 1 in an order without a pattern, and one far away: a quarter of those that are shown is in each quarter.
    #[test]
    fn what_is_shown_is_distributed_as_all_are() {
        let spread = |k: u32| 2.0 * (f64::from(k) * 0.754_877_666_246_692_7).fract() - 1.0;
        let mut points: Vec<(f64, f64)> = (0..100_000_u32).map(|k| (f64::from(k), spread(k))).collect();
        points[777].1 = 40.0;
        let shown = representative(points);
        assert!(
            shown.len() <= MOST + 1
                && shown.is_sorted_by(|a, b| a.0 < b.0)
                && shown.iter().any(|it| it.1 > 39.0)
        );
        for quarter in [-1.0, -0.5, 0.0, 0.5] {
            let inside = shown.iter().filter(|it| (quarter..quarter + 0.5).contains(&it.1)).count();
            let part = count(inside) / count(shown.len());
            assert!((part - 0.25).abs() < 0.03, "{quarter}: {part}");
        }
        assert_eq!(representative(vec![(0.0, 1.0); MOST]).len(), MOST);
    }

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
