//! Fewer points in place of many.

use libration_queries::internals::number::count;
use libration_queries::internals::trace_thinned::{MOST, representative, thinned};

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
            && shown.iter().any(|point| point.1 > 39.0)
    );
    for quarter in [-1.0, -0.5, 0.0, 0.5] {
        let inside = shown.iter().filter(|point| (quarter..quarter + 0.5).contains(&point.1)).count();
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
