//! Interpolation that is never much slower than bisection, for functions that are expensive to evaluate.

use super::Tolerance;

/// A point and the value there.
type Point = (f64, f64);

/// A zero of a function between two points, given with the values there, which must have opposite signs; `None` if they do not, and if the
/// function has no value at a point in between. An end at which the function vanishes is the zero.
///
/// The method of Oliveira and Takahashi: interpolation, kept within a shrinking window about the middle. Infinite values are values with a sign.
/// A jump across zero counts as a zero.
///
/// # Accuracy
/// The zero returned is the one of the last two points with the value nearer to zero; these points are as near each other as the tolerance
/// allows, or neighbouring `f64`s. The method needs at most ten evaluations more than bisection; for smooth functions about ten suffice to the
/// last bit.
///
/// # Examples
/// ```
/// # extern crate libration_numbers as libration;
/// use libration::roots::{Tolerance, zero_between};
/// let cubic = |x: f64| x * x * x - 2.0;
/// let zero = zero_between([(0.0, cubic(0.0)), (3.0, cubic(3.0))], Tolerance::LAST_BIT, cubic);
/// assert!(zero.is_some_and(|zero| (zero - 2.0_f64.cbrt()).abs() < 3e-16));
/// assert_eq!(zero_between([(2.0, cubic(2.0)), (3.0, cubic(3.0))], Tolerance::LAST_BIT, cubic), None);
/// ```
///
/// # References
/// I. F. D. Oliveira and R. H. C. Takahashi, ACM TOMS 47, 5 (2021), doi:10.1145/3423597.
pub fn zero_between(ends: [Point; 2], tolerance: Tolerance, mut f: impl FnMut(f64) -> f64) -> Option<f64> {
    let [mut low, mut high] = ends;
    if let Some(end) = ends.iter().find(|end| end.1 == 0.0) {
        return Some(end.0);
    }
    if low.1.is_nan() || high.1.is_nan() || (low.1 > 0.0) == (high.1 > 0.0) {
        return None;
    }
    let mut window = 2.0 * (high.0 - low.0).abs();
    while let Some(x) = next(low, high, window, tolerance) {
        let value = f(x);
        if value.is_nan() {
            return None;
        }
        if value == 0.0 {
            return Some(x);
        }
        *(if (value > 0.0) == (low.1 > 0.0) { &mut low } else { &mut high }) = (x, value);
        window /= 2.0;
    }
    Some(if low.1.abs() < high.1.abs() { low.0 } else { high.0 })
}

/// The next point to evaluate in a bracket that is still too wide; strictly inside, so that the bracket becomes narrower.
fn next(low: Point, high: Point, window: f64, tolerance: Tolerance) -> Option<f64> {
    let ends = [low.0.min(high.0), low.0.max(high.0)];
    let inner = [ends[0].next_up(), ends[1].next_down()];
    let width = tolerance.width(ends);
    if inner[0] > inner[1] || ends[1] - ends[0] <= width || !(ends[1] - ends[0]).is_finite() {
        return None;
    }
    Some(truncated(low, high, window, width).clamp(inner[0], inner[1]))
}

/// The interpolated point, moved towards the middle to a distance that bisection would still allow.
fn truncated(low: Point, high: Point, window: f64, tolerance: f64) -> f64 {
    let middle = f64::midpoint(low.0, high.0);
    let width = high.0 - low.0;
    let interpolated = (high.1 * low.0 - low.1 * high.0) / (high.1 - low.1);
    if !interpolated.is_finite() {
        return middle;
    }
    let towards = (middle - interpolated).signum();
    let shift = (0.2 * width * width / window.abs().max(tolerance)).min((middle - interpolated).abs());
    let truncated = interpolated + towards * shift;
    let radius = (window - width.abs()).max(0.0) / 2.0 + tolerance;
    if (truncated - middle).abs() <= radius { truncated } else { middle - towards * radius }
}
