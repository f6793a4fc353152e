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

#[cfg(test)]
mod tests {
    use super::*;

    fn counted(bracket: [f64; 2], tolerance: Tolerance, holds: impl Fn(f64) -> bool) -> ([f64; 2], u32) {
        let mut count = 0;
        let found = bisect(bracket, tolerance, |x| {
            count += 1;
            holds(x)
        });
        (found, count)
    }

    #[test]
    fn neighbours_enclose_the_end_of_a_condition() {
        for end in [-3.25, 0.0, 5e-324, 1e-300, 1.0, 1.5_f64.next_down(), f64::MAX] {
            let ([below, above], count) = counted([-f64::MAX, f64::MAX], Tolerance::LAST_BIT, |x| x < end);
            assert!(below < end && above >= end && below.next_up() >= above, "{end:e}");
            assert!(count <= 2100, "{end:e}: {count}");
            let ([above, below], _) = counted([f64::MAX, -f64::MAX], Tolerance::LAST_BIT, |x| x >= end);
            assert!(below < end && above >= end, "{end:e}");
        }
    }

    #[test]
    fn the_steps_are_as_many_as_the_tolerance_asks_for() {
        let (_, count) = counted([0.0, 1.0], Tolerance::absolute(0.25), |x| x < 0.3);
        assert_eq!(count, 2);
        let ([below, above], count) = counted([0.0, 1e6], Tolerance::relative(1e-10), |x| x < 2.0);
        assert!(above - below <= 1e-10 * above && count < 55, "{count}");
        assert_eq!(counted([1.0, 2.0], Tolerance::absolute(1.0), |_| true).1, 0);
    }

    #[test]
    fn without_a_change_an_end_is_left() {
        let [_, end] = bisect([0.0, 1.0], Tolerance::LAST_BIT, |_| true);
        assert_eq!(end.to_bits(), 1.0_f64.to_bits());
        for start in [0.5, 1.0] {
            let [left, next] = bisect([0.5, start], Tolerance::LAST_BIT, |_| false);
            assert!(left.to_bits() == 0.5_f64.to_bits() && next <= left.next_up(), "{next}");
        }
    }

    #[test]
    fn what_is_not_finite_ends_at_once() {
        assert!(bisect([0.0, f64::INFINITY], Tolerance::relative(1e-3), |_| true)[0].abs() == 0.0);
        assert!(bisect([0.0, f64::NAN], Tolerance::LAST_BIT, |_| true)[1].is_nan());
    }
}
