//! The curve through the rows of a recording.

use libration_queries::internals::trace_curve::smooth;

#[test]
fn the_curve_meets_the_rows_and_breaks_at_gaps() {
    let times = [0.0, 0.1, 0.2, 0.3, 1.0, 1.1];
    let values = times.map(|t: f64| t * t);
    let points = smooth(&times, &values);
    assert!(times.iter().all(|time| points.iter().any(|point| (point.0 - time).abs() < 1e-12)));
    let close = |point: &(f64, f64)| point.1.is_nan() || (point.1 - point.0 * point.0).abs() < 1e-9;
    assert!(points.iter().all(close), "{points:?}");
    assert_eq!(points.iter().filter(|point| point.1.is_nan()).count(), 1);
}
