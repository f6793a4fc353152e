//! Bisection, which asks only on which side of the place it is.

use super::Tolerance;

/// The places next to the end of a condition that holds at the first place of a bracket and not at the second, which may be
/// below the first: it holds at the first place returned, and not at the second.
///
/// The condition is not asked at the ends. Where it holds throughout, both places returned are next to the second end, where it
/// holds nowhere, next to the first; where it changes several times, one of the changes is between them.
///
/// # Accuracy
/// The places are as near each other as the tolerance allows, or neighbours among the `f64`s. Each step halves the bracket, so
/// that they are log2(width/tolerance) at most, and at most 2100 to the last bit. A bracket with an end that is not finite is
/// returned as it is.
///
/// # Examples
/// ```
/// # extern crate libration_numbers as libration;
/// use libration::roots::{Tolerance, bisect};
/// let [holds, fails] = bisect([1.0, 2.0], Tolerance::LAST_BIT, |x| x * x <= 2.0);
/// assert!(holds * holds <= 2.0 && fails * fails > 2.0 && fails == holds.next_up());
/// // Coarsely, in ten steps.
/// let [below, above] = bisect([1.0, 2.0], Tolerance::absolute(1e-3), |x| x * x <= 2.0);
/// assert!(above - below <= 1e-3);
/// ```
pub fn bisect(bracket: [f64; 2], tolerance: Tolerance, mut holds: impl FnMut(f64) -> bool) -> [f64; 2] {
    let [mut inside, mut outside] = bracket;
    while let Some(middle) = middle([inside, outside], tolerance) {
        *(if holds(middle) { &mut inside } else { &mut outside }) = middle;
    }
    [inside, outside]
}

/// The middle of a bracket that is still too wide.
fn middle([a, b]: [f64; 2], tolerance: Tolerance) -> Option<f64> {
    let middle = f64::midpoint(a, b);
    let inside = a.min(b) < middle && middle < a.max(b);
    (inside && (b - a).abs() > tolerance.width([a, b])).then_some(middle)
}
