//! The number in a heading such as `T5`, interpreted by the lengths as that of the swings or of a reading.

use super::gravity::GRAVITY_ON_EARTH;
use std::f64::consts::TAU;

/// Factor within which a table of lengths and periods must give g in each row: two hypotheses whose periods differ by a factor of two or more
/// exclude each other, and an offset of the lengths, amplitudes and reaction times leave g within it.
const WITHIN: f64 = 2.0;

/// The number of swings in each of these times, in seconds, of a pendulum with this length in metres: `number` or one. `None` if both give g far
/// from that on Earth, or if rows contradict each other.
///
/// # Examples
/// ```
/// use libration_lab::fit::swings_of_numbered_time;
///
/// // Five swings of pendulums of 25 cm and 1 m.
/// assert_eq!(swings_of_numbered_time(5.0, &[(0.25, 5.02), (1.0, 10.03)]), Some(5.0));
/// assert_eq!(swings_of_numbered_time(5.0, &[(0.25, 1.00), (1.0, 2.01)]), Some(1.0));
/// assert_eq!(swings_of_numbered_time(5.0, &[(0.25, 2.51), (1.0, 5.01)]), None);
/// ```
#[must_use]
pub fn swings_of_numbered_time(number: f64, rows: &[(f64, f64)]) -> Option<f64> {
    let usual = f64::midpoint(GRAVITY_ON_EARTH[0], GRAVITY_ON_EARTH[1]);
    let explains = |swings: &f64| {
        let gravity = |(length, time): &(f64, f64)| TAU * TAU * length * swings * swings / (time * time);
        !rows.is_empty()
            && rows.iter().map(gravity).all(|value| (usual / WITHIN..usual * WITHIN).contains(&value))
    };
    [number, 1.0].into_iter().find(explains)
}
