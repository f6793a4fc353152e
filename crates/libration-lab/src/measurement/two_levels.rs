//! Columns that change between two levels, as the digital output of a light barrier or the voltage of a phototransistor does.

use crate::statistics::count;

/// Fraction of the range at each of its ends that counts as a level. A sine is there in 41 % of its rows.
const LEVEL: f64 = 0.1;
/// Largest fraction of the rows between the levels: of a swing to 179.99°, which stays longest near its ends, 18 % are between ±144°.
const MOST_BETWEEN: f64 = 0.05;
/// Largest number of rows between the levels at each change, on average: a flank of a light barrier has one or two.
const MOST_IN_FLANK: usize = 2;
/// Least number of changes of level: two passages.
const LEAST_CHANGES: usize = 4;

/// Returns `true` if nearly all of the numbers are at one of two levels, which change at least four times.
pub(super) fn changes_between_two_levels(numbers: &[f64]) -> bool {
    let ends = (f64::INFINITY, f64::NEG_INFINITY);
    let (low, high) = numbers.iter().fold(ends, |(low, high), number| (low.min(*number), high.max(*number)));
    let range = high - low;
    if !(range > 0.0 && range.is_finite()) {
        return false;
    }
    let (mut between, mut changes, mut level) = (0_usize, 0_usize, None);
    for number in numbers {
        let next = match (number - low) / range {
            part if part < LEVEL => Some(false),
            part if part > 1.0 - LEVEL => Some(true),
            _ => None,
        };
        between += usize::from(next.is_none());
        changes += usize::from(next.is_some() && level.is_some() && next != level);
        level = next.or(level);
    }
    let are_few = count(between) <= MOST_BETWEEN * count(numbers.len());
    // Levels last for several rows; rows that jump to and fro are a swing that is sampled too seldom.
    let are_levels = numbers.len() >= 4 * changes;
    changes >= LEAST_CHANGES && are_few && are_levels && between <= MOST_IN_FLANK * changes
}
