//! Bisection, which needs only the side on which a point lies.

use super::Tolerance;

/// The bracket of the change of a condition that holds at the first end and not at the second; the second end may be below the first. The
/// condition holds at the first point returned, and not at the second.
///
/// The condition is not evaluated at the ends. If it holds throughout, both points returned are next to the second end; if it holds nowhere,
/// next to the first. If it changes several times, one of the changes is between them.
///
/// # Accuracy
/// The points are as near each other as the tolerance allows, or neighbouring `f64`s. Each step halves the bracket, so that there are at most
/// log2(width/tolerance) steps, and at most 2100 to the last bit. A bracket with an end that is not finite is returned unchanged.
///
/// # Examples
/// ```
/// # extern crate libration_numbers as libration;
/// use libration::roots::{Tolerance, bisect};
/// let [holds, fails] = bisect([1.0, 2.0], Tolerance::LAST_BIT, |x| x * x <= 2.0);
/// assert!(holds * holds <= 2.0 && fails * fails > 2.0 && fails == holds.next_up());
/// // A coarse result, in ten steps.
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

/// The middle of a bracket, if it is still too wide.
fn middle([a, b]: [f64; 2], tolerance: Tolerance) -> Option<f64> {
    let middle = f64::midpoint(a, b);
    let inside = a.min(b) < middle && middle < a.max(b);
    (inside && (b - a).abs() > tolerance.width([a, b])).then_some(middle)
}
